#include "app/screenshot/command.h"
#include "app/screenshot/output/output.h"
#include "core/base/file_io.h"
#include "core/scene/params/scene_schema.h"

namespace texplorer::screenshot {
namespace {

ExitCode writeSchema(const std::string& path) {
    const Result<Output> output = Output::open(path);
    if (!output)
        return complain(output.error());
    const Result<void> written = output->write(viewBytes(sceneSchema()));
    return written ? success : complain(written.error());
}

} // namespace

void addSchema(CommandLine& line) {
    Command& command = line.command(
        "schema", "The JSON Schema of scenes, for editors that check and explain while one types.");
    auto out = std::make_shared<std::string>("-");
    command.option("-o,--out", *out, "The file to write; - for standard output.",
                   {.value = "FILE", .showsDefault = true});
    command.footer(
        "Draft 2020-12, made of the table of \"texshot params\". A scene that Texplorer writes names it "
        "in its \"$schema\", as the package installs it: share/texplorer/scene.schema.json.\n"
        "Exit status: 0 done, 1 it can't be written, 2 a wrong call.");
    command.onCall([out] { return writeSchema(*out); });
}

} // namespace texplorer::screenshot

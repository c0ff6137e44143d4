#include "app/screenshot/command.h"
#include "app/screenshot/output/output.h"
#include "core/base/file_io.h"
#include "core/scene/params/scene_schema.h"
#include "core/suite/suite.h"

namespace texplorer::screenshot {
namespace {

struct SchemaOptions {
    std::string out = "-";
    bool ofSuites = false;
};

ExitCode writeSchema(const SchemaOptions& options) {
    const Result<Output> output = Output::open(options.out);
    if (!output)
        return complain(output.error());
    const Result<void> written =
        output->write(viewBytes(options.ofSuites ? suite::suiteSchema() : sceneSchema()));
    return written ? success : complain(written.error());
}

} // namespace

void addSchema(CommandLine& line) {
    Command& command = line.command(
        "schema", "The JSON Schema of scenes or suites, for editors that check and explain while one types.");
    auto options = std::make_shared<SchemaOptions>();
    command.flag("--suites", options->ofSuites, "Of the suites that \"texshot test\" draws.");
    command.option("-o,--out", options->out, "The file to write; - for standard output.",
                   {.value = "FILE", .showsDefault = true});
    command.footer(
        "Draft 2020-12, made of the table of \"texshot params\". A scene that Texplorer writes names it "
        "in its \"$schema\", as the package installs it: share/texplorer/scene.schema.json; that of suites, suite.schema.json, lies beside it.\n"
        "Exit status: 0 done, 1 it can't be written, 2 a wrong call.");
    command.onCall([options] { return writeSchema(*options); });
}

} // namespace texplorer::screenshot

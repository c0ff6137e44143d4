#include "app/screenshot/commands/all_commands.h"
#include "app/screenshot/output/message_ids.h"
#include "app/screenshot/output/output.h"
#include "texplorer/files/file_io.h"
#include "texplorer/scene/params/scene_schema.h"
#include "texplorer/suite/suite.h"

namespace texplorer::screenshot {
namespace {

struct SchemaOptions {
    std::string out = "-";
    bool ofSuites = false;
    bool ofOutputs = false;
};

ExitCode writeSchema(const SchemaOptions& options) {
    if (options.ofSuites && options.ofOutputs)
        return complain({ErrorCode::OutOfRange, N_("expected one of --suites and --outputs"),
                         atOption("--suites, --outputs")},
                        wrongCall);
    const Result<Output> output = Output::open(options.out);
    if (!output)
        return complain(output.error());
    const Result<void> written =
        output->write(viewBytes(options.ofOutputs  ? std::string(answerFiles().back().text)
                                : options.ofSuites ? suite::suiteSchema()
                                                   : sceneSchema()));
    return written ? success : complain(written.error());
}

} // namespace

void addSchema(CommandLine& line) {
    Command& command =
        line.command("schema", "Write the JSON Schema of scenes, of suites or of what --json prints.");
    auto options = std::make_shared<SchemaOptions>();
    command.flag("--suites", options->ofSuites, "The schema of the suites of \"texshot test\".");
    command.flag("--outputs", options->ofOutputs, "The schema of what --json prints, of every command.");
    command.option("-o,--out", options->out, "The file to write; - for standard output.",
                   {.value = "FILE", .showsDefault = true});
    command.footer(
        "Draft 2020-12, generated from the table of \"texshot params\". Scenes that Texplorer writes refer "
        "to it in \"$schema\", where the package installs it: share/texplorer/scene.schema.json. "
        "suite.schema.json and output.schema.json are next to it.\n"
        "Exit status: 0 done, 1 it can't be written, 2 invalid arguments.");
    command.onCall([options] { return writeSchema(*options); });
}

} // namespace texplorer::screenshot

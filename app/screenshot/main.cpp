// texshot: the same scenes and the same panels as texplorer, without a display.

#include "app/command_line/help_format.h"
#include "app/command_line/standard_streams.h"
#include "app/command_line/wrong_call.h"
#include "app/screenshot/command.h"
#include "app/screenshot/interrupts.h"
#include "core/base/printable.h"
#include "core/texture/image_budget.h"

#include <cstdio>
#include <new>
#include <sstream>

namespace texplorer::screenshot {

ExitCode complain(const Error& error, ExitCode code) {
    std::fprintf(stderr, "texshot: %s\n", printable(describe(error)).c_str());
    return code;
}

} // namespace texplorer::screenshot

int main(int argc, char** argv) {
    using namespace texplorer;
    using namespace texplorer::screenshot;

    prepareStandardStreams();
    watchInterrupts();
    CLI::App app("Texplorer without a display: draw scenes, look into texture files.", "texshot");
    app.formatter(std::make_shared<HelpFormatter>());
    app.set_version_flag("--version", "texshot " TEXPLORER_VERSION);
    app.require_subcommand(1);
    app.footer(
        "The images of a scene may take " + sceneImageBytesText() +
        " together once they are decoded; a file that several textures name counts once.\n"
        "Exit status: 0 done, 1 it failed (one sentence on standard error says why), 2 a wrong call, "
        "130 ended by Ctrl+C, 143 by SIGTERM, 129 by SIGHUP.\nA file appears as a whole or not at all.\n"
        "\"texshot COMMAND --help\" explains each command.");

    Action action;
    for (const auto add : {addShot, addProbe, addCheck, addConform, addParams, addDecode, addInfo, addConvert,
                           addFlip, addCompress})
        add(app, action);

    // CLI11 would say only that a subcommand is missing.
    std::string names;
    bool known = argc > 1 && app.get_option_no_throw(argv[1]) != nullptr;
    for (const CLI::App* command : app.get_subcommands(nullptr)) {
        known = known || (argc > 1 && command->get_name() == argv[1]);
        names.append(names.empty() ? "" : ", ").append(command->get_name());
    }
    if (!known) {
        const std::string found =
            argc > 1 ? "there is no command \"" + std::string(argv[1]) + "\"; " : "a command is missing; ";
        return complain({ErrorCode::OutOfRange, found + "expected one of " + names, {}}, wrongCall);
    }

    try {
        app.parse(argc, argv);
        return action();
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) { // --help, --version
            std::ostringstream text;
            app.exit(error, text);
            const Result<void> printed = print(text.str());
            return printed ? success : complain(printed.error());
        }
        return complain({ErrorCode::OutOfRange, describeWrongCall(app, error), {}}, wrongCall);
    } catch (const std::bad_alloc&) {
        std::fputs("texshot: there is not enough memory for this\n", stderr);
        return failure;
    } catch (const std::exception& error) { // still one sentence and an exit status
        return complain({ErrorCode::Unsupported, error.what(), {}});
    }
}

// texshot: the same scenes and the same panels as texplorer, without a display.

#include "app/command_line/wrong_call.h"
#include "app/screenshot/command.h"
#include "app/screenshot/help_format.h"
#include "core/base/file_io.h"

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace texplorer::screenshot {

ExitCode complain(const Error& error, ExitCode code) {
    std::fprintf(stderr, "texshot: %s\n", describe(error).c_str());
    return code;
}

ExitCode complainInterrupted() {
    return complain({ErrorCode::Cancelled, "interrupted; nothing was written", {}}, interrupted);
}

Result<void> writeOutput(const std::string& path, ByteView bytes) {
    if (path != "-")
        return writeFileAtomically(path, bytes);
    if (std::fwrite(bytes.data(), 1, bytes.size(), stdout) != bytes.size() || std::fflush(stdout) != 0)
        return fail(ErrorCode::Unwritable, std::string("can't write: ") + std::strerror(errno),
                    "standard output");
    return {};
}

} // namespace texplorer::screenshot

int main(int argc, char** argv) {
    using namespace texplorer;
    using namespace texplorer::screenshot;

    CLI::App app("Texplorer without a display: draw scenes, look into texture files.", "texshot");
    app.formatter(std::make_shared<HelpFormatter>());
    app.set_version_flag("--version", "texshot " TEXPLORER_VERSION);
    app.require_subcommand(1);
    app.footer("Exit status: 0 done, 1 it failed (one sentence on standard error says why), 2 a wrong call,\n"
               "130 interrupted by Ctrl+C: nothing was written.\n"
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
        if (error.get_exit_code() == 0) // --help, --version
            return app.exit(error) == 0 ? success : failure;
        return complain({ErrorCode::OutOfRange, describeWrongCall(app, error), {}}, wrongCall);
    } catch (const std::exception& error) { // out of memory, at worst: still one sentence and an exit status
        std::fprintf(stderr, "texshot: %s\n", error.what());
        return failure;
    }
}

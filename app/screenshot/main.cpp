// texshot: the same scenes and the same panels as texplorer, without a display.

#include "app/command_line/standard_streams.h"
#include "app/screenshot/command.h"
#include "app/screenshot/gl/driver_crash.h"
#include "app/screenshot/gl/driver_question.h"
#include "app/screenshot/output/interrupts.h"
#include "app/screenshot/output/messages.h"
#include "app/screenshot/runs/case_worker.h"
#include "app/screenshot/workers/work_loop.h"
#include "core/base/printable.h"
#include "core/texture/image_budget.h"

#include <fmt/core.h>

#include <chrono>
#include <cstdio>
#include <new>
#include <vector>

namespace texplorer::screenshot {

ExitCode complain(const Error& error, ExitCode code) {
    std::fprintf(stderr, "texshot: %s\n", printable(describe(error)).c_str());
    return code;
}

namespace {

/// The commands under the titles that they have in --help.
struct CommandGroup {
    const char* title;
    std::vector<void (*)(CommandLine&)> commands;
};

const std::vector<CommandGroup> groups{
    {"Draw", {addShot, addSweep, addAnimate, addProbe, addTexture, addCommands, addEmit}},
    {"Compare", {addTest, addMerge, addCompare, addConform, addDiff}},
    {"Scenes", {addScene, addCheck, addParams, addPresets, addLessons, addSchema}},
    {"Images", {addInfo, addValidate, addDecode, addConvert, addFlip, addCompress}},
    {"About", {addDrivers}},
};

} // namespace
} // namespace texplorer::screenshot

int main(int argc, char** argv) {
    using namespace texplorer;
    using namespace texplorer::screenshot;
    const auto start = std::chrono::steady_clock::now();

    prepareStandardStreams();
    if (const std::optional<int> answered = answerQuestions(argc, argv))
        return *answered;
    if (const std::optional<int> socket = workers::workerSocket(argc, argv)) {
        CaseWorker worker;
        workers::workLoop(*socket, [&worker](const std::string& order) { return worker.work(order); });
        return success;
    }
    sayCrashes();
    watchInterrupts();
    CommandLine line("texshot", TEXPLORER_VERSION,
                     "Texplorer without a display: draw scenes, look into texture files.");
    line.footer(fmt::format(
        "The images of a scene may take {} together once they are decoded; a file that several textures name "
        "counts once.\n"
        "Exit status: 0 done, 1 it failed (one sentence on standard error says why), 2 a wrong call, "
        "130 ended by Ctrl+C, 143 by SIGTERM, 129 by SIGHUP.\n"
        "A file appears as a whole or not at all.\n"
        "\"texshot help COMMAND\" explains each command.",
        sceneImageBytesText()));
    line.everywhere("--quiet", loudness().quiet,
                    "No warnings, notes and progress on standard error; errors stay.");
    line.everywhere("--verbose", loudness().verbose,
                    "Say on standard error what is done: files with their sizes, the driver, the time.",
                    "--quiet");
    for (const auto& [title, commands] : groups) {
        line.group(title);
        for (const auto add : commands)
            add(line);
    }
    line.addHelp();
    addHelpSections(line);
    line.addWords();

    try {
        const Result<std::optional<std::string>> answer = line.parse(argc, argv);
        if (!answer)
            return complain(answer.error(), wrongCall);
        if (!*answer) {
            const int status = line.run();
            const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
            tell(fmt::format("took {:.3f} s", time.count()));
            return status;
        }
        const Result<void> printed = print(**answer);
        return printed ? success : complain(printed.error());
    } catch (const std::bad_alloc&) {
        std::fputs("texshot: there is not enough memory for this\n", stderr);
        return failure;
    } catch (const std::exception& error) { // still one sentence and an exit status
        return complain({ErrorCode::Unsupported, error.what(), {}});
    }
}

// texshot: the same scenes and the same panels as texplorer, without a display.

#include "app/command_line/standard_streams.h"
#include "app/screenshot/commands/all_commands.h"
#include "app/screenshot/gl/driver_crash.h"
#include "app/screenshot/gl/driver_question.h"
#include "app/screenshot/output/interrupts.h"
#include "app/screenshot/output/json_text.h"
#include "app/screenshot/output/messages.h"
#include "app/screenshot/output/output.h"
#include "app/screenshot/runs/case_worker.h"
#include "app/screenshot/workers/work_loop.h"
#include "texplorer/base/sentence_format.h"
#include "texplorer/base/thrown.h"
#include "texplorer/texture/image_budget.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <new>
#include <span>
#include <string>
#include <vector>

namespace texplorer::screenshot {
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
    {"About", {addDrivers, addCost}},
};

/// The command that a call names, as far as one sees before the line is understood; nullptr: none.
const Command* namedCommand(const CommandLine& line, std::span<const std::string> words) {
    const auto name = std::ranges::find_if(words, [](const auto& word) { return !word.starts_with("-"); });
    const auto command =
        name == words.end()
            ? line.commands().end()
            : std::ranges::find_if(line.commands(), [&](const auto& each) { return each->name() == *name; });
    return command == line.commands().end() ? nullptr : command->get();
}

/// Whether a file is named for the JSON.
bool takesFileForJson(const Command& command) {
    const auto json = std::ranges::find(command.options(), std::string("--json"), &Option::name);
    return json != command.options().end() && !json->isFlag();
}

/// Whether the answer is to be JSON on standard output. A call that is wrong gets an answer, too, so this is
/// seen before the line is understood.
bool asksForJson(const Command* command, std::span<const std::string> words) {
    const auto given = std::ranges::find_if(
        words, [](const auto& word) { return word == "--json" || word.starts_with("--json="); });
    if (given == words.end() || std::find(words.begin(), given, "--") != given)
        return false;
    if (command == nullptr || !takesFileForJson(*command))
        return true;
    if (const std::size_t sign = given->find('='); sign != std::string::npos)
        return isStandardOutput(given->substr(sign + 1));
    return given + 1 == words.end() || isStandardOutput(*(given + 1));
}

int perform(CommandLine& line, int argc, char** argv, std::chrono::steady_clock::time_point start) {
    const Result<std::optional<std::string>> answer = line.parse(argc, argv);
    if (!answer)
        return complain(answer.error(), wrongCall);
    if (*answer) {
        const Result<void> printed = print(**answer);
        return printed ? success : complain(printed.error());
    }
    const int status = line.run();
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    tell(fmt::format("took {:.3f} s", time.count()));
    return status;
}

} // namespace
} // namespace texplorer::screenshot

int main(int argc, char** argv) {
    using namespace texplorer;
    using namespace texplorer::screenshot;
    const auto start = std::chrono::steady_clock::now();

    prepareStandardStreams();
    sayWhatNothingCatches("texshot");
    if (const std::optional<int> answered = answerQuestions(argc, argv))
        return *answered;
    if (const std::optional<int> socket = workers::workerSocket(argc, argv)) {
        CaseWorker worker;
        workers::workLoop(*socket, [&worker](const std::string& order) { return worker.work(order); });
        return success;
    }
    sayCrashes();
    CommandLine line("texshot", TEXPLORER_VERSION,
                     "Texplorer without a display: draw scenes, inspect texture files.");
    line.footer(fmt::format(
        "The decoded images of a scene may take {} together; a file used by several textures counts once.\n"
        "Exit status: 0 done, 1 it failed (with one sentence on standard error), 2 invalid arguments, 130 "
        "ended by Ctrl+C, 143 by SIGTERM, 129 by SIGHUP.\n"
        "Files are written completely or not at all, missing folders are created, and no output may "
        "overwrite an input or another output.\n"
        "An option without effect gets a note. --json prints one document: texshot (its version), schema, "
        "command, results, and problems, the errors on standard error: id, message, arguments, where and code. An id "
        "stays when the words of its message change.\n"
        "\"texshot help COMMAND\" explains each command.",
        sceneImageBytesText()));
    line.everywhere("--quiet", loudness().quiet,
                    "Don't print warnings, notes and progress on standard error; errors are printed.");
    line.everywhere("--verbose", loudness().verbose,
                    "Print the files with their sizes, the driver and the time on standard error.",
                    "--quiet");
    for (const auto& [title, commands] : groups) {
        line.group(title);
        for (const auto add : commands)
            add(line);
    }
    line.addHelp();
    addHelpSections(line);
    line.addWords();

    const std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
    const Command* command = namedCommand(line, words);
    noteCommand(command ? command->name() : "");
    if (asksForJson(command, words))
        expectDocument();
    watchInterrupts();
    int status = failure;
    try {
        status = perform(line, argc, argv, start);
    } catch (const std::bad_alloc&) {
        complain({ErrorCode::TooLarge, N_("not enough memory for this"), {}});
    } catch (const std::exception& error) { // still one sentence and an exit status
        complain({ErrorCode::Unsupported, reasonOf(error), {}});
    }
    if (status != success)
        printProblems();
    ignoreInterrupts();
    return status;
}

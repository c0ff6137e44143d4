// texplorer_soak: runs random trials in child processes until one fails.

#include "app/command_line/command_line.h"
#include "tests/random/scene_soak.h"
#include "tests/random/window_soak.h"

#include <cstdio>
#include <limits>

namespace {

using namespace texplorer;

constexpr int failure = 1;
constexpr int wrongCall = 2;
constexpr int many = std::numeric_limits<int>::max();

int complain(const std::string& sentence) {
    std::fprintf(stderr, "texplorer_soak: %s\n", sentence.c_str());
    return failure;
}

struct Call {
    unsigned seed = 1;
    random::SoakOptions options;

    int run(const random::Subject& subject) const {
        const random::SoakReport report = random::soak(subject, options);
        std::fputs(report.text().c_str(), stdout);
        return report.failures.empty() ? 0 : failure;
    }
};

Command& subject(CommandLine& line, Call& call, const char* name, const char* help) {
    Command& command = line.command(name, help);
    command.number("--count", call.options.count, 1, many, "How many.", {.showsDefault = true});
    command.number("--seed", call.seed, 0, std::numeric_limits<unsigned>::max(),
                   "Others; the same number gives the same ones.", {.showsDefault = true});
    command.number("--first", call.options.first, 0, many, "The number of the first one.",
                   {.showsDefault = true});
    command.number("--jobs", call.options.jobs, 0, 1024,
                   "Processes at a time; 0: as many as the processor has.", {.showsDefault = true});
    return command;
}

} // namespace

int main(int argc, char** argv) {
    CommandLine line("texplorer_soak", TEXPLORER_VERSION,
                     "Runs random trials in child processes until one fails.");
    line.footer("Exit status: 0 no trial failed, 1 some failed, 2 a wrong call.");
    try {
        Call scenes{.options = {.count = 2000, .command = argv[0]}};
        std::string keep = "soak";
        std::string shaders;
        Command& scenesCommand =
            subject(line, scenes, "scenes", "Draws, diagnoses and probes random scenes.");
        scenesCommand.option("--keep", keep,
                             "The folder for the files that the scenes name and for the scenes that fail.",
                             {.value = "DIR", .showsDefault = true});
        scenesCommand.option(
            "--shaders", shaders,
            "The folder of the shader renderer's files. Without it: those that it was built with.",
            {.value = "DIR"});
        scenesCommand.onCall([&] { return scenes.run(random::randomScenes({scenes.seed, keep, shaders})); });

        Call window{.options = {.count = 300, .command = argv[0]}};
        subject(line, window, "window", "Sends random mouse and keyboard input to the window.").onCall([&] {
            return window.run(random::randomHands(window.seed));
        });

        Call layouts{.options = {.count = random::layoutCount(), .command = argv[0]}};
        subject(line, layouts, "layouts",
                "Draws the window in every size and scale, with every tab, view and width of its columns.")
            .onCall([&] { return layouts.run(random::layouts(layouts.seed)); });

        random::SceneFiles files;
        Command& write =
            line.command("write", "Writes random scenes as files, for those who read such files.");
        write.option("DIR", files.folder, "Where to.", {.required = true});
        write.number("--count", files.count, 1, many, "How many.", {.showsDefault = true});
        write.number("--seed", files.seed, 0, std::numeric_limits<unsigned>::max(),
                     "Others; the same number gives the same ones.", {.showsDefault = true});
        write.flag("--tame", files.tame,
                   "Without numbers at their limits and without anisotropy: what llvmpipe survives.");
        write.onCall([&] {
            const Result<void> written = random::writeScenes(files);
            return written ? 0 : complain(describe(written.error()));
        });

        const Result<std::optional<std::string>> answer = line.parse(argc, argv);
        if (!answer) {
            complain(describe(answer.error()));
            return wrongCall;
        }
        if (*answer) {
            std::fputs((*answer)->c_str(), stdout);
            return 0;
        }
        return line.run();
    } catch (const std::exception& error) {
        return complain(error.what());
    }
}

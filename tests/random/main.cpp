// texplorer_soak: draws, diagnoses and probes random scenes in child processes until something gives way.

#include "app/command_line/command_line.h"
#include "tests/random/soak.h"

#include <cstdio>
#include <limits>

namespace {

constexpr int failure = 1;
constexpr int wrongCall = 2;
constexpr int many = std::numeric_limits<int>::max();

int complain(const char* sentence) {
    std::fprintf(stderr, "texplorer_soak: %s\n", sentence);
    return failure;
}

} // namespace

int main(int argc, char** argv) {
    using namespace texplorer;
    random::SoakOptions options;
    options.command = argv[0];
    std::string keep = "soak";
    std::string shaders;
    CommandLine line("texplorer_soak", TEXPLORER_VERSION,
                     "Draws, diagnoses and probes random scenes in child processes.");
    line.number("--count", options.count, 1, many, "How many scenes.", {.showsDefault = true});
    line.number("--seed", options.seed, 0, std::numeric_limits<unsigned>::max(),
                "Other scenes; the same number gives the same ones.", {.showsDefault = true});
    line.number("--first", options.first, 0, many, "The number of the first one.", {.showsDefault = true});
    line.number("--jobs", options.jobs, 0, 1024, "Processes at a time; 0: as many as the processor has.",
                {.showsDefault = true});
    line.option("--keep", keep, "The folder for the files that the scenes name and for the scenes that fail.",
                {.value = "DIR", .showsDefault = true});
    line.option("--shaders", shaders,
                "The folder of the shader renderer's files. Without it: those that it was built with.",
                {.value = "DIR"});
    line.footer("Exit status: 0 nothing gave way, 1 something did, 2 a wrong call.");
    try {
        const Result<std::optional<std::string>> answer = line.parse(argc, argv);
        if (!answer) {
            complain(describe(answer.error()).c_str());
            return wrongCall;
        }
        if (*answer) {
            std::fputs((*answer)->c_str(), stdout);
            return 0;
        }
        options.keep = keep;
        options.shaders = shaders;
        const random::SoakReport report = random::soak(options);
        std::fputs(report.text().c_str(), stdout);
        return report.failures.empty() ? 0 : 1;
    } catch (const std::exception& error) {
        return complain(error.what());
    }
}

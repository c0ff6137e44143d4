// texplorer_soak: draws, diagnoses and probes random scenes in child processes until something gives way.

#include "tests/random/soak.h"

#include <CLI/CLI.hpp>

#include <cstdio>

int main(int argc, char** argv) {
    using namespace texplorer::random;
    CLI::App app("Draws, diagnoses and probes random scenes in child processes.", "texplorer_soak");
    SoakOptions options;
    options.command = argv[0];
    options.keep = "soak";
    app.add_option("--count", options.count, "How many scenes.")
        ->capture_default_str()
        ->check(CLI::PositiveNumber);
    app.add_option("--seed", options.seed, "Other scenes; the same number gives the same ones.")
        ->capture_default_str();
    app.add_option("--first", options.first, "The number of the first one.")
        ->capture_default_str()
        ->check(CLI::NonNegativeNumber);
    app.add_option("--jobs", options.jobs, "Processes at a time; 0: as many as the processor has.")
        ->capture_default_str();
    app.add_option("--keep", options.keep,
                   "The folder for the files that the scenes name and for the scenes that fail.")
        ->capture_default_str();
    app.add_option("--shaders", options.shaders,
                   "The folder of the shader renderer's files. Without it: those that it was built with.");
    CLI11_PARSE(app, argc, argv);
    try {
        const SoakReport report = soak(options);
        std::fputs(report.text().c_str(), stdout);
        return report.failures.empty() ? 0 : 1;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "texplorer_soak: %s\n", error.what());
        return 1;
    }
}

#pragma once

// Random scenes by the thousand: what they did to Texplorer, and how to see it again.

#include "tests/random/batches.h"

#include <filesystem>
#include <map>
#include <string>

namespace texplorer::random {

struct SoakOptions {
    unsigned seed = 1;
    int first = 0;
    int count = 2000;
    unsigned jobs = 0;             ///< 0: as many as the processor has
    std::filesystem::path keep;    ///< where the scenes that failed are kept, with the files that they name
    std::filesystem::path shaders; ///< of the shader renderer; empty: the built-in ones
    std::string command;           ///< of this program, for the command that repeats a failure
};

struct SoakReport {
    int scenes = 0;
    std::map<std::string, int> agreed;  ///< comparisons, by the pair
    std::map<std::string, int> skipped; ///< by the pair and the name of the skip
    int blank = 0;                      ///< pictures of one colour, by which nothing is told
    std::string failures;               ///< what went wrong, scene by scene; empty: nothing

    [[nodiscard]] std::string text() const;
};

/// Scenes are tried in batches, one with Mesa's shortcuts and one without in turn. Each that fails is kept as
/// JSON. Throws std::exception where it can't begin.
[[nodiscard]] SoakReport soak(const SoakOptions& options);

} // namespace texplorer::random

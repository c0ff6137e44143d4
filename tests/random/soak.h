#pragma once

// Runs numbered trials in child processes. Reports failures and the command that repeats them.

#include "tests/random/batches.h"

#include <map>
#include <string>

namespace texplorer::random {

/// The subject of the trials. A number gives the same trial on every machine.
struct Subject {
    std::string one;                           ///< "scene"
    std::string many;                          ///< "random scenes"
    std::string arguments;                     ///< of texplorer_soak, except those that choose the numbers
    int batch = 1;                             ///< numbers that run in one process
    unsigned limitSeconds = 600;               ///< of a step, as in Batches
    unsigned long long memoryLimit = 0;        ///< of a process, as in Batches
    std::function<Work(int first)> open = {};  ///< as in runBatches
    std::function<void(int number)> keep = {}; ///< called for each that failed; may throw
};

struct SoakOptions {
    int first = 0;
    int count = 1;
    unsigned jobs = 0;   ///< 0: the number of processors
    std::string command; ///< of this program, for the command that repeats a failure
};

struct SoakReport {
    std::string things; ///< "random scenes"
    int count = 0;
    std::map<std::string, int> agreed;  ///< comparisons, by the pair
    std::map<std::string, int> skipped; ///< by the pair and the name of the skip
    int blank = 0;                      ///< pictures of one colour, which test nothing
    std::string failures;               ///< the failures, one by one; empty: none

    [[nodiscard]] std::string text() const;
};

/// Throws std::exception if it cannot start.
[[nodiscard]] SoakReport soak(const Subject& subject, const SoakOptions& options);

} // namespace texplorer::random

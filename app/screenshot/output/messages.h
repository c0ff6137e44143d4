#pragma once

#include "texplorer/base/result.h"

#include <string>

namespace texplorer::screenshot {

/// How much is said on standard error beside errors, which always are: --quiet and --verbose.
struct Loudness {
    bool quiet = false;   ///< no warnings, no notes, no progress
    bool verbose = false; ///< what is done, too
};

/// The program's, which main() sets.
[[nodiscard]] Loudness& loudness();

/// Prints "texshot: …" on standard error, a printable line.
void say(const Error& sentence);

/// What one should know though it isn't an error.
void warn(const Error& note);

/// What was done, for who asked for it: "read brick.dds, 1024 bytes".
void tell(const std::string& deed);

} // namespace texplorer::screenshot

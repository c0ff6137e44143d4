#pragma once

#include "app/screenshot/command.h"

#include <cstdlib>
#include <string>

namespace texplorer::screenshot {

/// Whether the command line itself has the option: what an environment variable says may go unused.
[[nodiscard]] inline bool isGiven(const CLI::Option& option) {
    if (option.count() == 0)
        return false;
    const char* environment =
        option.get_envname().empty() ? nullptr : std::getenv(option.get_envname().c_str()); // NOLINT
    return environment == nullptr || option.results().front() != environment;
}

/// An option that changes nothing is a mistake about what it does. `why`: "it is for TGA files".
inline ExitCode refuseUnused(const std::string& option, const std::string& why) {
    return complain({ErrorCode::OutOfRange, "has no effect here: " + why, option}, wrongCall);
}

} // namespace texplorer::screenshot

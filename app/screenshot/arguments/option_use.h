#pragma once

#include "app/screenshot/command.h"

#include <string>

namespace texplorer::screenshot {

/// An option that changes nothing is a mistake about what it does. `why`: "it is for TGA files".
inline ExitCode refuseUnused(const std::string& option, const std::string& why) {
    return complain({ErrorCode::OutOfRange, "has no effect here: " + why, option}, wrongCall);
}

} // namespace texplorer::screenshot

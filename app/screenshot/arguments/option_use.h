#pragma once

#include "app/screenshot/command.h"
#include "core/base/result.h"

#include <string>

namespace texplorer::screenshot {

/// An option that changes nothing is a mistake about what it does. `why`: "it is for TGA files".
[[nodiscard]] inline tl::unexpected<Error> unusedOption(const std::string& option, const std::string& why) {
    return fail(ErrorCode::OutOfRange, "has no effect here: " + why, option);
}

/// The same, said.
inline ExitCode refuseUnused(const std::string& option, const std::string& why) {
    return complain(unusedOption(option, why).value(), wrongCall);
}

} // namespace texplorer::screenshot

#pragma once

#include "app/screenshot/output/messages.h"
#include "texplorer/base/result.h"

#include <string>

namespace texplorer::screenshot {

/// An option that changes nothing here gets a note and is no error, so that a loop over renderers or formats
/// goes on. `why`: "it applies to TGA files only". What can't be done as it was asked for is an error of its
/// own.
inline void noteUnused(const std::string& option, const std::string& why) {
    warn({ErrorCode::OutOfRange, Sentence("has no effect here: {0}", why), atOption(option)});
}

/// What prints its answer for programs can't write a picture there, too.
[[nodiscard]] inline tl::unexpected<Error> standardOutputIsTaken(const std::string& option) {
    return fail(ErrorCode::OutOfRange, "standard output can have the picture or the JSON, not both",
                atOption(option));
}

} // namespace texplorer::screenshot

#pragma once

#include "texplorer/base/result.h"
#include "texplorer/scene/scene.h"

#include <string>
#include <vector>

namespace texplorer::screenshot {

/// Takes those out of --set's assignments that may be moves: PATH=A..B, PATH=A..B..C, PATH=*.
[[nodiscard]] std::vector<std::string> takeMoves(std::vector<std::string>& assignments);

/// When the parameters that a command line moves do so.
struct MoveTimes {
    double begin = 0;               ///< seconds
    double seconds = 1;             ///< the value behind the last ".." is reached at the end
    Easing easing = Easing::Linear; ///< from each value to the next
};

/// Makes key frames of such an assignment, in the place of those that the parameter has: numbers go from each
/// value to the next, evenly spread over the length; what has nothing in between is each of them for an equal
/// part of it. A text that only has two dots in it is set as --set does. The error names the path.
[[nodiscard]] Result<void> putMove(Scene& scene, const std::string& assignment, const MoveTimes& times);

} // namespace texplorer::screenshot

#pragma once

// An axis of a sheet of pictures: a parameter with several values, while all others stay.

#include "texplorer/base/result.h"
#include "texplorer/scene/params/params.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace texplorer {

struct SweepAxis {
    std::string path;                ///< "textures[0].minFilter"
    std::vector<std::string> values; ///< as written by formatValue, without repeats

    bool operator==(const SweepAxis&) const = default;
};

/// "minFilter" of "textures[0].minFilter".
[[nodiscard]] constexpr std::string_view keyOfPath(std::string_view path) {
    return path.substr(path.rfind('.') + 1);
}

inline constexpr std::size_t maxAxisValues = 256;

/// Whether values of this kind can be enumerated: choices, booleans, numbers, vectors, colours.
[[nodiscard]] bool canSweep(const ParamRow& row);

/// Parses "PATH=VALUES", see sweepAxis; but a repeated value is an error. The error's `where` is the path.
[[nodiscard]] Result<SweepAxis> parseSweepAxis(const Scene& scene, std::string_view text);

/// Parses the values of a parameter of the scene, or of an element of a list: "GL_NEAREST,GL_LINEAR",
/// "1,2,4"; vectors, colours and coordinates separated by semicolons, "1,0,0,1;0,1,0,1". "0..4/5" is five
/// numbers from 0 to 4, inclusive, rounded if the parameter is a whole number; without "/5", five. "*" is all
/// values of a choice, or a few of a number (suggestedValues). Repeats are left out.
[[nodiscard]] Result<SweepAxis> sweepAxis(const Scene& scene, std::string_view path, std::string_view values);

/// Useful values to start with: every choice; for a number with few steps five across its range, which double
/// if the range begins above 0; for one with many steps five around the current value. Can be empty.
[[nodiscard]] std::vector<std::string> suggestedValues(const ParamRow& row, const Value& current);

} // namespace texplorer

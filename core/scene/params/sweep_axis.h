#pragma once

// The values that a parameter goes through while everything else stays: an axis of a sheet of pictures.

#include "core/base/result.h"
#include "core/scene/params/params.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace texplorer {

struct SweepAxis {
    std::string path;                ///< "textures[0].minFilter"
    std::vector<std::string> values; ///< as formatValue writes them, none of them twice

    bool operator==(const SweepAxis&) const = default;
};

/// "minFilter" of "textures[0].minFilter".
[[nodiscard]] constexpr std::string_view keyOfPath(std::string_view path) {
    return path.substr(path.rfind('.') + 1);
}

inline constexpr std::size_t maxAxisValues = 256;

/// Whether values of this kind are few or can be counted through: choices, true and false, numbers, vectors,
/// colours.
[[nodiscard]] bool canSweep(const ParamRow& row);

/// "PATH=VALUES", see sweepAxis, but that a value which is written out twice is refused. The error's `where`
/// is the path.
[[nodiscard]] Result<SweepAxis> parseSweepAxis(const Scene& scene, std::string_view text);

/// `values` of a parameter of the scene: "GL_NEAREST,GL_LINEAR", "1,2,4"; of vectors and colours with
/// semicolons between them, "1,0,0,1;0,1,0,1". "0..4/5" is five numbers from 0 to 4, both included, a whole
/// number each where the parameter is one; without "/5", five. "*" is all of a choice, and of a number a few
/// (suggestedValues). What is there twice is left out.
[[nodiscard]] Result<SweepAxis> sweepAxis(const Scene& scene, std::string_view path, std::string_view values);

/// What there is to see first: every choice; of a number with few steps five across its range, those that
/// double where it begins above 0, and of one with many steps five around the current one. Empty where
/// nothing suggests itself.
[[nodiscard]] std::vector<std::string> suggestedValues(const ParamRow& row, const Value& current);

} // namespace texplorer

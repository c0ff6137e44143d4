#pragma once

// A picture of the differences between two pictures.

#include "texplorer/base/result.h"
#include "texplorer/compare/difference.h"
#include "texplorer/image/image.h"

#include <array>
#include <cstdint>
#include <vector>

namespace texplorer {

/// The colours of a heat map. Equal is black; up to `tolerance` is a dark blue; above it, the colour jumps to
/// violet and continues through red and orange to a pale yellow at `top`. Lightness rises at every step, so
/// the map works without colours. Above the tolerance, the scale is logarithmic: 3 and 6 are as far apart as
/// 30 and 60.
struct HeatScale {
    int tolerance = 1; ///< in 255ths
    int top = 255;     ///< the brightest value; above `tolerance`

    bool operator==(const HeatScale&) const = default;
};

/// Returns the opaque colour of a difference, for pixels and legends. Differences are clamped to 0 … 255.
[[nodiscard]] std::array<std::uint8_t, 4> heatColor(float difference, const HeatScale& scale = {});

struct HeatStep {
    int difference; ///< in 255ths
    std::array<std::uint8_t, 4> color;
};

/// The steps of a legend: 0, then powers of 2 up to 255.
[[nodiscard]] std::vector<HeatStep> heatSteps(const HeatScale& scale = {});

/// Returns each pixel's difference as a colour of that scale: Rgba8, opaque. Errors: those of compare().
[[nodiscard]] Result<Image> heatMap(const Image& a, const Image& b, const HeatScale& scale = {},
                                    Compared compared = Compared::Rgba);

} // namespace texplorer

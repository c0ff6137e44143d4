#pragma once

// A picture of how far two pictures are apart.

#include "core/base/result.h"
#include "core/compare/difference.h"
#include "core/image/image.h"

#include <array>
#include <cstdint>
#include <vector>

namespace texplorer {

/// What the colours of a heat map mean. Equal is black and up to `tolerance` a dark blue; above it the colour
/// jumps to a violet and from there on through red and orange to a pale yellow at `top`. Every step is
/// lighter than the one before it, so that it also reads without colours. Above the tolerance the steps are
/// logarithmic: 3 and 6 are as far apart as 30 and 60.
struct HeatScale {
    int tolerance = 1; ///< in 255ths
    int top = 255;     ///< what is as bright as can be; more than `tolerance`

    bool operator==(const HeatScale&) const = default;
};

/// The colour of a difference, opaque, for a pixel or a legend. 0 to 255; outside of it is as the nearest.
[[nodiscard]] std::array<std::uint8_t, 4> heatColor(float difference, const HeatScale& scale = {});

struct HeatStep {
    int difference; ///< in 255ths
    std::array<std::uint8_t, 4> color;
};

/// For a legend: from 0 by powers of 2 to 255.
[[nodiscard]] std::vector<HeatStep> heatSteps(const HeatScale& scale = {});

/// Each pixel's difference as its colour on that scale: Rgba8, opaque. Errors: as of compare().
[[nodiscard]] Result<Image> heatMap(const Image& a, const Image& b, const HeatScale& scale = {},
                                    Compared compared = Compared::Rgba);

} // namespace texplorer

#pragma once

// Embossing along one line: heights, a directional light, and the results of the passes of NeHe's lesson 22.
// The offset is that of embossOffset.

#include "texplorer/image/image.h"

#include <glm/vec3.hpp>

#include <vector>

namespace texplorer {

/// A line across a height map, from s = 0 to 1, at least one texel: heights of 0 to 1 and the colours there.
struct HeightProfile {
    std::vector<float> heights;
    std::vector<glm::vec3> colors; ///< as many

    /// Under GL_LINEAR, with GL_CLAMP_TO_EDGE.
    [[nodiscard]] float heightAt(float s) const;
    [[nodiscard]] glm::vec3 colorAt(float s) const;
};

/// A round bump, flat ground, and a block with steep sides, all of one colour.
[[nodiscard]] HeightProfile sketchedProfile();

/// A row of a height map and of the image over it; both Rgb8 or Rgba8 and of the same size.
[[nodiscard]] HeightProfile profileOf(const Image& heights, const Image& colors, int row);

/// The sum of both greys: H0 / 2 of the map and (1 - H1) / 2 of its moved negative.
[[nodiscard]] constexpr float embossGrey(float h0, float h1) {
    return h0 / 2 + (1 - h1) / 2;
}

/// The lit colour blended onto it with GL_DST_COLOR and GL_SRC_COLOR, which doubles their product: (1 + H0 -
/// H1) lit, at most 1.
[[nodiscard]] glm::vec3 embossedColor(float grey, glm::vec3 lit);

/// The values at one position.
struct EmbossedPoint {
    float offset = 0; ///< ds
    float h0 = 0;     ///< the height at s
    float h1 = 0;     ///< at s + ds
    float grey = 0;
    glm::vec3 color{0};
};

/// `light`: the angle from the normal towards increasing s, in radians; `depth`: MAX_EMBOSS; `brightness`: of
/// the lit surface, multiplied with the colour.
[[nodiscard]] EmbossedPoint embossAt(const HeightProfile& profile, float s, float light, float depth,
                                     float brightness);

} // namespace texplorer

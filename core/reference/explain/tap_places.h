#pragma once

// The positions of a sample's texels relative to it, and the texels around them, for a view of the texture.

#include "texplorer/reference/sampling/sample_record.h"

#include <glm/vec2.hpp>

#include <vector>

namespace texplorer::reference {

/// A tap with an unwrapped texel index: with GL_REPEAT and s = 1.1, the texel is in the second copy of the
/// image, next to the sample. Texels of other faces of a cube map are beyond the edges of the face that is
/// hit.
struct PlacedTap {
    Tap tap;
    glm::ivec2 at{0};
};

/// The taps of one level, merged by texel, for a line or picture (of a volume: the slice with the largest
/// weight). `coords` is the sampled position. Coordinates that exceed an int keep the wrapped index.
[[nodiscard]] std::vector<PlacedTap> placeTaps(const SampledTexture& texture, const SampleRecord& sample,
                                               glm::vec3 coords, int level);

/// A part of a level around a sample, with unwrapped texel indices as in PlacedTap.
struct LevelPatch {
    int level = 0;
    int layer = 0;         ///< the slice of a volume, the face of a cube map; else 0
    bool seamless = false; ///< beyond the edges of the face are the adjacent faces
    glm::ivec2 extent{0};  ///< of the whole level
    glm::ivec2 low{0};     ///< the first texel of the part
    glm::ivec2 size{0};
    std::vector<glm::vec4> colors; ///< lowest row first
    glm::vec2 place{0};            ///< of the sample, in texels
    std::vector<PlacedTap> taps;
};

/// The largest extent of a patch. Of very wide samples, only a part is shown.
inline constexpr int maxPatch = 16;

/// One for each level that is read.
[[nodiscard]] std::vector<LevelPatch> levelPatches(const SampledTexture& texture, const SampleRecord& sample,
                                                   glm::vec3 coords);

} // namespace texplorer::reference

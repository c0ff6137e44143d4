#pragma once

// Where the texels of a sample lie beside it, and what is around them: what a view of the texture marks.

#include "core/reference/sampling/sample_record.h"

#include <glm/vec2.hpp>

#include <vector>

namespace texplorer::reference {

/// A tap, its texels counted on beyond the level: with GL_REPEAT and s = 1.1 the texel is in the second copy
/// of the image, where the sample is. Those of other faces of a cube map lie beyond the edges of the one that
/// is hit.
struct PlacedTap {
    Tap tap;
    glm::ivec2 at{0};
};

/// The taps of one level, those of the same texel added up, of a line or picture (of a volume: the slice that
/// weighs most). `coords` is where the level is sampled. Coordinates beyond what an int holds stay where the
/// texel is.
[[nodiscard]] std::vector<PlacedTap> placeTaps(const SampledTexture& texture, const SampleRecord& sample,
                                               glm::vec3 coords, int level);

/// A piece of a level around a sample: texels counted on beyond the level, as in PlacedTap.
struct LevelPatch {
    int level = 0;
    int layer = 0;         ///< the slice of a volume, the face of a cube map; else 0
    bool seamless = false; ///< beyond the edges of the face lie those next to it
    glm::ivec2 extent{0};  ///< of the whole level
    glm::ivec2 low{0};     ///< the lowest texel of the piece
    glm::ivec2 size{0};
    std::vector<glm::vec4> colors; ///< lowest row first
    glm::vec2 place{0};            ///< of the sample, in texels
    std::vector<PlacedTap> taps;
};

/// The longest side of a patch. What it does not hold of very wide samples is not shown.
inline constexpr int largestPatch = 16;

/// One for each level that was read.
[[nodiscard]] std::vector<LevelPatch> levelPatches(const SampledTexture& texture, const SampleRecord& sample,
                                                   glm::vec3 coords);

} // namespace texplorer::reference

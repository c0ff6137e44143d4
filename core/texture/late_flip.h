#pragma once

#include "texplorer/texture/texture_levels.h"

namespace texplorer {

/// The flip of a texture's picture that prepareLevels leaves to the renderer.
[[nodiscard]] inline LateFlip lateFlipOf(const Texture& texture, const TextureImage& image, Target target) {
    if (target == Target::CubeMap || !image.fileTopFirst)
        return LateFlip::None;
    switch (texture.flip) {
    case FlipMode::Coordinates:
        return LateFlip::Coordinates;
    case FlipMode::Matrix:
        return LateFlip::Matrix;
    default:
        return LateFlip::None;
    }
}

/// Whether row 0 of the levels is the top row of what the texture shows.
[[nodiscard]] inline bool isTopFirst(const TextureLevels& levels, Target target) {
    return target == Target::CubeMap || levels.lateFlip != LateFlip::None;
}

} // namespace texplorer

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

} // namespace texplorer

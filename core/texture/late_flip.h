#pragma once

#include "core/texture/texture_levels.h"

namespace texplorer {

/// What prepareLevels leaves to do about the picture of a texture.
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

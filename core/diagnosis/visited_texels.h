#pragma once

#include "texplorer/reference/sampling/sampled_texture.h"
#include "texplorer/scene/scene.h"

#include <cstddef>

namespace texplorer {

/// A frame in which a scene uses a texture. Its default size is that of the diagnosis, which runs before
/// drawing: the number of texels that an ellipse reads without mipmaps does not depend on it.
struct TextureUse {
    const Scene& scene; ///< evaluated at a time
    std::size_t texture;
    double time = 0;
    int width = 160;
    int height = 120;
};

/// Returns how many texels an anisotropic filter visits in a frame if it averages over an ellipse by testing
/// its whole bounding box, as Mesa's does: the sum over all fragments, hidden or not. Infinite if q changes
/// sign in a triangle, which makes the box unbounded. Above `enough`, the result may be too small. `texture`
/// needs parameters and extents, but no texels.
[[nodiscard]] double visitedTexels(const reference::SampledTexture& texture, const TextureUse& use,
                                   double enough);

/// Whether a fragment has the same texture coordinates as the pixels around it, as in a point or where the
/// corners of a triangle have the same.
[[nodiscard]] bool hasConstantCoords(const reference::SampledTexture& texture, const TextureUse& use);

} // namespace texplorer

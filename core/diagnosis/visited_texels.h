#pragma once

#include "core/reference/sampling/sampled_texture.h"
#include "core/scene/scene.h"

#include <cstddef>

namespace texplorer {

/// A frame in which a scene shows a texture. The size that it has of itself is that of the diagnosis, which
/// is asked before anything is drawn: how much an ellipse reads of a texture without mipmaps doesn't depend
/// on it.
struct TextureUse {
    const Scene& scene; ///< as it stands
    std::size_t texture;
    double time = 0;
    int width = 160;
    int height = 120;
};

/// How many texels an anisotropic filter visits in a frame that averages over an ellipse and looks at all of
/// the box around it, as Mesa's do: those of every fragment, hidden or not. Infinite where q changes its sign
/// within a triangle, which leaves the box no bound. Above `enough` it may be less than that. `texture` needs
/// parameters and extents, but no texels.
[[nodiscard]] double visitedTexels(const reference::SampledTexture& texture, const TextureUse& use,
                                   double enough);

} // namespace texplorer

#pragma once

// The inverse of a probe: the pixels that a texel contributes to.

#include "texplorer/base/sentence.h"
#include "texplorer/reference/draw.h"
#include "texplorer/reference/raster/triangle.h"
#include "texplorer/reference/sampling/sampler.h"
#include "texplorer/reference/sampling/texture_store.h"

#include <vector>

namespace texplorer::reference {

/// A texel, as a unit of a pass samples it.
struct TexelQuestion {
    int pass = 0;
    int unit = 0;
    TexelPlace texel{};

    bool operator==(const TexelQuestion&) const = default;
};

/// The contribution of one texel to each pixel of a picture.
struct Contributions {
    int width = 0;
    int height = 0;
    /// One per pixel, bottom row first: the texel's weight in the filtered colour of the visible fragment. If
    /// later fragments were blended over it, the largest weight.
    std::vector<float> weights;
    std::vector<Sentence> problems; ///< sentences about what could not be drawn
};

/// Errors: OutOfRange for an invalid size, or if the pass, the unit, the level or the texel does not exist;
/// Unsupported if the unit samples nothing; TooLarge without memory; Cancelled after a stop request. With a
/// border, texels are counted from -1 to the level's extent.
[[nodiscard]] Result<Contributions> contributions(const DrawRequest& request, const TexelQuestion& question,
                                                  const DrawOptions& options = {});

/// For a caller with a TextureStore.
[[nodiscard]] Result<Contributions> findContributions(const DrawRequest& request,
                                                      const TexelQuestion& question,
                                                      const DrawOptions& options, TextureStore& textures);

} // namespace texplorer::reference

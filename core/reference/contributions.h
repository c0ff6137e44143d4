#pragma once

// The probe the other way round: which pixels a texel has a share in.

#include "core/reference/draw.h"
#include "core/reference/raster/triangle.h"
#include "core/reference/sampling/sampler.h"
#include "core/reference/sampling/texture_store.h"

#include <vector>

namespace texplorer::reference {

/// A texel as a unit of a pass sees it.
struct TexelQuestion {
    int pass = 0;
    int unit = 0;
    TexelPlace texel{};

    bool operator==(const TexelQuestion&) const = default;
};

/// What one texel gives to each pixel of a picture.
struct Contributions {
    int width = 0;
    int height = 0;
    /// One a pixel, bottom row first: the texel's weight in the filtered colour of the fragment that one sees
    /// there. Where later fragments were blended over it, the largest weight counts.
    std::vector<float> weights;
    std::vector<std::string> problems; ///< sentences: what could not be drawn
};

/// Errors: OutOfRange for a bad size, or where the pass, the unit, the level or the texel does not exist;
/// Unsupported where the unit samples nothing; TooLarge without memory; Cancelled after a stop request.
/// Texels of the border count from -1 to the level's extent.
[[nodiscard]] Result<Contributions> contributions(const DrawRequest& request, const TexelQuestion& question,
                                                  const DrawOptions& options = {});

/// For a caller that keeps a TextureStore.
[[nodiscard]] Result<Contributions> findContributions(const DrawRequest& request,
                                                      const TexelQuestion& question,
                                                      const DrawOptions& options, TextureStore& textures);

} // namespace texplorer::reference

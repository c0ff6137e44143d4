#pragma once

// Flips a whole texture: every level, face and slice.

#include "texplorer/image/texture_image.h"
#include "texplorer/s3tc/flip.h"

#include <stop_token>

namespace texplorer {

struct FlipOptions {
    FlipAxis axis = FlipAxis::Vertical;
    /// Decompresses and recompresses blocks that cannot be flipped without loss (flipsWithoutLoss). If false,
    /// they are refused.
    bool lossy = false;
    EncodeQuality quality = EncodeQuality::Best; ///< of recompressed blocks
    Progress progress{};                         ///< of recompressing a surface
    std::stop_token stop{};
};

/// Flips every surface in place; `topFirst` and the other members stay. Lossless for pixels, and for blocks
/// whose extents along the axis are 1, 2, 3 or a multiple of 4: these are never decompressed, and flipping
/// twice restores every byte.
///
/// On errors, the texture is unchanged: Unsupported for blocks that would lose something (or, with `lossy`,
/// for signed formats and volumes), Malformed if the bytes of a surface do not match its extents, TooLarge
/// without memory, Cancelled after a stop request. The message names the level.
[[nodiscard]] Result<void> flip(TextureImage& texture, const FlipOptions& options = {});

} // namespace texplorer

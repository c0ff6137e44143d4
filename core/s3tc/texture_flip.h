#pragma once

// Turning all that a texture holds around: every level, face and slice.

#include "core/image/texture_image.h"
#include "core/s3tc/flip.h"

#include <stop_token>

namespace texplorer {

struct FlipOptions {
    FlipAxis axis = FlipAxis::Vertical;
    /// Blocks that can't be turned around without loss (flipsWithoutLoss) are decompressed and compressed
    /// again. Else they are refused.
    bool lossy = false;
    EncodeQuality quality = EncodeQuality::Best; ///< of what is compressed again
    Progress progress{};                         ///< of a surface that is compressed again
    std::stop_token stop{};
};

/// Turns every surface around in place; `topFirst` and the other members stay. Pixels lose nothing, nor do
/// blocks whose extents along the axis are 1, 2, 3 or a multiple of 4: those are never decompressed, and what
/// is flipped twice is byte for byte what it was.
///
/// Errors leave the texture as it was: Unsupported for blocks that would lose something (or, with `lossy`,
/// for signed formats and volumes), Malformed where a surface has not the bytes that its extents ask for,
/// TooLarge without memory, Cancelled after a stop request. The message names the level.
[[nodiscard]] Result<void> flip(TextureImage& texture, const FlipOptions& options = {});

} // namespace texplorer

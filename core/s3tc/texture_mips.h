#pragma once

// The mip levels of a texture, compressed or not.

#include "texplorer/base/result.h"
#include "texplorer/image/mip_options.h"
#include "texplorer/image/texture_image.h"
#include "texplorer/s3tc/encode_quality.h"

namespace texplorer {

/// Replaces the levels above the base of every face by a full chain, down to 1 x 1 (x 1), built from the base
/// by buildMipChain (texplorer/image/mipmaps.h). Levels of a compressed texture are built from the
/// decompressed base and compressed to the same format; the base keeps its blocks. With
/// NpotPolicy::PowerOfTwo, a base of another size is scaled, and compressed again.
///
/// On errors, the texture is unchanged: Malformed if the base of a face is missing or its bytes do not match
/// its extents (an outline has none), Unsupported for compressed signed formats and volumes, TooLarge without
/// memory.
[[nodiscard]] Result<void> buildMips(TextureImage& texture, const MipOptions& options = {},
                                     EncodeQuality quality = EncodeQuality::Normal);

} // namespace texplorer

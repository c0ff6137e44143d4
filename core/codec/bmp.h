#pragma once

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/codec/decode_limits.h"
#include "core/image/texture_image.h"

namespace texplorer {

/// Windows bitmaps as the tutorial's loadBMP_custom reads them: 24 bits a pixel, uncompressed, bottom-up or
/// top-down. `imageSize` and `dataPos` may be 0 and are filled in; rows are padded to four bytes.
/// Gives Rgb8, bottom row first. Errors: not a BMP, truncated, a variant that is not read.
[[nodiscard]] Result<TextureImage> decodeBmp(ByteView file, const DecodeLimits& limits = {});

} // namespace texplorer

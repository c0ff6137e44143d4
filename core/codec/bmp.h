#pragma once

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/image/image.h"

namespace texplorer {

// What a decoder accepts at most. The defaults admit what OpenGL drivers do: 16384 x 16384 texels.
struct DecodeLimits {
    int maxExtent = 16384;
};

/// Windows bitmaps as the tutorial's loadBMP_custom reads them: 24 bits a pixel, uncompressed, bottom-up or
/// top-down. `imageSize` and `dataPos` may be 0 and are filled in; rows are padded to four bytes.
/// Gives Rgb8, bottom row first. Errors: not a BMP, truncated, a variant that is not read.
[[nodiscard]] Result<Image> decodeBmp(ByteView file, const DecodeLimits& limits = {});

} // namespace texplorer

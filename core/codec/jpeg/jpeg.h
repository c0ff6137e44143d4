#pragma once

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/codec/common/anatomy.h"
#include "core/codec/common/decode_limits.h"
#include "core/image/texture_image.h"

namespace texplorer {

/// JPEG (ITU-T T.81), read by libjpeg-turbo straight into the final image, bottom row first.
///
/// Behaviour and limitations
/// - Baseline, extended and progressive, Huffman or arithmetic, sampling factors of 1 to 4 that divide the
///   largest of their axis. Grey gives Luminance8, all others Rgb8.
/// - CMYK and YCCK become RGB as (255 - c)(255 - k) / 255, without a profile; inks of files with Adobe's
/// marker
///   are inverted, as that program writes them. Decoding them takes 4 bytes a pixel.
/// - Exif's orientation is noted, not applied: the picture stands as it is stored.
/// - Refused: data that ends before the picture does (also a missing end marker), damaged data, 12 bits a
///   sample, lossless and hierarchical files, more than 500 scans, and extents that the bytes in the file
///   can't fill (Huffman codes take at least one bit for each block of 8 x 8 samples).
/// - Survived, and noted: bytes before a marker that belong to nothing, bytes behind the end.
/// - Memory: the image and some rows; for progressive files also their coefficients, two bytes a sample.
[[nodiscard]] Result<TextureImage> decodeJpeg(ByteView file, const DecodeLimits& limits = {});

/// Markers and their segments, the fields of the frame header, Exif's orientation, the size of coded data.
[[nodiscard]] Anatomy dissectJpeg(ByteView file);

} // namespace texplorer

#pragma once

#include "texplorer/base/bytes.h"
#include "texplorer/base/result.h"
#include "texplorer/codec/common/anatomy.h"
#include "texplorer/codec/common/decode_limits.h"
#include "texplorer/image/texture_image.h"

namespace texplorer {

/// Decodes JPEG (ITU-T T.81) by libjpeg-turbo directly into the final image, bottom row first.
///
/// Supported files and limitations:
/// - Baseline, extended and progressive, Huffman or arithmetic coding, sampling factors of 1 to 4 that divide
///   the largest one of their axis. Grey gives Luminance8, everything else Rgb8.
/// - CMYK and YCCK become RGB by (255 - c)(255 - k) / 255, without a profile; in files with Adobe's marker,
///   the inks are inverted, as that program writes them. Decoding them takes 4 bytes per pixel.
/// - Exif's orientation is noted, but not applied: the picture stays as stored.
/// - Refused: data that ends before the picture does (also a missing end marker), damaged data, 12 bits per
///   sample, lossless and hierarchical files, more than 500 scans, and extents that the bytes of the file
///   cannot fill (Huffman codes take at least one bit for each block of 8 x 8 samples).
/// - Tolerated, with a note: unknown bytes before a marker, bytes after the end.
/// - Memory: the image and a few rows; for progressive files also their coefficients, two bytes per sample.
[[nodiscard]] Result<TextureImage> decodeJpeg(ByteView file, const DecodeLimits& limits = {});

/// Lists markers and their segments, the fields of the frame header, Exif's orientation, and the size of
/// coded data.
[[nodiscard]] Anatomy dissectJpeg(ByteView file);

} // namespace texplorer

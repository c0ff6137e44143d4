#pragma once

#include "texplorer/base/bytes.h"
#include "texplorer/base/result.h"
#include "texplorer/codec/common/anatomy.h"
#include "texplorer/codec/common/decode_limits.h"
#include "texplorer/codec/common/write_options.h"
#include "texplorer/image/texture_image.h"

namespace texplorer {

/// Decodes Portable Network Graphics (ISO/IEC 15948) by libpng directly into the final image, bottom row
/// first.
///
/// Supported files and limitations:
/// - Every colour type and depth, interlaced or not. Grey gives Luminance8 or LuminanceAlpha8, colour and
///   palettes give Rgb8 or Rgba8; tRNS becomes alpha (compared before a depth of 16 is reduced).
/// - Grey of 1, 2 and 4 bits is scaled to 0 … 255; 16 bits become round(v · 255 / 65535).
/// - Gamma, chromaticities, profiles and significant bits do not change pixels; an sRGB chunk sets `srgb`.
/// - Refused: a wrong checksum in a chunk that the picture needs, unknown critical chunks, a missing IEND,
///   and extents that the compressed bytes of the file cannot fill (deflate compresses at most 1032 : 1).
/// - Tolerated, with a note: damage in other chunks, data after IEND, animations (the first picture is read).
/// - Memory: the image and a few rows. Texts and profiles are skipped without decompression; with
///   DecodeLimits::everything they are copied to TextureImage::parts.
[[nodiscard]] Result<TextureImage> decodePng(ByteView file, const DecodeLimits& limits = {});

/// Lists signature and chunks: length, type, the fields of IHDR, texts, checked checksums, order. Continues
/// to the end of the file; only the beginning of texts is decompressed.
[[nodiscard]] Anatomy dissectPng(ByteView file);

/// Encodes the first slice, upright (the bottom row is written last). Equal images give equal bytes. By
/// default fast rather than small: each row has the Sub or the Up filter, and libdeflate compresses with
/// little effort. `small` tries every filter and all of libdeflate's effort. Alpha8 is written as grey. Texts
/// are written before the pixels.
[[nodiscard]] Result<Bytes> encodePng(const Image& image, const WriteOptions& options = {});

/// The same for level 0 of face 0, with the chunks of TextureImage::parts if it was a PNG, and an sRGB chunk
/// if the texture is sRGB.
[[nodiscard]] Result<Bytes> encodePng(const TextureImage& texture, const WriteOptions& options);

} // namespace texplorer

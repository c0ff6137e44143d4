#pragma once

// Windows and OS/2 bitmaps.
//
// Behaviour and limitations
// - Read: palettes of 1, 2, 4 and 8 bits (also of fewer entries than the bits could tell apart; what lies
//   beyond their end is black); 16 bits (5-5-5 without masks); 24 bits; 32 bits; bit fields of any mask in 16
//   and 32 bits, of any width, apart or overlapping; RLE4 and RLE8 with deltas, early ends and codes that run
//   over a row's end (they are clipped). Bottom-up and top-down rows.
// - Headers: OS/2 1.x (12 bytes, 3-byte palette entries), OS/2 2.x (16 to 64 bytes), Windows 3 (40) and with
//   masks (52, 56), V4 (108), V5 (124). Where `dataPos` is 0 the pixels follow the palette; `imageSize` is
//   not needed for anything; the padding of the last row may be missing.
// - Alpha is what an alpha mask says, also that of a V3, V4 or V5 header whose 32-bit pixels are no bit
// fields,
//   unless it is 0 everywhere. The fourth byte of 32-bit pixels without a mask is not used, as Windows has
//   it; a note says where it looks like alpha. A palette's fourth bytes are not alpha.
// - Pixels that RLE leaves out have the palette's first colour.
// - Components of n bits become 8 by round(v * 255 / (2^n - 1)), as OpenGL would convert them.
// - Gives Luminance8 where an 8-bit palette is the ramp of greys, Rgba8 where there is an alpha mask, else
//   Rgb8; the bottom row first. Colour spaces and profiles of V4 and V5 are not applied.
// - Refused: JPEG and PNG files wrapped in a BMP, CMYK, OS/2's Huffman 1D and RLE24, 64 bits a pixel, the
//   OS/2 containers "BA", "CI", "CP", "IC", "PT".
// - A run-length coded file of n bytes is refused if it claims more than 255 n pixels and more than 1024 x
//   1024: codes that paint can't fill it.

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/codec/common/anatomy.h"
#include "core/codec/common/decode_limits.h"
#include "core/image/texture_image.h"

namespace texplorer {

struct WriteOptions;

/// Errors: not a BMP, truncated, contradictory, too large, a variant that is not read.
[[nodiscard]] Result<TextureImage> decodeBmp(ByteView file, const DecodeLimits& limits = {});

/// Face 0, level 0, slice 0, decompressed, bottom row first. Rgb8 becomes 24 bits, Luminance8 8 bits with a
/// grey palette, everything with alpha 32 bits with masks in a V4 header (Luminance and Alpha become what
/// OpenGL expands them to: L, L, L, A and 0, 0, 0, A). Options are not used.
[[nodiscard]] Result<Bytes> encodeBmp(const TextureImage& texture, const WriteOptions& options);

/// The file header, the info header, masks, palette and pixel data, and what looks wrong with them.
[[nodiscard]] Anatomy dissectBmp(ByteView file);

} // namespace texplorer

#pragma once

// Windows and OS/2 bitmaps.
//
// Supported files and limitations:
// - Pixels: palettes of 1, 2, 4 and 8 bits (also shorter than the bits allow; missing entries are black); 16
//   bits (5-5-5 without masks); 24 bits; 32 bits; bit fields with any masks in 16 and 32 bits, of any width,
//   separate or overlapping; RLE4 and RLE8 with deltas, early ends, and codes that run over the end of a row
//   (clipped). Bottom-up and top-down rows.
// - Headers: OS/2 1.x (12 bytes, 3-byte palette entries), OS/2 2.x (16 to 64 bytes), Windows 3 (40) and with
//   masks (52, 56), V4 (108), V5 (124). If `dataPos` is 0, the pixels follow the palette; `imageSize` is not
//   used; the padding of the last row may be missing.
// - Alpha is defined by an alpha mask, also in V3, V4 and V5 headers whose 32-bit pixels are not bit fields;
//   if it is 0 everywhere, the picture is opaque. The fourth byte of 32-bit pixels without a mask is ignored,
//   as in Windows; a note says if it looks like alpha. The fourth bytes of palettes are not alpha.
// - Pixels that RLE skips have the palette's first colour.
// - Components of n bits become 8 bits by round(v * 255 / (2^n - 1)), as OpenGL converts them.
// - Result: Luminance8 if an 8-bit palette is the ramp of greys, Rgba8 with an alpha mask, else Rgb8; bottom
//   row first. Colour spaces and profiles of V4 and V5 are not applied.
// - Refused: JPEG and PNG files in a BMP, CMYK, OS/2's Huffman 1D and RLE24, 64 bits per pixel, the OS/2
//   containers "BA", "CI", "CP", "IC", "PT".
// - A run-length coded file of n bytes is refused if it states more than 255 n pixels and more than 1024 x
//   1024: its codes cannot fill that.

#include "texplorer/base/bytes.h"
#include "texplorer/base/result.h"
#include "texplorer/codec/common/anatomy.h"
#include "texplorer/codec/common/decode_limits.h"
#include "texplorer/image/texture_image.h"

namespace texplorer {

struct WriteOptions;

/// Errors: not a BMP, truncated, contradictory, too large, an unsupported variant.
[[nodiscard]] Result<TextureImage> decodeBmp(ByteView file, const DecodeLimits& limits = {});

/// Writes face 0, level 0, slice 0, decompressed, bottom row first. Rgb8 becomes 24 bits, Luminance8 8 bits
/// with a grey palette, all formats with alpha 32 bits with masks in a V4 header (Luminance and Alpha are
/// expanded as in OpenGL: L, L, L, A and 0, 0, 0, A). The options are ignored.
[[nodiscard]] Result<Bytes> encodeBmp(const TextureImage& texture, const WriteOptions& options);

/// Lists the file header, the info header, masks, palette and pixel data, with their errors.
[[nodiscard]] Anatomy dissectBmp(ByteView file);

} // namespace texplorer

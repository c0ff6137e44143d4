#pragma once

// DirectDraw Surface files: the texture files of Direct3D, and the usual container of S3TC textures.
//
// Supported files and limitations:
//
// Read:
// - dwFourCC DXT1, DXT3, DXT5; DXT2 and DXT4 (as DXT3 and DXT5 with AlphaMeaning::Premultiplied and a note);
//   ATI1, BC4U, BC4S, ATI2, BC5U, BC5S; DX10 with the DXGI formats BC1 to BC5, their sRGB variants, and the
//   uncompressed formats of 8, 16 and 32 bits listed in dds_format.cpp. TYPELESS is read as UNORM.
// - Uncompressed RGB, RGBA, luminance, luminance with alpha, and alpha, of 8, 16, 24 or 32 bits per pixel,
//   with any channel masks. They become Rgb8, Rgba8, Luminance8, LuminanceAlpha8 and Alpha8; red alone
//   becomes Luminance8 (grey, as BC4 is shown); red and green become Rgb8 with blue 0.
// - Depth (DDPF_ZBUFFER), as grey.
// - Full and partial mip chains, cube maps of six faces, volumes with their mip levels. Of an array, the
//   first element, or all of them (DecodeLimits::everything).
//
// D3DX writes 10:10:10:2 with red in the low bits and the opposite in the header: an old header with those
// masks is read as D3DX means it, as by other readers, with a note.
//
// DXT1: an old header does not say whether there is 1-bit alpha. The result is BlockFormat::Dxt1Alpha if
// DDPF_ALPHAPIXELS is set (or the DX10 header says straight or premultiplied) or if any texel of any level
// uses the code for transparent black; it is Dxt1 if no texel does or if the DX10 header says opaque.
//
// Tolerated, each with a sentence in `notes`: wrong or missing linear sizes, pitches and flags; a mip count
// of 0, beyond the chain, or beyond the file (the complete levels are kept if level 0 of every face is
// complete); bytes after the last level; masks beyond the pixel; a wrong size of the pixel format. Rows are
// read without padding, as by Direct3D's loaders, regardless of the pitch.
//
// Refused, with a sentence: incomplete arrays, cube maps that lack faces or are not square, palettes, YUV,
// bump maps, floating point, signed and 64-bit or wider uncompressed formats, BC6H and BC7, dwSize other than
// 124.
//
// Surfaces keep the file's order, top row first.
//
// Written: every format of a TextureImage, with its levels, faces, slices or layers. The header is the old
// one, which most programs read; the DX10 header is written only for what the old one cannot express: arrays,
// sRGB colours, premultiplied alpha other than in DXT2 and DXT4, and DXT1 without alpha whose blocks use the
// code for transparent black. RGB8 and RGBA8 are stored as blue, green, red; their sRGB forms as B8G8R8X8 and
// R8G8B8A8. DXGI has no sRGB luminance, so sRGB greys are widened to these, and so are greys of arrays,
// except grey alone, which is R8. BC4, BC5 and Alpha8 have no sRGB variant and are written without it. The
// old header has no field for unknown or missing alpha; both are written as straight alpha.

#include "texplorer/codec/common/anatomy.h"
#include "texplorer/codec/common/decode_limits.h"
#include "texplorer/codec/common/write_options.h"
#include "texplorer/image/texture_image.h"

namespace texplorer {

[[nodiscard]] Result<TextureImage> decodeDds(ByteView file, const DecodeLimits& limits = {});

/// Textures with the bottom row first are flipped. Compressed levels are flipped only if that is lossless
/// (core/s3tc/flip.h), else refused. Levels that are not a mip chain are refused, too.
[[nodiscard]] Result<Bytes> encodeDds(const TextureImage& texture, const WriteOptions& options = {});

/// Lists every field of the headers and every level of every face; for damaged files, as far as possible.
[[nodiscard]] Anatomy dissectDds(ByteView file);

} // namespace texplorer

#pragma once

// DirectDraw Surface files: the texture files of Direct3D, and the usual container of S3TC textures.
//
// Behaviour and limitations
//
// Read:
//   - dwFourCC DXT1, DXT3, DXT5; DXT2 and DXT4 (as DXT3 and DXT5 with AlphaMeaning::Premultiplied and a
//   note);
//     ATI1, BC4U, BC4S, ATI2, BC5U, BC5S; DX10 with the DXGI formats BC1 to BC5, their sRGB variants, and the
//     uncompressed ones of 8, 16 and 32 bits listed in dds_format.cpp. TYPELESS is read as UNORM.
//   - Uncompressed RGB, RGBA, luminance, luminance with alpha, and alpha, of 8, 16, 24 or 32 bits a pixel,
//   with
//     the channels at any mask. They become Rgb8, Rgba8, Luminance8, LuminanceAlpha8 and Alpha8; red alone
//     becomes Luminance8 (grey, as BC4 is shown), red and green Rgb8 with blue 0.
//   - Depth (DDPF_ZBUFFER), as grey.
//   - Full and partial mip chains, cube maps of six faces, volumes with their mips. Of an array, the first
//   element, or all of them (DecodeLimits::everything).
//
// D3DX writes 10:10:10:2 with red in the low bits and says the opposite: an old header with those masks is
// read as D3DX means it, as other readers do, with a note.
//
// DXT1: nothing in an old header says whether it has 1-bit alpha. It becomes BlockFormat::Dxt1Alpha where
// DDPF_ALPHAPIXELS is set (or the DX10 header says straight or premultiplied) or where any texel of any level
// uses the code for transparent black; Dxt1 where none does or where the DX10 header says opaque. Survived,
// each with a sentence in `notes`: wrong or missing linear sizes, pitches and flags; a mip count of 0, beyond
// the chain, or beyond the file (the levels that are whole are kept if level 0 of every face is); bytes after
// the last level; masks beyond the pixel; a wrong size of the pixel format. Rows are taken without padding,
// as Direct3D's loaders take them, whatever the pitch says. Refused, with a sentence: arrays that lack a
// byte, cube maps that lack faces or are not square, palettes, YUV, bump maps, floating point, signed and
// 64-bit or wider uncompressed formats, BC6H and BC7, dwSize other than 124.
//
// Surfaces keep the file's order, top row first.
//
// Written: every format of a TextureImage, with its levels, faces, slices or layers. The header is the old
// one, which most programs read, except where only the DX10 header can say it: arrays, sRGB colours,
// premultiplied alpha outside of DXT2 and DXT4, and DXT1 without alpha whose blocks use the code for
// transparent black. RGB8 and RGBA8 are stored as blue, green, red; sRGB ones as B8G8R8X8 and R8G8B8A8, greys
// widened to them, because DXGI has no sRGB luminance; so are those of an array, but for grey alone, which is
// R8. BC4, BC5 and Alpha8 have no sRGB variant and are written without. Unknown alpha and none at all are
// straight in an old header, which has no word for them.

#include "core/codec/common/anatomy.h"
#include "core/codec/common/decode_limits.h"
#include "core/codec/common/write_options.h"
#include "core/image/texture_image.h"

namespace texplorer {

[[nodiscard]] Result<TextureImage> decodeDds(ByteView file, const DecodeLimits& limits = {});

/// A texture whose bottom row is first is turned over on the way; compressed levels are turned only where
/// that loses nothing (core/s3tc/flip.h), and else refused. Levels that are no mip chain are refused, too.
[[nodiscard]] Result<Bytes> encodeDds(const TextureImage& texture, const WriteOptions& options = {});

/// Every field of the headers and every level of every face, for damaged files as far as they go.
[[nodiscard]] Anatomy dissectDds(ByteView file);

} // namespace texplorer

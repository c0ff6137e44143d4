#pragma once

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/codec/common/anatomy.h"
#include "core/codec/common/decode_limits.h"
#include "core/codec/common/write_options.h"
#include "core/image/texture_image.h"

namespace texplorer {

/// Portable Network Graphics (ISO/IEC 15948), read by libpng straight into the final image, bottom row first.
///
/// Behaviour and limitations
/// - Every colour type and depth, interlaced or not. Grey gives Luminance8 or LuminanceAlpha8, colour and
///   palettes give Rgb8 or Rgba8; tRNS becomes alpha (compared before a depth of 16 is reduced).
/// - Grey of 1, 2 and 4 bits is stretched to 0 … 255; 16 bits become round(v · 255 / 65535).
/// - Gamma, chromaticities, profiles and significant bits change no pixel; an sRGB chunk sets `srgb`.
/// - Refused: a wrong checksum in a chunk that the picture needs, unknown critical chunks, a missing IEND,
/// and
///   extents that the compressed bytes in the file can't fill (deflate packs at most 1032 : 1).
/// - Survived, and noted: damage in other chunks, data behind IEND, animations (the first picture is read).
/// - Memory: the image and a few rows. Text and profiles are skipped without being unpacked; with
///   DecodeLimits::everything they become TextureImage::parts as they are.
[[nodiscard]] Result<TextureImage> decodePng(ByteView file, const DecodeLimits& limits = {});

/// Signature and chunks: length, type, the fields of IHDR, texts, checksums compared, order. Goes on to where
/// the file ends; nothing is unpacked but the beginning of texts.
[[nodiscard]] Anatomy dissectPng(ByteView file);

/// A PNG of the first slice, upright (the bottom row is written last). The same image gives the same bytes.
/// By default fast rather than small: each row has the Sub or the Up filter, and libdeflate packs them with
/// little effort. `small` takes every filter and all of libdeflate's effort. Alpha8 is written as grey. Texts
/// stand in front of the pixels.
[[nodiscard]] Result<Bytes> encodePng(const Image& image, const WriteOptions& options = {});

/// The same of level 0 of face 0, with the chunks that TextureImage::parts has of another PNG, and one that
/// says sRGB where it is.
[[nodiscard]] Result<Bytes> encodePng(const TextureImage& texture, const WriteOptions& options);

} // namespace texplorer

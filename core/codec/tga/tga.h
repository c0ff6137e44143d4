#pragma once

#include "texplorer/base/bytes.h"
#include "texplorer/base/result.h"
#include "texplorer/codec/common/anatomy.h"
#include "texplorer/codec/common/decode_limits.h"
#include "texplorer/codec/common/write_options.h"
#include "texplorer/image/texture_image.h"

namespace texplorer {

// Truevision TGA, versions 1 and 2 (Truevision TGA File Format Specification, Version 2.0).
//
// Supported files and limitations:
//
// Read: image types 1, 2, 3 and their run-length coded forms 9, 10, 11.
//
//   colour map   15, 16, 24 or 32 bits per entry, any first entry index, pixels of 8, 15 or 16 bits. A pixel
//                whose entry does not exist becomes black; a note gives the number of such pixels.
//   true colour  15 and 16 bits (5 each), 24, 32. Five bits become eight as in OpenGL: round(v * 255 / 31).
//   grey         8 bits, or 16: 8 of grey and 8 of alpha.
//
// All four origins are read; the first row of the result is the bottom one. A colour map in a picture that
// does not use it is skipped; the fields of a missing colour map are noted and ignored. Packets may run
// across the ends of rows, although version 2 forbids it.
//
// Alpha: version 2's extension area defines its meaning: attributes type 0 and 1 none, 2 Unknown, 3 Straight,
// 4 Premultiplied. Without it, the attribute bits of the descriptor tell whether there is alpha. If they are
// 0 and the pixels have 8 spare bits, files disagree: alphas that are all 0 are taken as padding, others are
// kept as Unknown; so are those of a file that says both. The one bit of 16 is also padding if it is 0
// everywhere and no extension area says that it is alpha (types 3 and 4), regardless of the descriptor.
// Meaningless alpha becomes 255.
//
// Refused: interleaved rows, the Huffman and quadtree types 32 and 33, files without a picture (type 0), a
// truncated colour map, truncated pixel data. Ignored: gamma, colour correction, the postage stamp, developer
// fields.

/// Whether this is a TGA file: by the footer of version 2; or, as version 1 has no magic number, by a header
/// with valid values in all fields. Test for other formats first.
[[nodiscard]] bool isTga(ByteView file);

/// Result: Luminance8, LuminanceAlpha8, Rgb8 or Rgba8, bottom row first. Memory is allocated only after the
/// file is known to be long enough: a run-length packet of 1 + (bytes per pixel) bytes gives at most 128
/// pixels. Errors: malformed, an unsupported variant, larger than the limits.
[[nodiscard]] Result<TextureImage> decodeTga(ByteView file, const DecodeLimits& limits = {});

/// Lists every field of header, colour map, extension area, developer area and footer; the pixel data as one
/// field, and of run-length coded data the first packets and any damage.
[[nodiscard]] Anatomy dissectTga(ByteView file);

/// Writes face 0, level 0, first slice as version 2 with an extension area that defines alpha, raw or (see
/// `runLengthCoded`) in packets that end with their rows. Meaningless alpha is left out; Alpha8 becomes grey.
/// Equal pictures give equal bytes. Errors: no pixels, more than 65535 along an axis.
[[nodiscard]] Result<Bytes> encodeTga(const TextureImage& texture, const WriteOptions& options = {});

} // namespace texplorer

#pragma once

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/codec/common/anatomy.h"
#include "core/codec/common/decode_limits.h"
#include "core/codec/common/write_options.h"
#include "core/image/texture_image.h"

namespace texplorer {

// Truevision TGA, versions 1 and 2 (Truevision TGA File Format Specification, Version 2.0).
//
// Behaviour and limitations
//
// Read: image types 1, 2, 3 and their run-length coded forms 9, 10, 11.
//
//   colour map   15, 16, 24 or 32 bits an entry, any first entry index, pixels of 8, 15 or 16 bits. A pixel
//   that
//                names no entry of the map becomes black, and a note says how many did.
//   true colour  15 and 16 bits (5 each), 24, 32. Five bits become eight as OpenGL does it: round(v * 255 /
//   31). grey         8 bits, or 16: 8 of grey and 8 of alpha.
//
// All four origins are read; the first row of the result is the bottom one. A colour map before a picture
// that doesn't use it is skipped; the fields of a colour map that isn't there are noted and ignored. Packets
// may run across the ends of rows, although version 2 forbids it.
//
// Alpha. Version 2's extension area says what it means: attributes type 0 and 1 none, 2 Unknown, 3 Straight,
// 4 Premultiplied. Without one, the descriptor's attribute bits say whether there is any. Where they say 0
// and the pixels have 8 bits to spare, files disagree: alphas that are all 0 are taken for padding, others
// are kept as Unknown; so are those of a file that says both. The one bit of 16 is padding, too, where it is
// 0 everywhere and no extension area says that it is alpha (types 3 and 4), whatever the descriptor says.
// Alpha that means nothing becomes 255.
//
// Refused: interleaved rows, the Huffman and quadtree types 32 and 33, files without a picture (type 0), a
// cut colour map, cut pixel data. Ignored: gamma, colour correction, the postage stamp, developer fields.

/// Whether this is a TGA file: by the footer of version 2 or, as version 1 has no magic number, by a header
/// whose every field is one that a picture can have. Ask for other formats first.
[[nodiscard]] bool isTga(ByteView file);

/// Gives Luminance8, LuminanceAlpha8, Rgb8 or Rgba8, bottom row first. Nothing is allocated before the file
/// is known to be long enough for its picture: a run-length packet of 1 + (bytes a pixel) bytes gives 128
/// pixels at most. Errors: malformed, a variant that is not read, larger than the limits.
[[nodiscard]] Result<TextureImage> decodeTga(ByteView file, const DecodeLimits& limits = {});

/// Every field of header, colour map, extension area, developer area and footer; the pixel data as a whole,
/// and of run-length coded data the first packets and where it is damaged.
[[nodiscard]] Anatomy dissectTga(ByteView file);

/// Face 0, level 0, first slice as version 2 with an extension area that says what alpha means, raw or (see
/// `runLengthCoded`) in packets that end with their rows. Alpha that means nothing is left out; a picture of
/// alpha alone becomes grey. The same picture gives the same bytes. Errors: no pixels, more than 65535 along
/// an axis.
[[nodiscard]] Result<Bytes> encodeTga(const TextureImage& texture, const WriteOptions& options = {});

} // namespace texplorer

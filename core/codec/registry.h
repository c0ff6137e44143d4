#pragma once

#include "texplorer/base/bytes.h"
#include "texplorer/base/result.h"
#include "texplorer/codec/common/anatomy.h"
#include "texplorer/codec/common/decode_limits.h"
#include "texplorer/codec/common/write_options.h"
#include "texplorer/image/image.h"
#include "texplorer/image/texture_image.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace texplorer {

/// One row per file format.
struct CodecRow {
    std::string_view name;            ///< "BMP"
    std::string_view extensions;      ///< ".jpg .jpeg", lower case, the usual one first
    bool (*recognise)(ByteView file); ///< checks the content, never the name
    Result<TextureImage> (*decode)(ByteView file, const DecodeLimits& limits);
    Anatomy (*dissect)(ByteView file); ///< nullptr: no anatomy
    /// nullptr: the format is not written. Formats of one picture store face 0, level 0, decompressed and
    /// upright.
    Result<Bytes> (*encode)(const TextureImage& texture, const WriteOptions& options);
};

[[nodiscard]] std::span<const CodecRow> codecRows();

/// {".jpg", ".jpeg"}
[[nodiscard]] std::vector<std::string> extensionsOf(const CodecRow& row);

/// The format of a file by its content, or nullptr.
[[nodiscard]] const CodecRow* recogniseImage(ByteView file);

/// Returns the format of a file name's extension (in any case), or nullptr.
[[nodiscard]] const CodecRow* codecForExtension(std::string_view fileName);

/// ".bmp, .dds, .png or .tga", with `last` as " or ": the usual extension of each format that is written, or
/// of `only`.
[[nodiscard]] std::string writtenExtensions(std::string_view last, std::string_view only = {});

/// Decodes a file of any known format. Unknown ones are refused with the list of the known. Decoders and
/// encoders keep no state, so they are thread-safe.
[[nodiscard]] Result<TextureImage> decodeTexture(ByteView file, const DecodeLimits& limits = {});

/// Returns the content of a file without pixels (DecodeLimits::pixels). The pixels are decoded, and
/// discarded, only if `anatomy`, that of the file, contains an error. So a returned outline means that
/// decodeTexture can read the file, unless its pixels have damage that the anatomy does not detect.
[[nodiscard]] Result<TextureImage> outlineTexture(ByteView file, const Anatomy& anatomy,
                                                  DecodeLimits limits = {});

/// The picture alone: uprightImage of decodeTexture.
[[nodiscard]] Result<Image> decodeImage(ByteView file, const DecodeLimits& limits = {});

/// The anatomy of a file whose format is recognised, else an empty one.
[[nodiscard]] Anatomy dissect(ByteView file);

} // namespace texplorer

#pragma once

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/codec/common/anatomy.h"
#include "core/codec/common/decode_limits.h"
#include "core/codec/common/write_options.h"
#include "core/image/image.h"
#include "core/image/texture_image.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace texplorer {

/// One row per file format.
struct CodecRow {
    std::string_view name;            ///< "BMP"
    std::string_view extensions;      ///< ".jpg .jpeg", lower case, the usual one first
    bool (*recognise)(ByteView file); ///< by its content, never by its name
    Result<TextureImage> (*decode)(ByteView file, const DecodeLimits& limits);
    Anatomy (*dissect)(ByteView file); ///< nullptr: no anatomy
    /// nullptr: not written. Formats of one picture take face 0, level 0, decompressed; top and bottom are
    /// right.
    Result<Bytes> (*encode)(const TextureImage& texture, const WriteOptions& options);
};

[[nodiscard]] std::span<const CodecRow> codecRows();

/// {".jpg", ".jpeg"}
[[nodiscard]] std::vector<std::string> extensionsOf(const CodecRow& row);

/// The format of a file by its content, or nullptr.
[[nodiscard]] const CodecRow* recogniseImage(ByteView file);

/// The format that a file name's extension asks for (in any case), or nullptr.
[[nodiscard]] const CodecRow* codecForExtension(std::string_view fileName);

/// ".bmp, .dds, .png or .tga", with " or " for `last`: the usual extension of each format that is written; of
/// `only`, where one is named.
[[nodiscard]] std::string writtenExtensions(std::string_view last, std::string_view only = {});

/// Decodes whichever format it is. An unknown one is refused with the list of those that are known. Decoders,
/// like encoders, keep no state: any number of threads may use them at once.
[[nodiscard]] Result<TextureImage> decodeTexture(ByteView file, const DecodeLimits& limits = {});

/// What a file holds but for its pixels (DecodeLimits::pixels). They are decoded, and forgotten, only where
/// `anatomy`, that of the file, finds something wrong: an outline that is given is that of a file that
/// decodeTexture reads, unless its pixels are damaged where no anatomy sees it.
[[nodiscard]] Result<TextureImage> outlineTexture(ByteView file, const Anatomy& anatomy,
                                                  DecodeLimits limits = {});

/// The picture alone: uprightImage of decodeTexture.
[[nodiscard]] Result<Image> decodeImage(ByteView file, const DecodeLimits& limits = {});

/// The anatomy of a file whose format is recognised, else an empty one.
[[nodiscard]] Anatomy dissect(ByteView file);

} // namespace texplorer

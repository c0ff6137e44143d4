#pragma once

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/codec/bmp.h"
#include "core/image/image.h"

#include <span>
#include <string_view>

namespace texplorer {

/// One row per file format that can be read.
struct CodecRow {
    std::string_view name;            ///< "BMP"
    std::string_view extension;       ///< ".bmp"
    bool (*recognise)(ByteView file); ///< by its first bytes, never by its name
    Result<Image> (*decode)(ByteView file, const DecodeLimits& limits);
};

[[nodiscard]] std::span<const CodecRow> codecRows();

/// The format of a file by its content, or nullptr.
[[nodiscard]] const CodecRow* recogniseImage(ByteView file);

/// Decodes whichever format it is. An unknown one is refused with the list of those that are known.
[[nodiscard]] Result<Image> decodeImage(ByteView file, const DecodeLimits& limits = {});

} // namespace texplorer

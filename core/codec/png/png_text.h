#pragma once

// Texts in a PNG: chunks of three kinds (ISO/IEC 15948, 11.3.4).
//
//   tEXt   keyword  0  text in Latin-1
//   zTXt   keyword  0  method (0)  zlib stream of text in Latin-1
//   iTXt   keyword  0  compressed (0, 1)  method (0)  language  0  translated keyword  0  UTF-8, or its zlib
//   stream

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/codec/common/write_options.h"
#include "core/codec/png/png_chunks.h"

#include <optional>
#include <string>
#include <string_view>

namespace texplorer {

/// What of a text is worth packing: what is shorter is read as it stands by any tool.
inline constexpr std::size_t packedTextBytes = 512;

struct PngText {
    std::string keyword;          ///< UTF-8
    std::string text;             ///< UTF-8 of what was Latin-1; of iTXt as it stands, checked by nobody
    std::size_t keywordBytes = 0; ///< of the chunk's data, without the 0
    std::size_t textOffset = 0;   ///< of the text or its zlib stream in the chunk's data
    bool packed = false;          ///< it is compressed
    bool tooLong = false;         ///< there is more than was asked for
    std::string wrong{};          ///< empty, or why there is no text
};

[[nodiscard]] bool isTextChunk(const PngChunk& chunk);

/// What the chunk says; a text that needs more than `maxBytes` unpacked is none.
[[nodiscard]] PngText readTextChunk(const PngChunk& chunk, std::size_t maxBytes);

/// Type and data of the chunk that says this: tEXt where it is ASCII and short, else iTXt, packed where it is
/// long. The error: a keyword that PNG has none of.
[[nodiscard]] Result<std::pair<std::string, Bytes>> textChunk(const PictureText& text);

/// The first text of a PNG with this keyword; none where there is none. Errors: the file is no PNG, the text
/// is damaged or takes more than `maxBytes`.
[[nodiscard]] Result<std::optional<std::string>> findPngText(ByteView file, std::string_view keyword,
                                                             std::size_t maxBytes);

} // namespace texplorer

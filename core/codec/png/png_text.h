#pragma once

// Texts in a PNG: chunks of three kinds (ISO/IEC 15948, 11.3.4).
//
//   tEXt   keyword  0  text in Latin-1
//   zTXt   keyword  0  method (0)  zlib stream of text in Latin-1
//   iTXt   keyword  0  compressed (0, 1)  method (0)  language  0  translated keyword  0  UTF-8 or zlib of it

#include "texplorer/base/bytes.h"
#include "texplorer/base/result.h"
#include "texplorer/base/sentence.h"
#include "texplorer/codec/common/write_options.h"
#include "texplorer/codec/png/png_chunks.h"

#include <optional>
#include <string>
#include <string_view>

namespace texplorer {

/// Texts from this size on are compressed; shorter ones stay readable for any tool.
inline constexpr std::size_t packedTextBytes = 512;

struct PngText {
    std::string keyword;          ///< UTF-8
    std::string text;             ///< Latin-1 converted to UTF-8; the text of iTXt unchanged and unchecked
    std::size_t keywordBytes = 0; ///< of the chunk's data, without the 0
    std::size_t textOffset = 0;   ///< of the text or its zlib stream, in the chunk's data
    bool packed = false;          ///< it is compressed
    bool tooLong = false;         ///< there is more than was asked for
    std::string wrong{};          ///< empty, or why the text could not be read
};

[[nodiscard]] bool isTextChunk(const PngChunk& chunk);

/// Reads a text chunk; no text if it needs more than `maxBytes` decompressed.
[[nodiscard]] PngText readTextChunk(const PngChunk& chunk, std::size_t maxBytes);

/// Returns type and data of a text chunk: tEXt if the text is short ASCII, else iTXt, compressed if long.
/// Error: a keyword that PNG does not allow.
[[nodiscard]] Result<std::pair<std::string, Bytes>> textChunk(const PictureText& text);

/// Finds the first text of a PNG with this keyword; empty if there is none. Errors: the file is not a PNG, or
/// the text is damaged or longer than `maxBytes`.
[[nodiscard]] Result<std::optional<std::string>> findPngText(ByteView file, std::string_view keyword,
                                                             std::size_t maxBytes);

} // namespace texplorer

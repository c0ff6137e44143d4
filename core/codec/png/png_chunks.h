#pragma once

// The structure of a PNG file, read without decompression: the decoder checks it before it allocates memory,
// and the anatomy shows it.
//
//   signature (8)   then chunks   length (4)   type (4)   data (length)   CRC of type and data (4)
//
// All numbers are big-endian.

#include "texplorer/base/bytes.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>

namespace texplorer {

inline constexpr std::array<unsigned char, 8> pngSignature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
inline constexpr std::size_t pngHeaderEnd = 8 + 12 + 13; ///< of the signature and IHDR

[[nodiscard]] bool hasPngSignature(ByteView file);

/// Whether an IHDR of 13 bytes follows the signature.
[[nodiscard]] bool beginsWithPngHeader(ByteView file);

/// Returns the number in the four bytes at an offset; bytes beyond the end count as 0.
[[nodiscard]] std::uint32_t bigEndian32(ByteView bytes, std::size_t offset);

struct PngHeader {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::uint8_t depth = 0;
    std::uint8_t colorType = 0; ///< 0 grey, 2 RGB, 3 palette, 4 grey and alpha, 6 RGB and alpha
    std::uint8_t compression = 0;
    std::uint8_t filter = 0;
    std::uint8_t interlace = 0; ///< 0 none, 1 Adam7

    /// The size of the decompressed data: all rows of all passes, each with its filter byte.
    [[nodiscard]] std::uint64_t filteredBytes() const;
};

/// Reads the data of IHDR; missing fields are 0.
[[nodiscard]] PngHeader readPngHeader(ByteView data);

struct PngChunk {
    std::size_t offset = 0; ///< of its length
    std::uint32_t length = 0;
    std::string type;
    ByteView data;                    ///< shorter than `length` if the file ends
    std::optional<std::uint32_t> crc; ///< empty if the file ends before it

    [[nodiscard]] std::uint64_t size() const { return 12 + std::uint64_t{length}; } ///< of the whole chunk
    [[nodiscard]] bool complete() const { return crc.has_value(); }
};

/// The correct checksum of a complete chunk's type and data.
[[nodiscard]] std::uint32_t pngCrc(const PngChunk& chunk);

/// Iterates over the chunks of a file. The last may be incomplete.
class PngChunks {
public:
    explicit PngChunks(ByteView file)
        : file_(file)
        , offset_(std::min(pngSignature.size(), file.size())) {}

    /// Returns the next chunk; empty if fewer than the eight bytes of its head are left.
    [[nodiscard]] std::optional<PngChunk> next();
    /// The offset of the next chunk: the end of the file after an incomplete one.
    [[nodiscard]] std::size_t offset() const { return offset_; }

private:
    ByteView file_;
    std::size_t offset_;
};

} // namespace texplorer

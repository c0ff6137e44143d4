#pragma once

// The parts of a BMP before its pixels: the file header, the info header in all sizes, the masks and the
// position of the palette. Private to the BMP codec.

#include "texplorer/base/bytes.h"
#include "texplorer/base/result.h"
#include "texplorer/codec/common/decode_limits.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace texplorer::bmp {

inline constexpr std::size_t fileHeaderSize = 14;

enum class Compression : std::uint32_t {
    None = 0,
    Rle8 = 1,
    Rle4 = 2,
    BitFields = 3,
    Jpeg = 4,
    Png = 5,
    AlphaBitFields = 6,
    Cmyk = 11,
    CmykRle8 = 12,
    CmykRle4 = 13,
};

/// The info headers, by size. Sizes from 16 to 64 that no Windows header has are OS/2 2.x headers that end
/// early (their missing fields are 0).
enum class HeaderKind : std::uint8_t { Os21, Os22, Windows3, Windows3Masks, V4, V5, Unknown };
[[nodiscard]] HeaderKind headerKind(std::uint32_t headerSize);
/// "BITMAPINFOHEADER (Windows 3)"
[[nodiscard]] std::string_view headerName(std::uint32_t headerSize);

/// "RLE8", "JPEG", "number 9"; two of the numbers mean something else in OS/2 2.x.
[[nodiscard]] Sentence compressionName(std::uint32_t compression, std::uint32_t headerSize);

/// Red, green, blue, alpha. An alpha mask of 0 means no alpha.
using Masks = std::array<std::uint32_t, 4>;

struct Header {
    std::uint64_t dataPos = 0; ///< computed if the file says 0
    std::uint32_t headerSize = 0;
    std::int64_t width = 0;
    std::int64_t height = 0; ///< never negative
    bool topDown = false;
    unsigned bitsPerPixel = 0;
    std::uint32_t compression = 0;
    std::uint32_t imageSize = 0;
    std::uint32_t colorsUsed = 0;
    std::size_t masksPos = 0; ///< 0: none
    Masks masks{};
    bool opaque = false;        ///< alpha is 0 everywhere, so it is ignored
    bool loneAlphaMask = false; ///< the header has an alpha mask, but its pixels are not bit fields
    std::uint64_t palettePos = 0;
    std::size_t paletteEntryBytes = 4; ///< 3 in OS/2 1.x: no reserved byte
    std::size_t paletteEntries = 0;    ///< between palettePos and the pixels
    std::vector<Sentence> notes;       ///< irregularities that are tolerated
    std::vector<Sentence> remarks;     ///< valid features that are ignored

    [[nodiscard]] bool runLengthCoded() const {
        return compression == static_cast<std::uint32_t>(Compression::Rle8) ||
               compression == static_cast<std::uint32_t>(Compression::Rle4);
    }
    [[nodiscard]] std::uint64_t rowBytes() const {
        return (static_cast<std::uint64_t>(width) * bitsPerPixel + 7) / 8;
    }
    /// Rows are padded to multiples of four bytes.
    [[nodiscard]] std::uint64_t rowStride() const { return (rowBytes() + 3) / 4 * 4; }
    /// The bytes of uncompressed pixels; the padding of the last row may be missing. 2^62 for sizes that no
    /// file can have.
    [[nodiscard]] std::uint64_t pixelBytes() const {
        constexpr std::uint64_t max = std::uint64_t{1} << 62;
        const auto stepsUp = static_cast<std::uint64_t>(height - 1);
        return stepsUp > (max - rowStride()) / rowStride() ? max : rowStride() * stepsUp + rowBytes();
    }
};

/// Returns the fields as they are in the file, 0 beyond its end. Only overflow is checked; `dataPos` and the
/// palette are completed. The decoder checks the fields afterwards; the anatomy shows them unchecked.
[[nodiscard]] Header parseHeader(ByteView file);

/// Returns a header that the decoder can use: supported, within the limits, with its pixel data within the
/// file.
[[nodiscard]] Result<Header> readHeader(ByteView file, const DecodeLimits& limits);

/// Whether a V4 or V5 header defines a colour space, by a profile or by primaries.
[[nodiscard]] bool hasColorSpace(ByteView file, const Header& header);

[[nodiscard]] tl::unexpected<Error> malformed(const Sentence& message);
[[nodiscard]] tl::unexpected<Error> unsupported(const Sentence& message);
[[nodiscard]] tl::unexpected<Error> tooLarge(const Sentence& message);

} // namespace texplorer::bmp

#pragma once

// The parts of a TGA file other than its pixels, for decodeTga and dissectTga.

#include "texplorer/base/bytes.h"
#include "texplorer/base/result.h"
#include "texplorer/base/sentence.h"
#include "texplorer/image/texture_image.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace texplorer::tga {

// All numbers are little-endian.
//
//   0  ID Length                 3  First Entry Index      8  X-origin of Image   16  Pixel Depth
//   1  Color Map Type            5  Color map Length      10  Y-origin of Image   17  Image Descriptor
//   2  Image Type                7  Color map Entry Size  12  Image Width
//                                                         14  Image Height
//
// Image Descriptor:   7 6          5           4              3 2 1 0
//                     interleave   top first   right to left  attribute (alpha) bits a pixel
struct Header {
    std::uint8_t idLength = 0;
    std::uint8_t colorMapType = 0;
    std::uint8_t imageType = 0;
    std::uint16_t firstEntry = 0;
    std::uint16_t mapLength = 0;
    std::uint8_t entryBits = 0;
    std::uint16_t xOrigin = 0;
    std::uint16_t yOrigin = 0;
    std::uint16_t width = 0;
    std::uint16_t height = 0;
    std::uint8_t pixelBits = 0;
    std::uint8_t descriptor = 0;

    [[nodiscard]] bool mapped() const { return imageType == 1 || imageType == 9; }
    [[nodiscard]] bool gray() const { return imageType == 3 || imageType == 11; }
    [[nodiscard]] bool runLengthCoded() const { return imageType >= 9 && imageType <= 11; }
    [[nodiscard]] int attributeBits() const { return descriptor & 0x0F; }
    [[nodiscard]] bool rightToLeft() const { return (descriptor & 0x10) != 0; }
    [[nodiscard]] bool topFirst() const { return (descriptor & 0x20) != 0; }
    [[nodiscard]] int interleave() const { return descriptor >> 6; }

    [[nodiscard]] std::size_t pixelBytes() const { return (std::size_t{pixelBits} + 7) / 8; }
    [[nodiscard]] std::size_t entryBytes() const { return (std::size_t{entryBits} + 7) / 8; }
    [[nodiscard]] std::size_t mapBytes() const { return colorMapType == 1 ? mapLength * entryBytes() : 0; }
    [[nodiscard]] std::size_t mapOffset() const { return headerBytes + idLength; }
    [[nodiscard]] std::size_t pixelOffset() const { return mapOffset() + mapBytes(); }
    [[nodiscard]] std::uint64_t pixelCount() const { return std::uint64_t{width} * height; }

    /// The number of bits of a colour that can be alpha: 8 of 32, 1 of 16, 8 of grey with 16.
    [[nodiscard]] int alphaBits() const;

    static constexpr std::size_t headerBytes = 18;
};

/// Fields beyond the end of the file are 0.
[[nodiscard]] Header readHeader(ByteView file);

enum class Severity : std::uint8_t {
    Odd,         ///< tolerated
    Malformed,   ///< violates the format
    Unsupported, ///< an unsupported variant
};

/// An error in a field: "expected 8 or 16 bits for grey, found 24".
struct Complaint {
    Severity severity;
    Sentence text;
};

/// The fields of the header: the decoder checks them by these rows, the anatomy shows them.
struct HeaderRow {
    std::size_t offset;
    std::size_t size;
    std::string_view name;
    std::string (*value)(const Header&);
    Sentence (*meaning)(const Header&);
    std::optional<Complaint> (*complaint)(const Header&);
};

[[nodiscard]] std::span<const HeaderRow> headerRows();

/// The last 26 bytes of a file of version 2.
struct Footer {
    std::uint32_t extensionOffset = 0; ///< 0: none
    std::uint32_t developerOffset = 0; ///< 0: none

    static constexpr std::size_t bytes = 26;
    static constexpr std::string_view signature{"TRUEVISION-XFILE.\0", 18};
};

[[nodiscard]] std::optional<Footer> readFooter(ByteView file);

/// What an extension area contains and no other format stores: gamma, and the author's texts.
[[nodiscard]] std::vector<Loss> lossesOf(ByteView extension);

inline constexpr std::size_t extensionBytes = 495;
inline constexpr std::size_t attributesTypeOffset = 494; ///< in the extension area

/// Returns the extension area; empty if there is none or the file ends in it.
[[nodiscard]] ByteView findExtension(ByteView file, const std::optional<Footer>& footer);

/// Returns the bytes that can be pixel data: from the header's pixelOffset to the footer or the end.
[[nodiscard]] ByteView pixelData(ByteView file, const Header& header, const std::optional<Footer>& footer);

} // namespace texplorer::tga

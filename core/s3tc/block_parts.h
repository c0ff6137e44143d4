#pragma once

// The fields of a block of DXT1, DXT3 or DXT5: EXT_texture_compression_s3tc. A block is read as one
// little-endian number, whose bit 0 is the lowest of its first byte; texels are numbered row by row from the
// one that is stored first.

#include "texplorer/base/result.h"
#include "texplorer/gl/block_format.h"

#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace texplorer {

/// A block. For DXT1, the first 8 bytes; the others are 0.
using BlockBytes = std::array<std::byte, 16>;

enum class BlockPart : std::uint8_t {
    Color,      ///< an end colour: 5 bits of red (the highest), 6 of green, 5 of blue
    ColorIndex, ///< which of the four colours a texel has
    AlphaEnd,   ///< in DXT5
    Alpha,      ///< in DXT3 a texel's alpha, in DXT5 which of the eight it has
};

/// Adjacent bits that form a number.
struct BlockField {
    BlockPart part = BlockPart::Color;
    int number = 0; ///< the end, 0 or 1, or the texel, 0 to 15
    int first = 0;  ///< its lowest bit
    int bits = 0;

    bool operator==(const BlockField&) const = default;
};

/// The fields, in the order of their bits. Every bit belongs to one.
[[nodiscard]] std::span<const BlockField> blockFields(BlockFormat format);
[[nodiscard]] const BlockField& blockField(BlockFormat format, BlockPart part, int number);
/// The index in blockFields() of the field with this bit.
[[nodiscard]] std::size_t fieldAtBit(BlockFormat format, int bit);

/// Bytes that must be read as one number because a field crosses them: one or more whole fields.
struct BlockBytesGroup {
    int first = 0; ///< byte
    int count = 0;
};

[[nodiscard]] std::span<const BlockBytesGroup> blockGroups(BlockFormat format);

[[nodiscard]] unsigned readField(const BlockBytes& block, const BlockField& field);
/// Bits of `value` beyond the field are ignored.
void writeField(BlockBytes& block, const BlockField& field, unsigned value);
void toggleBit(BlockBytes& block, int bit);

/// All fields of a block as numbers.
struct BlockFields {
    std::array<std::uint16_t, 2> colors{};
    std::array<std::uint8_t, 16> indices{};
    std::array<std::uint8_t, 2> alphaEnds{}; ///< 0 except for DXT5
    std::array<std::uint8_t, 16> alphas{};   ///< 0 for DXT1

    bool operator==(const BlockFields&) const = default;
};

[[nodiscard]] BlockFields fieldsOf(BlockFormat format, const BlockBytes& block);
[[nodiscard]] BlockBytes blockOf(BlockFormat format, const BlockFields& fields);

/// Whether the indices 2 and 3 are colours between the ends; else 2 is their mean and 3 is black, transparent
/// in the RGBA format of DXT1. DXT3 and DXT5 always have four.
[[nodiscard]] bool hasFourColors(BlockFormat format, const BlockFields& fields);
/// The same for the alphas of DXT5; else four are between the ends, and the others are 0 and 255.
[[nodiscard]] bool hasEightAlphas(const BlockFields& fields);

using BlockColor = std::array<std::uint8_t, 4>; ///< red, green, blue, alpha

/// The colours of the colour indices, with alpha for DXT1; as in decodeBlock().
[[nodiscard]] std::array<BlockColor, 4> colorsOf(BlockFormat format, const BlockFields& fields);

/// The number of alpha values of a texel: 16 in DXT3, 8 in DXT5, 0 in DXT1.
[[nodiscard]] std::size_t alphaCount(BlockFormat format);
/// The alphas of BlockFields::alphas; as in decodeBlock(). Those beyond alphaCount() are 0.
[[nodiscard]] std::array<std::uint8_t, 16> alphasOf(BlockFormat format, const BlockFields& fields);

[[nodiscard]] std::array<BlockColor, 16> texelsOf(BlockFormat format, const BlockBytes& block);

/// The 5:6:5 colour nearest to one of 8 bits per component.
[[nodiscard]] std::uint16_t quantized(int red, int green, int blue);

/// Converts a block to another format with the same colours and indices. Alphas become the nearest ones of
/// the new format; between DXT1 and the others, the ends are interpreted as in the new format.
[[nodiscard]] BlockBytes inFormat(const BlockBytes& block, BlockFormat from, BlockFormat to);

/// A part of a block that users can select.
struct BlockMark {
    enum class Kind : std::uint8_t { Texel, Color, Alpha, Field };
    Kind kind = Kind::Texel;
    std::size_t number = 0; ///< of the texel, of the index of a colour or an alpha, or in blockFields()

    bool operator==(const BlockMark&) const = default;
};

/// What belongs together: an index with its texel and its colour, a colour with the fields that it is made
/// from.
struct BlockLinks {
    std::bitset<16> texels;
    std::bitset<4> colors;
    std::bitset<16> alphas;
    std::bitset<36> fields; ///< DXT5 has the most: four ends, and two numbers per texel

    bool operator==(const BlockLinks&) const = default;
};

[[nodiscard]] BlockLinks linksOf(BlockFormat format, const BlockFields& fields, const BlockMark& mark);

/// The bytes in hexadecimal, two digits each, separated by spaces.
[[nodiscard]] std::string hexOf(BlockFormat format, const BlockBytes& block);
/// The inverse; spaces and commas are ignored. The error says what was expected and found.
[[nodiscard]] Result<BlockBytes> blockOfHex(BlockFormat format, std::string_view text);

/// The difference of two blocks: the root mean square of the differences of red, green and blue, and of alpha
/// if `withAlpha`, over the first `width` x `height` texels. 0 to 255.
[[nodiscard]] double rootMeanSquare(const std::array<BlockColor, 16>& a, const std::array<BlockColor, 16>& b,
                                    int width, int height, bool withAlpha);

} // namespace texplorer

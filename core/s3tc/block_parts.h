#pragma once

// What the bits of one block of DXT1, DXT3 or DXT5 mean, field by field: EXT_texture_compression_s3tc. A
// block is read as one little-endian number, whose bit 0 is the lowest of its first byte; texels are counted
// row by row from the one that is stored first.

#include "core/base/result.h"
#include "core/gl/block_format.h"

#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace texplorer {

/// A block; of DXT1 the first 8 bytes, and the others are 0.
using BlockBytes = std::array<std::byte, 16>;

enum class BlockPart : std::uint8_t {
    Color,      ///< an end colour: 5 bits of red, the highest ones, 6 of green, 5 of blue
    ColorIndex, ///< which of the four colours a texel has
    AlphaEnd,   ///< of DXT5
    Alpha,      ///< of DXT3 a texel's alpha itself, of DXT5 which of the eight it has
};

/// Neighbouring bits that are one number.
struct BlockField {
    BlockPart part = BlockPart::Color;
    int number = 0; ///< the end, 0 or 1, or the texel, 0 to 15
    int first = 0;  ///< its lowest bit
    int bits = 0;

    bool operator==(const BlockField&) const = default;
};

/// Every bit of a block belongs to one of them. In the order of their bits.
[[nodiscard]] std::span<const BlockField> blockFields(BlockFormat format);
[[nodiscard]] const BlockField& blockField(BlockFormat format, BlockPart part, int number);
/// Which of blockFields() has this bit.
[[nodiscard]] std::size_t fieldAtBit(BlockFormat format, int bit);

/// Bytes that have to be read as one number, because a field lies across them: one or more whole fields.
struct BlockBytesGroup {
    int first = 0; ///< byte
    int count = 0;
};

[[nodiscard]] std::span<const BlockBytesGroup> blockGroups(BlockFormat format);

[[nodiscard]] unsigned readField(const BlockBytes& block, const BlockField& field);
/// Bits of `value` beyond the field's are left out.
void writeField(BlockBytes& block, const BlockField& field, unsigned value);
void toggleBit(BlockBytes& block, int bit);

/// All fields as numbers.
struct BlockFields {
    std::array<std::uint16_t, 2> colors{};
    std::array<std::uint8_t, 16> indices{};
    std::array<std::uint8_t, 2> alphaEnds{}; ///< 0 but for DXT5
    std::array<std::uint8_t, 16> alphas{};   ///< 0 for DXT1

    bool operator==(const BlockFields&) const = default;
};

[[nodiscard]] BlockFields fieldsOf(BlockFormat format, const BlockBytes& block);
[[nodiscard]] BlockBytes blockOf(BlockFormat format, const BlockFields& fields);

/// Whether the indices 2 and 3 mean colours between the ends: else 2 is their mean and 3 is black, which the
/// RGBA format of DXT1 has transparent. DXT3 and DXT5 always have four.
[[nodiscard]] bool hasFourColors(BlockFormat format, const BlockFields& fields);
/// The same for the alphas of DXT5: else there are four between the ends, and 0 and 255.
[[nodiscard]] bool hasEightAlphas(const BlockFields& fields);

using BlockColor = std::array<std::uint8_t, 4>; ///< red, green, blue, alpha

/// What the colour indices mean, alpha included where DXT1 has it; as decodeBlock() has it.
[[nodiscard]] std::array<BlockColor, 4> colorsOf(BlockFormat format, const BlockFields& fields);

/// How many values a texel's alpha can have: 16 in DXT3, 8 in DXT5, 0 in DXT1.
[[nodiscard]] std::size_t alphaCount(BlockFormat format);
/// What BlockFields::alphas mean; as decodeBlock() has it. Those beyond alphaCount() are 0.
[[nodiscard]] std::array<std::uint8_t, 16> alphasOf(BlockFormat format, const BlockFields& fields);

[[nodiscard]] std::array<BlockColor, 16> texelsOf(BlockFormat format, const BlockBytes& block);

/// The colour of 5:6:5 bits that is nearest to one of 8 bits a component.
[[nodiscard]] std::uint16_t quantized(int red, int green, int blue);

/// The same colours and indices in another format. Alphas are those of the new format that are nearest to
/// the old ones; between DXT1 and the others the ends mean what they mean there.
[[nodiscard]] BlockBytes inFormat(const BlockBytes& block, BlockFormat from, BlockFormat to);

/// Something of a block that one can point at.
struct BlockMark {
    enum class Kind : std::uint8_t { Texel, Color, Alpha, Field };
    Kind kind = Kind::Texel;
    std::size_t number =
        0; ///< of the texel, of the index that means a colour or an alpha, or in blockFields()

    bool operator==(const BlockMark&) const = default;
};

/// What goes together: an index with its texel and the colour that it means, a colour with what it is made
/// of.
struct BlockLinks {
    std::bitset<16> texels;
    std::bitset<4> colors;
    std::bitset<16> alphas;
    std::bitset<36> fields; ///< DXT5 has most: four ends, and two numbers for each texel

    bool operator==(const BlockLinks&) const = default;
};

[[nodiscard]] BlockLinks linksOf(BlockFormat format, const BlockFields& fields, const BlockMark& mark);

/// The bytes in hexadecimal, two digits each, with blanks between.
[[nodiscard]] std::string hexOf(BlockFormat format, const BlockBytes& block);
/// The other way round; blanks and commas may stand anywhere. The error says what was expected and found.
[[nodiscard]] Result<BlockBytes> blockOfHex(BlockFormat format, std::string_view text);

/// How far two blocks are apart: the root of the mean square of the differences of red, green and blue, and
/// of alpha where `withAlpha`, over the first `width` x `height` texels. 0 to 255.
[[nodiscard]] double rootMeanSquare(const std::array<BlockColor, 16>& a, const std::array<BlockColor, 16>& b,
                                    int width, int height, bool withAlpha);

} // namespace texplorer

#include "texplorer/s3tc/block_parts.h"

#include "texplorer/s3tc/decode.h"

#include <fmt/core.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <vector>

namespace texplorer {
namespace {

struct BlockShape {
    std::vector<BlockField> fields;
    std::vector<BlockBytesGroup> groups;
};

// Colours, the last 8 bytes: |color 0: 16|color 1: 16|16 indices of 2 bits|
void addColors(BlockShape& shape, int firstByte) {
    const int first = 8 * firstByte;
    for (int end = 0; end < 2; ++end) {
        shape.fields.push_back({BlockPart::Color, end, first + 16 * end, 16});
        shape.groups.push_back({firstByte + 2 * end, 2});
    }
    for (int texel = 0; texel < 16; ++texel)
        shape.fields.push_back({BlockPart::ColorIndex, texel, first + 32 + 2 * texel, 2});
    for (int row = 0; row < 4; ++row)
        shape.groups.push_back({firstByte + 4 + row, 1});
}

// DXT3: |16 alphas of 4 bits|, a row in two bytes.
void addAlphas(BlockShape& shape) {
    for (int texel = 0; texel < 16; ++texel)
        shape.fields.push_back({BlockPart::Alpha, texel, 4 * texel, 4});
    for (int row = 0; row < 4; ++row)
        shape.groups.push_back({2 * row, 2});
}

// DXT5: |alpha 0: 8|alpha 1: 8|16 indices of 3 bits|, a row in a byte and a half.
void addAlphaIndices(BlockShape& shape) {
    for (int end = 0; end < 2; ++end) {
        shape.fields.push_back({BlockPart::AlphaEnd, end, 8 * end, 8});
        shape.groups.push_back({end, 1});
    }
    for (int texel = 0; texel < 16; ++texel)
        shape.fields.push_back({BlockPart::Alpha, texel, 16 + 3 * texel, 3});
    for (int rows = 0; rows < 2; ++rows)
        shape.groups.push_back({2 + 3 * rows, 3});
}

const BlockShape& shapeOf(BlockFormat format) {
    assert(isS3tc(format));
    static const std::array<BlockShape, 3> shapes = [] {
        std::array<BlockShape, 3> made;
        addColors(made[0], 0);
        addAlphas(made[1]);
        addColors(made[1], 8);
        addAlphaIndices(made[2]);
        addColors(made[2], 8);
        return made;
    }();
    return shapes[format == BlockFormat::Dxt5 ? 2 : format == BlockFormat::Dxt3 ? 1 : 0];
}

bool bitOf(const BlockBytes& block, int bit) {
    return (std::to_integer<int>(block[static_cast<std::size_t>(bit / 8)]) >> (bit % 8) & 1) != 0;
}

/// Five or six bits as decodeBlock() widens them.
int widened(int value, int bits) {
    return value << (8 - bits) | value >> (2 * bits - 8);
}

unsigned nearestOfBits(int value, int bits) {
    int nearest = 0;
    for (int i = 1; i < 1 << bits; ++i)
        if (std::abs(widened(i, bits) - value) < std::abs(widened(nearest, bits) - value))
            nearest = i;
    return static_cast<unsigned>(nearest);
}

/// A block with these ends, whose first texels have the indices 0, 1, 2 …
std::array<BlockColor, 16> decodedIndices(BlockFormat format, BlockFields fields) {
    for (std::uint8_t i = 0; i < 16; ++i) {
        fields.indices[i] = i & 3;
        fields.alphas[i] = format == BlockFormat::Dxt5 ? i & 7 : i;
    }
    return texelsOf(format, blockOf(format, fields));
}

} // namespace

std::span<const BlockField> blockFields(BlockFormat format) {
    return shapeOf(format).fields;
}

const BlockField& blockField(BlockFormat format, BlockPart part, int number) {
    const auto found = std::ranges::find_if(blockFields(format), [&](const BlockField& field) {
        return field.part == part && field.number == number;
    });
    assert(found != blockFields(format).end());
    return *found;
}

std::size_t fieldAtBit(BlockFormat format, int bit) {
    const std::span<const BlockField> fields = blockFields(format);
    const auto found = std::ranges::find_if(
        fields, [bit](const BlockField& field) { return bit < field.first + field.bits; });
    assert(found != fields.end());
    return static_cast<std::size_t>(found - fields.begin());
}

std::span<const BlockBytesGroup> blockGroups(BlockFormat format) {
    return shapeOf(format).groups;
}

unsigned readField(const BlockBytes& block, const BlockField& field) {
    unsigned value = 0;
    for (int i = 0; i < field.bits; ++i)
        value |= static_cast<unsigned>(bitOf(block, field.first + i)) << i;
    return value;
}

void writeField(BlockBytes& block, const BlockField& field, unsigned value) {
    for (int i = 0; i < field.bits; ++i)
        if (bitOf(block, field.first + i) != ((value >> i & 1) != 0))
            toggleBit(block, field.first + i);
}

void toggleBit(BlockBytes& block, int bit) {
    block[static_cast<std::size_t>(bit / 8)] ^= std::byte{1} << (bit % 8);
}

BlockFields fieldsOf(BlockFormat format, const BlockBytes& block) {
    BlockFields fields;
    for (const BlockField& field : blockFields(format)) {
        const unsigned value = readField(block, field);
        const auto number = static_cast<std::size_t>(field.number);
        switch (field.part) {
        case BlockPart::Color:
            fields.colors[number] = static_cast<std::uint16_t>(value);
            break;
        case BlockPart::ColorIndex:
            fields.indices[number] = static_cast<std::uint8_t>(value);
            break;
        case BlockPart::AlphaEnd:
            fields.alphaEnds[number] = static_cast<std::uint8_t>(value);
            break;
        case BlockPart::Alpha:
            fields.alphas[number] = static_cast<std::uint8_t>(value);
            break;
        }
    }
    return fields;
}

BlockBytes blockOf(BlockFormat format, const BlockFields& fields) {
    BlockBytes block{};
    for (const BlockField& field : blockFields(format)) {
        const auto number = static_cast<std::size_t>(field.number);
        switch (field.part) {
        case BlockPart::Color:
            writeField(block, field, fields.colors[number]);
            break;
        case BlockPart::ColorIndex:
            writeField(block, field, fields.indices[number]);
            break;
        case BlockPart::AlphaEnd:
            writeField(block, field, fields.alphaEnds[number]);
            break;
        case BlockPart::Alpha:
            writeField(block, field, fields.alphas[number]);
            break;
        }
    }
    return block;
}

bool hasFourColors(BlockFormat format, const BlockFields& fields) {
    const bool isDxt1 = format == BlockFormat::Dxt1 || format == BlockFormat::Dxt1Alpha;
    return !isDxt1 || fields.colors[0] > fields.colors[1];
}

bool hasEightAlphas(const BlockFields& fields) {
    return fields.alphaEnds[0] > fields.alphaEnds[1];
}

std::array<BlockColor, 4> colorsOf(BlockFormat format, const BlockFields& fields) {
    const std::array<BlockColor, 16> decoded = decodedIndices(format, fields);
    std::array<BlockColor, 4> colors{};
    std::copy_n(decoded.begin(), colors.size(), colors.begin());
    if (alphaCount(format) > 0)
        for (BlockColor& color : colors)
            color[3] = 255;
    return colors;
}

std::size_t alphaCount(BlockFormat format) {
    return format == BlockFormat::Dxt5 ? 8 : format == BlockFormat::Dxt3 ? 16 : 0;
}

std::array<std::uint8_t, 16> alphasOf(BlockFormat format, const BlockFields& fields) {
    const std::array<BlockColor, 16> decoded = decodedIndices(format, fields);
    std::array<std::uint8_t, 16> alphas{};
    for (std::size_t i = 0; i < alphaCount(format); ++i)
        alphas[i] = decoded[i][3];
    return alphas;
}

std::array<BlockColor, 16> texelsOf(BlockFormat format, const BlockBytes& block) {
    std::array<std::byte, 64> rgba{};
    decodeBlock(format, block.data(), rgba.data());
    std::array<BlockColor, 16> texels{};
    for (std::size_t i = 0; i < rgba.size(); ++i)
        texels[i / 4][i % 4] = std::to_integer<std::uint8_t>(rgba[i]);
    return texels;
}

std::uint16_t quantized(int red, int green, int blue) {
    return static_cast<std::uint16_t>(nearestOfBits(red, 5) << 11 | nearestOfBits(green, 6) << 5 |
                                      nearestOfBits(blue, 5));
}

BlockBytes inFormat(const BlockBytes& block, BlockFormat from, BlockFormat to) {
    BlockFields fields = fieldsOf(from, block);
    const std::array<BlockColor, 16> old = texelsOf(from, block);
    const auto [least, most] = std::ranges::minmax(old, {}, [](const BlockColor& color) { return color[3]; });
    fields.alphaEnds = {most[3], least[3]};
    const std::array<std::uint8_t, 16> alphas = alphasOf(to, fields);
    for (std::size_t texel = 0; texel < old.size(); ++texel) {
        const auto nearest = std::ranges::min_element(
            alphas.begin(), alphas.begin() + static_cast<std::ptrdiff_t>(alphaCount(to)), {},
            [&](std::uint8_t alpha) { return std::abs(alpha - old[texel][3]); });
        fields.alphas[texel] =
            alphaCount(to) > 0 ? static_cast<std::uint8_t>(nearest - alphas.begin()) : std::uint8_t{0};
    }
    return blockOf(to, fields);
}

std::string hexOf(BlockFormat format, const BlockBytes& block) {
    std::string text;
    for (std::size_t i = 0; i < bytesPerBlock(format); ++i)
        text += fmt::format("{}{:02X}", i > 0 ? " " : "", std::to_integer<int>(block[i]));
    return text;
}

Result<BlockBytes> blockOfHex(BlockFormat format, std::string_view text) {
    constexpr std::string_view digits = "0123456789abcdef";
    const std::size_t expected = 2 * bytesPerBlock(format);
    BlockBytes block{};
    std::size_t count = 0;
    for (const char each : text) {
        if (each == ' ' || each == ',')
            continue;
        const std::size_t digit =
            digits.find(each >= 'A' && each <= 'F' ? static_cast<char>(each - 'A' + 'a') : each);
        if (digit == std::string_view::npos)
            return fail(ErrorCode::Malformed,
                        Sentence("expected the digits 0 to 9 and A to F for a block of {0}, found \"{1}\"",
                                 rowOf(format).label, each));
        if (count < expected)
            block[count / 2] |= static_cast<std::byte>(digit << (count % 2 == 0 ? 4 : 0));
        ++count;
    }
    if (count != expected)
        return fail(ErrorCode::Malformed, Sentence("a block of {0} has {1} digits, found {2}",
                                                   rowOf(format).label, expected, count));
    return block;
}

double rootMeanSquare(const std::array<BlockColor, 16>& a, const std::array<BlockColor, 16>& b, int width,
                      int height, bool withAlpha) {
    const std::size_t components = withAlpha ? 4 : 3;
    double sum = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (std::size_t c = 0; c < components; ++c) {
                const auto texel = static_cast<std::size_t>(4 * y + x);
                const double apart = static_cast<double>(a[texel][c]) - static_cast<double>(b[texel][c]);
                sum += apart * apart;
            }
    return std::sqrt(sum / (static_cast<double>(width) * height * static_cast<double>(components)));
}

} // namespace texplorer

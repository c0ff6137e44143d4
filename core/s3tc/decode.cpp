#include "texplorer/s3tc/decode.h"

#include "texplorer/s3tc/decode_rows.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstring>

namespace texplorer {
namespace {

using Rgb = std::array<int, 3>;

int byteAt(const std::byte* block, int index) {
    return std::to_integer<int>(block[index]);
}

unsigned word(const std::byte* block, int index) {
    return static_cast<unsigned>(byteAt(block, index) | byteAt(block, index + 1) << 8);
}

/// 5:6:5 bits, red highest. Repeating the top bits below makes 31 and 63 become 255.
Rgb widen(unsigned color) {
    const int r = static_cast<int>(color >> 11 & 31);
    const int g = static_cast<int>(color >> 5 & 63);
    const int b = static_cast<int>(color & 31);
    return {r << 3 | r >> 2, g << 2 | g >> 4, b << 3 | b >> 2};
}

// |color 0: 16|color 1: 16|16 codes of 2 bits, the first row in the lowest byte, the left texel in its lowest
// bits|
void decodeColors(const std::byte* block, bool threeColorsAllowed, bool punchThrough, std::byte* rgba) {
    const unsigned first = word(block, 0);
    const unsigned second = word(block, 2);
    const Rgb a = widen(first);
    const Rgb b = widen(second);
    const bool fourColors = !threeColorsAllowed || first > second;
    std::array<std::array<int, 4>, 4> palette{};
    for (std::size_t c = 0; c < 3; ++c) {
        palette[0][c] = a[c];
        palette[1][c] = b[c];
        palette[2][c] = fourColors ? (2 * a[c] + b[c]) / 3 : (a[c] + b[c]) / 2;
        palette[3][c] = fourColors ? (a[c] + 2 * b[c]) / 3 : 0;
    }
    for (std::size_t i = 0; i < 4; ++i)
        palette[i][3] = i == 3 && !fourColors && punchThrough ? 0 : 255;
    for (int texel = 0; texel < 16; ++texel) {
        const int code = byteAt(block, 4 + texel / 4) >> (2 * (texel % 4)) & 3;
        for (std::size_t c = 0; c < 4; ++c)
            rgba[4 * static_cast<std::size_t>(texel) + c] =
                static_cast<std::byte>(palette[static_cast<std::size_t>(code)][c]);
    }
}

// |value 0: 8|value 1: 8|16 codes of 3 bits, the first texel in the lowest bits of a 48-bit little-endian
// number| value 0 > value 1: six values between them; else four, and the two ends of the range.
std::array<int, 16> decodeValues(const std::byte* block, bool isSigned) {
    const auto read = [&](int index) {
        const int value = byteAt(block, index);
        return isSigned && value > 127 ? value - 256 : value;
    };
    // Compared as they are stored, though -127 and -128 both stand for -1: the specification leaves that pair
    // undefined, and so it is -1 all over.
    const bool eightValues = read(0) > read(1);
    const int a = std::max(-127, read(0));
    const int b = std::max(-127, read(1));
    std::array<int, 8> palette{a, b};
    if (eightValues) {
        for (int i = 1; i <= 6; ++i)
            palette[static_cast<std::size_t>(i) + 1] = ((7 - i) * a + i * b) / 7;
    } else {
        for (int i = 1; i <= 4; ++i)
            palette[static_cast<std::size_t>(i) + 1] = ((5 - i) * a + i * b) / 5;
        palette[6] = isSigned ? -127 : 0;
        palette[7] = isSigned ? 127 : 255;
    }
    std::uint64_t codes = 0;
    for (int i = 0; i < 6; ++i)
        codes |= static_cast<std::uint64_t>(byteAt(block, 2 + i)) << (8 * i);
    std::array<int, 16> values{};
    for (std::size_t texel = 0; texel < 16; ++texel) {
        const int value = palette[codes >> (3 * texel) & 7];
        values[texel] = isSigned ? ((value + 127) * 255 + 127) / 254 : value;
    }
    return values;
}

} // namespace

void decodeBlock(BlockFormat format, const std::byte* block, std::byte* rgba) {
    switch (format) {
    case BlockFormat::Dxt1:
    case BlockFormat::Dxt1Alpha:
        decodeColors(block, true, format == BlockFormat::Dxt1Alpha, rgba);
        return;
    case BlockFormat::Dxt3:
        decodeColors(block + 8, false, false, rgba);
        for (int texel = 0; texel < 16; ++texel) // four bits a texel, 15 becomes 255
            rgba[4 * texel + 3] =
                static_cast<std::byte>((byteAt(block, texel / 2) >> (4 * (texel % 2)) & 15) * 17);
        return;
    case BlockFormat::Dxt5: {
        decodeColors(block + 8, false, false, rgba);
        const std::array<int, 16> alphas = decodeValues(block, false);
        for (std::size_t texel = 0; texel < 16; ++texel)
            rgba[4 * texel + 3] = static_cast<std::byte>(alphas[texel]);
        return;
    }
    case BlockFormat::Bc4:
    case BlockFormat::Bc4Signed: {
        const std::array<int, 16> values = decodeValues(block, format == BlockFormat::Bc4Signed);
        for (std::size_t texel = 0; texel < 16; ++texel) {
            std::fill_n(rgba + 4 * texel, 3, static_cast<std::byte>(values[texel]));
            rgba[4 * texel + 3] = std::byte{255};
        }
        return;
    }
    case BlockFormat::Bc5:
    case BlockFormat::Bc5Signed: {
        const bool isSigned = format == BlockFormat::Bc5Signed;
        const std::array<int, 16> reds = decodeValues(block, isSigned);
        const std::array<int, 16> greens = decodeValues(block + 8, isSigned);
        for (std::size_t texel = 0; texel < 16; ++texel) {
            rgba[4 * texel] = static_cast<std::byte>(reds[texel]);
            rgba[4 * texel + 1] = static_cast<std::byte>(greens[texel]);
            rgba[4 * texel + 2] = std::byte{0};
            rgba[4 * texel + 3] = std::byte{255};
        }
        return;
    }
    }
}

namespace {

template<BlockFormat format>
void decodeRowPlainly(const std::byte* blocks, std::size_t count, std::byte* rgba, std::size_t rowBytes) {
    std::array<std::byte, 64> texels;
    for (std::size_t i = 0; i < count; ++i) {
        decodeBlock(format, blocks + i * bytesPerBlock(format), texels.data());
        for (std::size_t row = 0; row < 4; ++row)
            std::memcpy(rgba + row * rowBytes + 16 * i, texels.data() + 16 * row, 16);
    }
}

} // namespace

RowDecoder plainRowDecoder(BlockFormat format) {
    switch (format) {
    case BlockFormat::Dxt1:
        return decodeRowPlainly<BlockFormat::Dxt1>;
    case BlockFormat::Dxt1Alpha:
        return decodeRowPlainly<BlockFormat::Dxt1Alpha>;
    case BlockFormat::Dxt3:
        return decodeRowPlainly<BlockFormat::Dxt3>;
    case BlockFormat::Dxt5:
        return decodeRowPlainly<BlockFormat::Dxt5>;
    case BlockFormat::Bc4:
        return decodeRowPlainly<BlockFormat::Bc4>;
    case BlockFormat::Bc4Signed:
        return decodeRowPlainly<BlockFormat::Bc4Signed>;
    case BlockFormat::Bc5:
        return decodeRowPlainly<BlockFormat::Bc5>;
    case BlockFormat::Bc5Signed:
        break;
    }
    return decodeRowPlainly<BlockFormat::Bc5Signed>;
}

void decodeBlocks(const BlockImage& image, std::span<std::byte> rgba) {
    const auto width = static_cast<std::size_t>(image.width);
    const auto height = static_cast<std::size_t>(image.height);
    assert(image.blocks.size() ==
           image.blockRowBytes() * image.blockRows() * static_cast<std::size_t>(image.depth));
    assert(rgba.size() == 4 * width * height * static_cast<std::size_t>(image.depth));
    const RowDecoder vectors = vectorRowDecoder(image.format);
    const RowDecoder decode = vectors ? vectors : plainRowDecoder(image.format);
    const std::size_t rowBytes = 4 * width;
    const std::byte* blocks = image.blocks.data();
    std::byte* pixels = rgba.data();
    std::array<std::byte, 64> texels;
    for (int z = 0; z < image.depth; ++z) {
        for (std::size_t top = 0; top < height; top += 4, blocks += image.blockRowBytes()) {
            const std::size_t rows = std::min<std::size_t>(4, height - top);
            const auto decodeCut = [&](std::size_t left) {
                decode(blocks + left / 4 * bytesPerBlock(image.format), 1, texels.data(), 16);
                for (std::size_t y = 0; y < rows; ++y)
                    std::memcpy(pixels + y * rowBytes + 4 * left, texels.data() + 16 * y,
                                4 * std::min<std::size_t>(4, width - left));
            };
            if (rows == 4) {
                decode(blocks, width / 4, pixels, rowBytes);
                if (width % 4 != 0)
                    decodeCut(width / 4 * 4);
            } else {
                for (std::size_t left = 0; left < width; left += 4)
                    decodeCut(left);
            }
            pixels += rows * rowBytes;
        }
    }
}

Image decodeBlocks(const BlockImage& image) {
    Image pixels = Image::uninitialised(PixelFormat::Rgba8, image.width, image.height, image.depth);
    decodeBlocks(image, pixels.pixels);
    return pixels;
}

} // namespace texplorer

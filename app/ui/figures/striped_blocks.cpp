#include "app/ui/figures/block_flip.h"

#include <algorithm>
#include <array>

namespace texplorer::ui {
namespace {

// From one end to the other: indices 1, 3, 2, 0, because color 0 must be the larger number for four colours.
constexpr std::array<std::uint8_t, 4> indexOfRow{1, 3, 2, 0};

struct StripeEnds {
    int from[3];
    int to[3];
};

constexpr std::array stripeEnds{StripeEnds{{200, 50, 40}, {255, 210, 40}},
                                StripeEnds{{40, 140, 60}, {40, 220, 230}},
                                StripeEnds{{70, 80, 220}, {230, 120, 230}}};

std::array<BlockColor, 4> rowOfTexels(const BlockImage& image, int row) {
    const std::array<BlockColor, 16> texels = texelsOf(image.format, blockAt(image, 0, row / 4));
    std::array<BlockColor, 4> found{};
    std::copy_n(texels.begin() + static_cast<std::ptrdiff_t>(row % 4) * 4, 4, found.begin());
    return found;
}

} // namespace

BlockImage stripedBlocks(BlockFormat format, int height) {
    BlockImage image = BlockImage::uninitialised(format, 4, height);
    for (std::size_t block = 0; block < image.blockRows(); ++block) {
        const StripeEnds& ends = stripeEnds.at(block % stripeEnds.size());
        BlockFields fields;
        fields.colors = {quantized(ends.to[0], ends.to[1], ends.to[2]),
                         quantized(ends.from[0], ends.from[1], ends.from[2])};
        if (format == BlockFormat::Dxt5)
            fields.alphaEnds = {static_cast<std::uint8_t>(255 - 20 * block),
                                static_cast<std::uint8_t>(40 + 20 * block)};
        for (std::size_t texel = 0; texel < 16; ++texel) {
            const std::size_t row = texel / 4;
            fields.indices[texel] = indexOfRow.at(row);
            if (format == BlockFormat::Dxt3)
                fields.alphas[texel] = static_cast<std::uint8_t>(15 - 4 * block - row);
            if (format == BlockFormat::Dxt5)
                fields.alphas[texel] = static_cast<std::uint8_t>(row == 0 ? 0 : 2 * row);
        }
        const BlockBytes bytes = blockOf(format, fields);
        std::copy_n(bytes.begin(), bytesPerBlock(format),
                    image.blocks.begin() + static_cast<std::ptrdiff_t>(block * bytesPerBlock(format)));
    }
    return image;
}

BlockBytes blockAt(const BlockImage& image, int blockX, int blockY) {
    const std::size_t size = bytesPerBlock(image.format);
    const std::size_t from =
        static_cast<std::size_t>(blockY) * image.blockRowBytes() + static_cast<std::size_t>(blockX) * size;
    BlockBytes block{};
    std::copy_n(image.blocks.begin() + static_cast<std::ptrdiff_t>(from), size, block.begin());
    return block;
}

int stripeAt(const BlockImage& image, const BlockImage& original, int row) {
    const auto rows = 4 * static_cast<int>(original.blockRows());
    for (int i = 0; i < rows; ++i)
        if (rowOfTexels(original, i) == rowOfTexels(image, row))
            return i;
    return -1;
}

} // namespace texplorer::ui

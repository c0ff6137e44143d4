#pragma once

// Access of the metrics to the two pictures: tiles of RGBA pixels with a margin.

#include "texplorer/compare/difference.h"
#include "texplorer/image/image.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace texplorer {

using PixelBytes = std::array<std::uint8_t, 4>;

/// Whether a mask pixel hides the pixel: black or fully transparent.
[[nodiscard]] constexpr bool isMasked(const PixelBytes& mask) {
    return mask[3] == 0 || (mask[0] == 0 && mask[1] == 0 && mask[2] == 0);
}

/// A rectangle of a picture, from its upper left.
struct Tile {
    int x;
    int y;
    int width;
    int height;
};

/// A tile of both pictures with `reach` pixels around it, from the upper left, without padding. Beyond the
/// edges, the nearest pixel repeats.
struct TilePixels {
    Tile tile{};
    int reach = 0;
    std::vector<PixelBytes> expected;
    std::vector<PixelBytes> actual;
    std::vector<std::uint8_t> counts; ///< of the tile without margin: 0 in the mask

    [[nodiscard]] int width() const { return tile.width + 2 * reach; }
    [[nodiscard]] int height() const { return tile.height + 2 * reach; }
    /// The index of a pixel of the tile in `expected` and `actual`.
    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y + reach) * static_cast<std::size_t>(width()) +
               static_cast<std::size_t>(x + reach);
    }
};

/// Two pictures of one size, and the mask. They must outlive the pair.
class PicturePair {
public:
    PicturePair(const Image& expected, const Image& actual, const Image* mask)
        : expected_(&expected)
        , actual_(&actual)
        , mask_(mask) {}

    [[nodiscard]] int width() const { return expected_->width; }
    [[nodiscard]] int height() const { return expected_->height; }

    /// Fills `pixels`, reusing its buffers. Masked pixels are the mean of both pictures in both, so metrics
    /// that look at neighbours find no difference there.
    void read(const Tile& tile, int reach, TilePixels& pixels) const;

    /// Whether every alpha of the rows from `first`, in the images' order, is 255.
    [[nodiscard]] bool isOpaque(int first, int count) const;

private:
    const Image* expected_;
    const Image* actual_;
    const Image* mask_;
};

} // namespace texplorer

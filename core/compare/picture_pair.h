#pragma once

// The two pictures as the metrics read them: pieces of RGBA pixels with what lies around them.

#include "core/compare/difference.h"
#include "core/image/image.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace texplorer {

using Rgba = std::array<std::uint8_t, 4>;

/// Whether a pixel of a mask hides the one behind it: black, or wholly transparent.
[[nodiscard]] constexpr bool isMasked(const Rgba& mask) {
    return mask[3] == 0 || (mask[0] == 0 && mask[1] == 0 && mask[2] == 0);
}

/// A piece of a picture, its upper left counted from the picture's.
struct Tile {
    int x;
    int y;
    int width;
    int height;
};

/// A tile of both pictures with `reach` pixels around it, from the upper left, without padding. Beyond the
/// pictures' edges the nearest pixel repeats.
struct TilePixels {
    Tile tile{};
    int reach = 0;
    std::vector<Rgba> expected;
    std::vector<Rgba> actual;
    std::vector<std::uint8_t> counts; ///< of the tile alone: 0 where the mask is

    [[nodiscard]] int width() const { return tile.width + 2 * reach; }
    [[nodiscard]] int height() const { return tile.height + 2 * reach; }
    /// Of a pixel of the tile, in `expected` and `actual`.
    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y + reach) * static_cast<std::size_t>(width()) +
               static_cast<std::size_t>(x + reach);
    }
};

/// Two pictures of one size, and the mask. It refers to them.
class PicturePair {
public:
    PicturePair(const Image& expected, const Image& actual, const Image* mask)
        : expected_(&expected)
        , actual_(&actual)
        , mask_(mask) {}

    [[nodiscard]] int width() const { return expected_->width; }
    [[nodiscard]] int height() const { return expected_->height; }

    /// Fills `pixels`, whose buffers are used again. Where a pixel doesn't count, both pictures have the mean
    /// of the two, so that a metric that looks around it finds no difference there.
    void read(const Tile& tile, int reach, TilePixels& pixels) const;

    /// Whether every alpha of the rows from `first`, counted as the images do, is 255.
    [[nodiscard]] bool isOpaque(int first, int count) const;

private:
    const Image* expected_;
    const Image* actual_;
    const Image* mask_;
};

} // namespace texplorer

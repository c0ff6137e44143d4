#pragma once

#include "texplorer/base/bytes.h"
#include "texplorer/image/pixel_format.h"

#include <cassert>
#include <cstddef>
#include <span>
#include <vector>

namespace texplorer {

/// width x height x depth pixels without padding between rows; a value type. As in OpenGL, row 0 is the
/// bottom row (t = 0), and slice 0 is at r = 0. A line has height 1, a picture depth 1.
struct Image {
    PixelFormat format = PixelFormat::Rgba8;
    int width = 0;
    int height = 0;
    int depth = 1;
    Bytes pixels; ///< byteCount() bytes

    /// Creates an image with uninitialised pixels, for a caller that then fills every byte.
    [[nodiscard]] static Image uninitialised(PixelFormat format, int width, int height, int depth = 1) {
        Image image{format, width, height, depth, {}};
        image.pixels.resize(image.byteCount());
        return image;
    }

    /// The size of `pixels`, or what it would be in an outline.
    [[nodiscard]] std::size_t byteCount() const {
        return rowBytes() * static_cast<std::size_t>(height) * static_cast<std::size_t>(depth);
    }
    [[nodiscard]] bool empty() const { return pixels.empty(); }
    [[nodiscard]] std::size_t rowBytes() const {
        return static_cast<std::size_t>(width) * static_cast<std::size_t>(bytesPerPixel(format));
    }
    /// The bytes of the pixel at column x, row y (0 is the bottom), slice z.
    [[nodiscard]] std::span<std::byte> at(int x, int y, int z = 0) {
        return {pixels.data() + offset(x, y, z), static_cast<std::size_t>(bytesPerPixel(format))};
    }
    [[nodiscard]] ByteView at(int x, int y, int z = 0) const {
        return {pixels.data() + offset(x, y, z), static_cast<std::size_t>(bytesPerPixel(format))};
    }

    bool operator==(const Image&) const = default;

    /// The offset of that pixel in `pixels`.
    [[nodiscard]] std::size_t offset(int x, int y, int z) const {
        assert(x >= 0 && x < width && y >= 0 && y < height && z >= 0 && z < depth);
        const auto rows =
            static_cast<std::size_t>(z) * static_cast<std::size_t>(height) + static_cast<std::size_t>(y);
        return rows * rowBytes() +
               static_cast<std::size_t>(x) * static_cast<std::size_t>(bytesPerPixel(format));
    }
};

/// Level 0 first. In a complete chain, each next level has max(1, floor(n / 2)) of every extent.
using MipChain = std::vector<Image>;

} // namespace texplorer

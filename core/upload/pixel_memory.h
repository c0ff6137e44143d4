#pragma once

// Pixels in a program's memory, and how OpenGL reads them there: OpenGL 2.1, section 3.6.4.

#include "texplorer/base/result.h"
#include "texplorer/gl/transfer.h"
#include "texplorer/image/image.h"

#include <glm/vec4.hpp>

#include <cstddef>
#include <cstdint>

namespace texplorer {

/// The components of a pixel, and the type of their numbers.
struct PixelLayout {
    TransferFormat format = TransferFormat::Rgba;
    TransferType type = TransferType::UnsignedByte;

    bool operator==(const PixelLayout&) const = default;
};

/// glPixelStorei, with OpenGL's initial values (table 3.1).
struct Unpacking {
    int alignment = 4;  ///< in bytes; OpenGL takes 1, 2, 4 and 8, and other values change nothing
    int rowLength = 0;  ///< in pixels; 0: the image's width
    int skipRows = 0;   ///< in pixels
    int skipPixels = 0; ///< in pixels
    bool swapBytes = false;

    bool operator==(const Unpacking&) const = default;
};

/// What glTexImage is told of the memory, and glPixelTransferf of the components.
struct UploadCall {
    PixelLayout layout{};
    Unpacking unpacking{};
    glm::vec4 scale{1};
    glm::vec4 bias{0};

    bool operator==(const UploadCall&) const = default;
};

struct PixelExtent {
    int width = 0;
    int height = 1;
    int depth = 1;

    bool operator==(const PixelExtent&) const = default;
};

/// The value that glPixelStorei leaves: 4 for another number than 1, 2, 4 and 8, which is GL_INVALID_VALUE.
[[nodiscard]] int effectiveAlignment(int alignment);

/// GL_INVALID_OPERATION: a packed type with a format of another number of components.
[[nodiscard]] Result<void> checkLayout(const PixelLayout& layout);

[[nodiscard]] int bytesPerPixel(const PixelLayout& layout);

/// From the start of a row to the start of the next: equation 3.13.
[[nodiscard]] std::size_t rowStride(const UploadCall& call, int width);

struct ByteRange {
    std::size_t first = 0;
    std::size_t count = 0;

    [[nodiscard]] std::size_t end() const { return first + count; }
    bool operator==(const ByteRange&) const = default;
};

/// Where OpenGL reads the pixel at column x, row y (0 is the first in memory), slice z.
[[nodiscard]] ByteRange bytesOf(const UploadCall& call, const PixelExtent& extent, int x, int y, int z = 0);

/// How many bytes the memory must have: the end of the last pixel. 64 bits: extents may be hostile.
[[nodiscard]] std::uint64_t bytesRead(const UploadCall& call, const PixelExtent& extent);

/// What OpenGL makes of the memory: Rgba8, or Depth32 for GL_DEPTH_COMPONENT. It is never read beyond its
/// end; bytes there, where OpenGL's result is undefined, count as 0. Signed numbers are converted as
/// table 2.9 says, (2c + 1) / (2^b - 1); components are scaled, biased, limited to 0 … 1, and rounded to 8
/// bits; `asFloats`: neither limited nor rounded, as RgbaFloat. The layout has passed checkLayout().
[[nodiscard]] Image readPixels(ByteView memory, const UploadCall& call, const PixelExtent& extent,
                               bool asFloats = false);

/// The same memory for a call without swapBytes: the bytes of each number in reverse order.
[[nodiscard]] Bytes withSwappedBytes(ByteView memory, TransferType type);

/// The memory that holds an image: each row begins at a multiple of `alignment` bytes, and bytes between rows
/// are 0. Luminance is that of texplorer/image/preparation.h, a depth is red. The opposite of readPixels()
/// for a call that fits, as far as the type has the bits.
[[nodiscard]] Bytes writePixels(const Image& image, const PixelLayout& layout, int alignment);

} // namespace texplorer

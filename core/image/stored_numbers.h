#pragma once

// What a texture keeps of an image's components where its internal format has few bits.

#include "core/gl/internal_format.h"
#include "core/image/image.h"

namespace texplorer {

/// The largest number of so many bits, 1 to 8.
[[nodiscard]] constexpr int largestNumber(int bits) {
    return (1 << bits) - 1;
}

/// The number that is stored for a component of 8 bits: OpenGL 2.1, section 2.14.9, c times the largest
/// number, to the nearest. There are no ties: 255 is odd.
[[nodiscard]] constexpr int storedNumber(int byte, int bits) {
    return (2 * byte * largestNumber(bits) + 255) / 510;
}

/// The byte that is nearest to what a stored number stands for. storedNumber() gives the number back.
[[nodiscard]] constexpr int byteOf(int number, int bits) {
    return (2 * number * 255 + largestNumber(bits)) / (2 * largestNumber(bits));
}

/// The image with every component that `format` keeps in fewer than 8 bits rounded to them, as Rgba8; an
/// image for another format is returned as it is.
[[nodiscard]] Image withStoredNumbers(const Image& image, InternalFormat format);

} // namespace texplorer

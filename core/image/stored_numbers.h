#pragma once

// What a texture stores of an image's components if its internal format has few bits.

#include "texplorer/gl/internal_format.h"
#include "texplorer/image/image.h"

namespace texplorer {

/// The largest number of so many bits, 1 to 16.
[[nodiscard]] constexpr int maxNumber(int bits) {
    return (1 << bits) - 1;
}

/// The number that is stored for a component of 8 bits: OpenGL 2.1, section 2.14.9, c times the largest
/// number, rounded to nearest. There are no ties, as 255 is odd.
[[nodiscard]] constexpr int storedNumber(int byte, int bits) {
    return (2 * byte * maxNumber(bits) + 255) / 510;
}

/// The byte nearest to the value of a stored number. storedNumber() converts it back.
[[nodiscard]] constexpr int byteOf(int number, int bits) {
    return (2 * number * 255 + maxNumber(bits)) / (2 * maxNumber(bits));
}

/// Rounds every component that `format` stores with fewer than 8 bits, as Rgba8; for other formats, returns
/// the image unchanged.
[[nodiscard]] Image withStoredNumbers(const Image& image, InternalFormat format);

} // namespace texplorer

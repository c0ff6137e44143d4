#pragma once

// The difference of two pictures in numbers.

#include "texplorer/base/result.h"
#include "texplorer/image/image.h"

#include <glm/vec2.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace texplorer {

/// The components that are compared.
enum class Compared : std::uint8_t {
    Rgba, ///< alpha like the others: the content of a framebuffer
    Rgb,  ///< the visible colours of a picture that is shown opaque
};

/// All values are absolute differences of a component, in units of 1/255. A pixel's difference is that of its
/// worst component.
struct Difference {
    int max = 0;
    double mean = 0;      ///< over all compared components of all pixels
    std::size_t over = 0; ///< pixels that differ by more than the tolerance
    std::size_t pixels = 0;
    glm::ivec2 worst{0};                      ///< the first pixel that differs by `max`; row 0 is the bottom
    std::array<std::size_t, 256> histogram{}; ///< number of pixels by difference

    /// The share of pixels, 0 to 1; 0 if there are none.
    [[nodiscard]] double shareOver() const {
        return pixels == 0 ? 0 : static_cast<double>(over) / static_cast<double>(pixels);
    }
    /// Counts the pixels that differ by more than another tolerance.
    [[nodiscard]] std::size_t countOver(int tolerance) const;
};

/// Compares two Rgba8 pictures of the same size. Errors: Unsupported for another format, OutOfRange for
/// different sizes.
[[nodiscard]] Result<Difference> compare(const Image& a, const Image& b, int tolerance,
                                         Compared compared = Compared::Rgba);

} // namespace texplorer

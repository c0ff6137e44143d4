#pragma once

// How far two pictures are apart, in numbers.

#include "core/base/result.h"
#include "core/image/image.h"

#include <glm/vec2.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace texplorer {

/// Which components of a pixel are compared.
enum class Compared : std::uint8_t {
    Rgba, ///< alpha counts as the others do: what a renderer leaves in the framebuffer
    Rgb,  ///< what one sees of a picture that is shown opaque
};

/// All differences are absolute ones of a component, in 255ths. A pixel's difference is that of its worst
/// component.
struct Difference {
    int max = 0;
    double mean = 0;      ///< over all components that are compared, of all pixels
    std::size_t over = 0; ///< pixels that differ by more than the tolerance
    std::size_t pixels = 0;
    glm::ivec2 worst{0};                      ///< the first pixel that differs by `max`; row 0 is the bottom
    std::array<std::size_t, 256> histogram{}; ///< pixels by their difference

    /// Of the pixels, 0 to 1; 0 where there is none.
    [[nodiscard]] double shareOver() const {
        return pixels == 0 ? 0 : static_cast<double>(over) / static_cast<double>(pixels);
    }
    /// Pixels that differ by more than any other tolerance than the one it was made with.
    [[nodiscard]] std::size_t countOver(int tolerance) const;
};

/// Two Rgba8 pictures of the same size. Errors: Unsupported for another format, OutOfRange for two sizes.
[[nodiscard]] Result<Difference> compare(const Image& a, const Image& b, int tolerance,
                                         Compared compared = Compared::Rgba);

} // namespace texplorer

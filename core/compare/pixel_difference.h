#pragma once

#include "texplorer/compare/difference.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

namespace texplorer {

/// The differences of a pixel's components: the largest, and the sum.
struct PixelDifference {
    int worst;
    int sum;
};

/// Of two pixels of so many bytes.
[[nodiscard]] inline PixelDifference differenceOf(const std::uint8_t* a, const std::uint8_t* b,
                                                  std::size_t components) {
    PixelDifference result{0, 0};
    for (std::size_t i = 0; i < components; ++i) {
        const int each = std::abs(int{a[i]} - int{b[i]});
        result.worst = std::max(result.worst, each);
        result.sum += each;
    }
    return result;
}

/// The number of components of an Rgba8 pixel that are compared.
[[nodiscard]] constexpr std::size_t componentsOf(Compared compared) {
    return compared == Compared::Rgba ? 4 : 3;
}

} // namespace texplorer

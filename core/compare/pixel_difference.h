#pragma once

#include "core/base/result.h"
#include "core/compare/difference.h"
#include "core/image/image.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>

namespace texplorer {

/// Two Rgba8 pictures of the same size, or an error that says what they are.
[[nodiscard]] Result<void> checkComparable(const Image& a, const Image& b);

/// The differences of one pixel's components: the worst, and their sum.
struct PixelDifference {
    int worst;
    int sum;
};

inline PixelDifference differenceAt(const Image& a, const Image& b, std::size_t pixel, int components) {
    PixelDifference result{0, 0};
    for (std::size_t i = pixel * 4; i < pixel * 4 + static_cast<std::size_t>(components); ++i) {
        const int each = std::abs(std::to_integer<int>(a.pixels[i]) - std::to_integer<int>(b.pixels[i]));
        result.worst = std::max(result.worst, each);
        result.sum += each;
    }
    return result;
}

[[nodiscard]] inline int componentsOf(Compared compared) {
    return compared == Compared::Rgba ? 4 : 3;
}

} // namespace texplorer

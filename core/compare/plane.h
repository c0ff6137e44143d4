#pragma once

#include "texplorer/compare/row_filter.h"

#include <cstddef>
#include <span>
#include <vector>

namespace texplorer {

/// A number for each pixel of a tile, as working memory. Its rows are padded as filterRow needs.
class Plane {
public:
    /// The maximum size.
    Plane(int width, int height)
        : stride_(paddedWidth(width) + 8)
        , floats_(static_cast<std::size_t>(stride_) * static_cast<std::size_t>(height) + 8) {}

    [[nodiscard]] float* row(int y) { return floats_.data() + static_cast<std::ptrdiff_t>(stride_) * y; }
    [[nodiscard]] const float* row(int y) const {
        return floats_.data() + static_cast<std::ptrdiff_t>(stride_) * y;
    }
    [[nodiscard]] std::ptrdiff_t stride() const { return stride_; }

private:
    int stride_;
    std::vector<float> floats_;
};

/// Filters rows [0, height) of `out`; the first tap of a pixel is `first` columns to its right.
inline void filterAcross(const Plane& in, int first, std::span<const float> taps, Plane& out, int width,
                         int height) {
    for (int y = 0; y < height; ++y)
        filterRow(in.row(y) + first, 1, taps, out.row(y), width);
}

} // namespace texplorer

#pragma once

#include "texplorer/compare/comparison.h"

#include <cstdint>
#include <span>
#include <vector>

namespace texplorer {

/// A bit for every pixel. Rows begin with a new word, so tiles whose width is a multiple of 64 share no
/// words.
class PixelBits {
public:
    PixelBits(int width, int height)
        : words_((static_cast<std::size_t>(width) + 63) / 64)
        , bits_(words_ * static_cast<std::size_t>(height)) {}

    void set(int x, int y) {
        bits_[static_cast<std::size_t>(y) * words_ + static_cast<std::size_t>(x) / 64] |=
            std::uint64_t{1} << (static_cast<unsigned>(x) % 64U);
    }
    [[nodiscard]] std::span<const std::uint64_t> row(int y) const {
        return std::span(bits_).subspan(static_cast<std::size_t>(y) * words_, words_);
    }

private:
    std::size_t words_;
    std::vector<std::uint64_t> bits_;
};

struct Regions {
    std::size_t count = 0;
    std::vector<DifferentRegion> largest; ///< those with the most pixels; among equals, the upper ones
};

/// Finds the connected regions of set pixels in `rows` (sides or corners touch). Needs memory for one row.
[[nodiscard]] Regions regionsIn(const PixelBits& bits, const PixelRect& rows, std::size_t kept);

} // namespace texplorer

#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace texplorer::animation {

/// Colours, 0xFFRRGGBB.
using Palette = std::vector<std::uint32_t>;

/// At most `most` colours for these pixels, 0xFFRRGGBB: their own where there are no more, else those with
/// small squared errors. First by cutting the colour cube where it pays most (Xiaolin Wu, "Efficient
/// Statistical Computations for Optimal Color Quantization", Graphics Gems II, 1991), then by moving each to
/// the middle of those that are nearest to it (Lloyd's algorithm). Empty where there are no pixels.
[[nodiscard]] Palette paletteFor(std::span<const std::uint32_t> pixels, std::size_t most);

/// Which colour of a palette is nearest, quickly: known for cells of 4 x 4 x 4 values, as that of their
/// middle, once one of them was asked for. A colour that the palette has is found as itself.
class NearestColor {
public:
    explicit NearestColor(const Palette& palette);

    [[nodiscard]] std::size_t of(int red, int green, int blue);

private:
    [[nodiscard]] std::size_t search(int red, int green, int blue) const;

    struct Color {
        int red;
        int green;
        int blue;
    };
    std::vector<Color> colors_;
    std::vector<std::int16_t> cells_; ///< -1: not known yet
};

} // namespace texplorer::animation

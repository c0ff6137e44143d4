#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace texplorer::animation {

/// Colours, 0xFFRRGGBB.
using Palette = std::vector<std::uint32_t>;

/// Returns at most `maxColors` colours for these pixels, as 0xFFRRGGBB: exactly the pixels' colours if they
/// are few enough, else colours with small squared errors. The colour cube is cut where the error falls most
/// (Xiaolin Wu, "Efficient Statistical Computations for Optimal Color Quantization", Graphics Gems II, 1991),
/// then each colour is moved to the mean of the pixels nearest to it (Lloyd's algorithm). Empty for no
/// pixels.
[[nodiscard]] Palette paletteFor(std::span<const std::uint32_t> pixels, std::size_t maxColors);

/// Finds the nearest colour of a palette. Results are cached per cell of 4 x 4 x 4 values, for the cell's
/// centre. Colours of the palette are found exactly.
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
    std::vector<std::int16_t> cells_; ///< -1: not computed yet
};

} // namespace texplorer::animation

#pragma once

#include "texplorer/image/image.h"

#include <array>
#include <cstdint>

namespace texplorer {

using Color = std::array<std::uint8_t, 4>; ///< red, green, blue, alpha

/// Rounds to nearest and clamps to 0 … 255.
[[nodiscard]] std::uint8_t toByte(float value);

/// `from` at 0, `to` at 1; the amount is clamped to [0, 1].
[[nodiscard]] Color mix(Color from, Color to, float amount);

/// The colour times a factor; alpha stays.
[[nodiscard]] Color shade(Color color, float factor);

/// An Rgba8 image to draw on; y grows upwards. Pixels outside are clipped.
class Canvas {
public:
    Canvas(int width, int height, int depth = 1);

    void set(int x, int y, Color color) { set(x, y, 0, color); }
    void set(int x, int y, int z, Color color);
    [[nodiscard]] Color get(int x, int y, int z = 0) const; ///< inside of the image only

    void blend(int x, int y, Color color,
               float amount); ///< over the existing colour; its alpha grows accordingly
    void fill(int x, int y, int width, int height, Color color);

    [[nodiscard]] Image take() && { return std::move(image_); }

private:
    Image image_;
};

} // namespace texplorer

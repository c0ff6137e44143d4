#include "texplorer/image/patterns/canvas.h"

#include <algorithm>

namespace texplorer {

std::uint8_t toByte(float value) {
    return static_cast<std::uint8_t>(std::clamp(value + 0.5F, 0.0F, 255.0F));
}

Color mix(Color from, Color to, float amount) {
    const float share = std::clamp(amount, 0.0F, 1.0F);
    Color mixed{};
    for (std::size_t i = 0; i < mixed.size(); ++i)
        mixed[i] = toByte(static_cast<float>(from[i]) * (1 - share) + static_cast<float>(to[i]) * share);
    return mixed;
}

Color shade(Color color, float factor) {
    for (std::size_t i = 0; i < 3; ++i)
        color[i] = toByte(static_cast<float>(color[i]) * factor);
    return color;
}

Canvas::Canvas(int width, int height, int depth)
    : image_(Image::uninitialised(PixelFormat::Rgba8, width, height, depth)) {
    std::ranges::fill(image_.pixels, std::byte{0});
}

void Canvas::set(int x, int y, int z, Color color) {
    if (x < 0 || x >= image_.width || y < 0 || y >= image_.height || z < 0 || z >= image_.depth)
        return;
    std::ranges::transform(color, image_.at(x, y, z).begin(), [](std::uint8_t c) { return std::byte{c}; });
}

Color Canvas::get(int x, int y, int z) const {
    Color color{};
    std::ranges::transform(image_.at(x, y, z), color.begin(),
                           [](std::byte b) { return std::to_integer<std::uint8_t>(b); });
    return color;
}

void Canvas::blend(int x, int y, Color color, float amount) {
    if (x < 0 || x >= image_.width || y < 0 || y >= image_.height)
        return;
    const float share = std::clamp(amount, 0.0F, 1.0F);
    const Color below = get(x, y);
    Color mixed = mix(below, color, share);
    mixed[3] = toByte(static_cast<float>(below[3]) + (255.0F - static_cast<float>(below[3])) * share);
    set(x, y, mixed);
}

void Canvas::fill(int x, int y, int width, int height, Color color) {
    for (int row = y; row < y + height; ++row)
        for (int column = x; column < x + width; ++column)
            set(column, row, color);
}

} // namespace texplorer

#include "core/image/pattern.h"
#include "core/image/patterns/canvas.h"
#include "core/image/patterns/patterns.h"

namespace texplorer {

std::array<std::uint8_t, 4> mipColor(int level) {
    constexpr Color colors[] = {
        {230, 40, 40, 255},  {245, 140, 30, 255}, {250, 225, 50, 255}, {60, 180, 75, 255},
        {60, 200, 220, 255}, {50, 90, 220, 255},  {145, 70, 200, 255}, {255, 255, 255, 255},
    };
    return colors[static_cast<unsigned>(level) % std::size(colors)];
}

// 128 texels a side make a chain of exactly eight levels, so that no colour appears twice.
Image drawMipColors() {
    constexpr int size = 128;
    Canvas canvas(size, size);
    canvas.fill(0, 0, size, size, mipColor(0));
    return std::move(canvas).take();
}

} // namespace texplorer

#include "texplorer/image/patterns/canvas.h"
#include "texplorer/image/patterns/patterns.h"

namespace texplorer {

// The position is the colour: texel (x, y) has red x and green y.
Image drawGradient() {
    constexpr int size = 256;
    Canvas canvas(size, size);
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const auto byte = [](int value) { return static_cast<std::uint8_t>(value); };
            canvas.set(x, y, {byte(x), byte(y), byte(size - 1 - (x + y) / 2), 255});
        }
    }
    return std::move(canvas).take();
}

} // namespace texplorer

#include "texplorer/image/patterns/canvas.h"
#include "texplorer/image/patterns/patterns.h"

namespace texplorer {

// The corners of the RGB cube: between two neighbours a linear filter gives numbers that one can check by
// head.
Image drawColorLine() {
    constexpr Color corners[] = {
        {255, 0, 0, 255}, {255, 255, 0, 255}, {0, 255, 0, 255},     {0, 255, 255, 255},
        {0, 0, 255, 255}, {255, 0, 255, 255}, {255, 255, 255, 255}, {0, 0, 0, 255},
    };
    Canvas canvas(static_cast<int>(std::size(corners)), 1);
    for (int x = 0; x < static_cast<int>(std::size(corners)); ++x)
        canvas.set(x, 0, corners[x]);
    return std::move(canvas).take();
}

} // namespace texplorer

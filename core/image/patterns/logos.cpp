#include "texplorer/base/translatable.h"
#include "texplorer/image/patterns/canvas.h"
#include "texplorer/image/patterns/patterns.h"
#include "texplorer/image/patterns/pixel_font.h"

#include <algorithm>

namespace texplorer {

namespace {

constexpr int logoWidth = 128;
constexpr int logoHeight = 64;

// A plate with round corners that one sees through, and a frame and words that one doesn't.
Canvas drawPlate(Color plate) {
    constexpr int radius = 12;
    Canvas canvas(logoWidth, logoHeight);
    for (int y = 0; y < logoHeight; ++y)
        for (int x = 0; x < logoWidth; ++x) {
            const int inX = std::max({radius - x, x - (logoWidth - 1 - radius), 0});
            const int inY = std::max({radius - y, y - (logoHeight - 1 - radius), 0});
            const int away = inX * inX + inY * inY;
            const bool outside = away > radius * radius;
            const bool frame = away > (radius - 3) * (radius - 3) || std::min(x, logoWidth - 1 - x) < 3 ||
                               std::min(y, logoHeight - 1 - y) < 3;
            Color color = plate;
            color[3] = outside ? 0 : frame ? 255 : 128;
            canvas.set(x, y, color);
        }
    return canvas;
}

void drawCentred(Canvas& canvas, int y, int scale, std::string_view word) {
    const int x = (logoWidth - scale * textWidth(word)) / 2;
    drawText(canvas, x, y, scale, word, {255, 255, 255, 255});
}

} // namespace

Image drawLogoOpenGl() {
    Canvas canvas = drawPlate({36, 78, 148, 255});
    drawCentred(canvas, 22, 3, N_("OpenGL"));
    return std::move(canvas).take();
}

Image drawLogoMultitexture() {
    Canvas canvas = drawPlate({150, 66, 38, 255});
    drawCentred(canvas, 37, 2, N_("Multi-"));
    drawCentred(canvas, 14, 2, "texture");
    return std::move(canvas).take();
}

} // namespace texplorer

#include "texplorer/image/patterns/canvas.h"
#include "texplorer/image/patterns/patterns.h"
#include "texplorer/image/patterns/pixel_font.h"

#include <string>

namespace texplorer {

namespace {

constexpr int templateSize = 512;
constexpr int cells = 4;
constexpr int cell = templateSize / cells;
constexpr int strip = 30; // what the arrows take along the lower and the left edge

constexpr Color ink{38, 42, 52, 255};
constexpr Color sColor{204, 32, 40, 255};
constexpr Color tColor{14, 124, 52, 255};
constexpr std::string_view ticks[cells] = {"0", "0.25", "0.5", "0.75"};

// Every cell has a tint of its own: columns differ in hue, rows in lightness, and neighbours as on a
// chessboard.
Color tint(int column, int row) {
    constexpr Color hues[cells] = {
        {255, 204, 128, 255}, {174, 214, 148, 255}, {138, 202, 232, 255}, {212, 170, 226, 255}};
    const Color paler = mix(hues[column], {255, 255, 255, 255}, 0.62F - 0.16F * static_cast<float>(row));
    return shade(paler, (column + row) % 2 == 0 ? 1.0F : 0.90F);
}

void drawGrid(Canvas& canvas) {
    for (int y = 0; y < templateSize; ++y)
        for (int x = 0; x < templateSize; ++x) {
            const Color base = tint(x / cell, y / cell);
            const bool fine = x % (cell / 4) == 0 || y % (cell / 4) == 0;
            const bool strong = x % cell < 2 || y % cell < 2;
            canvas.set(x, y, strong ? ink : shade(base, fine ? 0.86F : 1.0F));
        }
}

void drawCellLabels(Canvas& canvas) {
    for (int row = 0; row < cells; ++row)
        for (int column = 0; column < cells; ++column) {
            // In the middle, but clear of the arrows.
            const int x = column * cell + (column == 0 ? strip + 6 : 23);
            const int y = row * cell + (row == 0 ? strip + 5 : 23);
            const std::string name{static_cast<char>('A' + column), static_cast<char>('1' + row)};
            drawText(canvas, x, y, 3, "t " + std::string(ticks[row]), tColor);
            drawText(canvas, x, y + 25, 3, "s " + std::string(ticks[column]), sColor);
            drawText(canvas, x, y + 52, 5, name, ink);
        }
}

// An arrow along `s` (or, with the axes swapped, along t) in the strip at the edge, its letter behind its
// head.
template<class Plot>
void drawArrow(Plot plot, int tip) {
    constexpr int middle = strip / 2 + 1;
    constexpr int headLength = 30;
    for (int along = 8; along < tip; ++along) {
        const int fromTip = tip - along;
        const int half = fromTip <= headLength ? fromTip * 12 / headLength : 4;
        for (int across = middle - half; across <= middle + half; ++across)
            plot(along, across);
    }
}

} // namespace

Image drawUvTemplate() {
    Canvas canvas(templateSize, templateSize);
    drawGrid(canvas);
    drawCellLabels(canvas);
    drawArrow([&](int along, int across) { canvas.set(along, across, sColor); }, templateSize - 40);
    drawArrow([&](int along, int across) { canvas.set(across, along, tColor); }, templateSize - 44);
    drawText(canvas, templateSize - 33, 4, 5, "s", sColor);
    drawText(canvas, 6, templateSize - 40, 5, "t", tColor);
    return std::move(canvas).take();
}

} // namespace texplorer

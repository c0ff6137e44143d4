#include "app/ui/widgets/board.h"

#include "app/ui/widgets/palette.h"

#include <algorithm>
#include <cmath>

namespace texplorer::ui {

void drawBoard(ImDrawList& draw, ImVec2 low, ImVec2 high, float cell) {
    constexpr float mostCells = 4000; // every second one is a rectangle of four vertices
    cell = std::max(cell, std::sqrt((high.x - low.x) * (high.y - low.y) / mostCells));
    draw.AddRectFilled(low, high, color::board);
    for (int row = 0; low.y + static_cast<float>(row) * cell < high.y; ++row) {
        const float y = low.y + static_cast<float>(row) * cell;
        for (int column = row % 2; low.x + static_cast<float>(column) * cell < high.x; column += 2) {
            const float x = low.x + static_cast<float>(column) * cell;
            draw.AddRectFilled({x, y}, {std::min(x + cell, high.x), std::min(y + cell, high.y)},
                               color::boardLight);
        }
    }
}

} // namespace texplorer::ui

#include "app/ui/widgets/board.h"

#include "app/ui/widgets/theme.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace texplorer::ui {

void drawBoard(ImDrawList& draw, ImVec2 low, ImVec2 high, float cell) {
    constexpr float maxCells = 4000; // every second one is a rectangle of four vertices
    cell = std::max(cell, std::sqrt((high.x - low.x) * (high.y - low.y) / maxCells));
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

void drawCheckered(ImDrawList& draw, ImVec2 low, ImVec2 high, glm::vec4 color) {
    const glm::vec4 c = glm::clamp(color, 0.0F, 1.0F);
    const auto over = [&](ImU32 board) {
        const ImVec4 below = ImGui::ColorConvertU32ToFloat4(board);
        const glm::vec4 mixed = glm::mix(glm::vec4(below.x, below.y, below.z, 1), c, c.a);
        return ImGui::ColorConvertFloat4ToU32({mixed.r, mixed.g, mixed.b, 1});
    };
    draw.AddRectFilled(low, high, over(color::board));
    if (c.a >= 1)
        return;
    const ImVec2 middle((low.x + high.x) / 2, (low.y + high.y) / 2);
    draw.AddRectFilled(low, middle, over(color::boardLight));
    draw.AddRectFilled(middle, high, over(color::boardLight));
}

} // namespace texplorer::ui

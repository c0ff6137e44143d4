#include "app/ui/widgets/checkered.h"

#include "app/ui/widgets/theme.h"

#include <glm/common.hpp>

namespace texplorer::ui {

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

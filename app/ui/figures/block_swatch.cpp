#include "app/ui/figures/block_swatch.h"

#include "app/ui/widgets/board.h"
#include "app/ui/widgets/points.h"
#include "app/ui/widgets/theme.h"

#include <algorithm>
#include <cmath>

namespace texplorer::ui {

void drawSwatch(ImVec2 low, ImVec2 high, const BlockColor& color) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    if (color[3] < 255)
        drawBoard(draw, low, high, std::max(2.0F, std::floor((high.y - low.y) / 4)));
    draw.AddRectFilled(low, high, IM_COL32(color[0], color[1], color[2], color[3]));
}

float codeLetter() {
    ImGui::PushFont(codeFont());
    const float width = ImGui::CalcTextSize("0").x;
    ImGui::PopFont();
    return width;
}

void drawSwatchFrame(ImVec2 low, ImVec2 high, bool chosen, bool lit) {
    if (!chosen && !lit)
        return;
    const float em = ImGui::GetFontSize();
    const bool isSmall = high.y - low.y < em * 1.3F; // and the frame leaves the text readable
    const float thick = isSmall ? 1.0F : std::max(1.0F, std::round(em / 8));
    const auto ring = [&](float inset, float width, ImU32 tint) {
        ImGui::GetWindowDrawList()->AddRect(low + ImVec2(inset, inset), high - ImVec2(inset, inset), tint, 0,
                                            0, width);
    };
    ring(thick, 3 * thick, color::shade);
    ring(thick, thick, chosen ? color::chosen : color::text);
}

void drawOnSwatch(ImVec2 low, ImVec2 high, const char* words) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const float em = ImGui::GetFontSize();
    const float letters = std::min(em, high.y - low.y);
    const ImVec2 whole = ImGui::CalcTextSize(words);
    const ImVec2 size(whole.x * letters / em, letters);
    const float pad = std::floor(letters * 0.2F);
    const ImVec2 at(std::floor((low.x + high.x - size.x) / 2), std::floor((low.y + high.y - size.y) / 2));
    draw.AddRectFilled({at.x - pad, at.y}, {at.x + size.x + pad, at.y + size.y}, color::shade, pad);
    draw.AddText(ImGui::GetFont(), letters, at, color::text, words);
}

Spot spotHere(const char* id, ImVec2 size) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    Spot spot{low, low + size};
    spot.pressed = ImGui::InvisibleButton(id, size);
    const bool focused = ImGui::GetIO().NavVisible && ImGui::IsItemFocused();
    spot.hovered = ImGui::IsItemHovered() || focused;
    if (focused)
        ImGui::GetWindowDrawList()->AddRect(spot.low, spot.high, color::accent, 0, 0,
                                            std::max(2.0F, ImGui::GetFontSize() / 7));
    return spot;
}

} // namespace texplorer::ui

#include "app/ui/figures/plot.h"

#include "app/ui/widgets/theme.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cfloat>
#include <cmath>

namespace texplorer::ui {
namespace {

float plotTextHeight() {
    return std::round(ImGui::GetFontSize() * 0.85F);
}

} // namespace

ImU32 plotColor(glm::vec3 color) {
    const glm::vec3 c = glm::clamp(color, 0.0F, 1.0F);
    return ImGui::ColorConvertFloat4ToU32({c.r, c.g, c.b, 1});
}

ImU32 inkOn(glm::vec3 color) {
    const float light = glm::dot(glm::clamp(color, 0.0F, 1.0F), glm::vec3(0.3F, 0.59F, 0.11F));
    return light > 0.45F ? IM_COL32_BLACK : IM_COL32_WHITE;
}

void plotText(ImDrawList& draw, ImVec2 at, ImVec2 anchor, const std::string& text, ImU32 ink) {
    const ImVec2 size = plotTextSize(text);
    draw.AddText(ImGui::GetFont(), plotTextHeight(),
                 {std::round(at.x - size.x * anchor.x), std::round(at.y - size.y * anchor.y)}, ink,
                 text.c_str());
}

ImVec2 plotTextSize(const std::string& text) {
    return ImGui::GetFont()->CalcTextSizeA(plotTextHeight(), FLT_MAX, 0, text.c_str());
}

float plotLine() {
    return std::max(1.0F, ImGui::GetFontSize() / 12);
}

} // namespace texplorer::ui

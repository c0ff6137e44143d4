#include "app/ui/figures/plot.h"

#include "app/ui/language/translate.h"
#include "app/ui/widgets/fitted_text.h"
#include "app/ui/widgets/palette.h"
#include "app/ui/widgets/points.h"
#include "app/ui/widgets/wrapped_text.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
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

void plotText(ImVec2 at, ImVec2 anchor, const std::string& text, ImU32 ink) {
    const ImVec2 size = plotTextSize(text);
    ImGui::GetWindowDrawList()->AddText(
        ImGui::GetFont(), plotTextHeight(),
        {std::round(at.x - size.x * anchor.x), std::round(at.y - size.y * anchor.y)}, ink, text.c_str());
}

ImVec2 plotTextSize(const std::string& text) {
    return ImGui::GetFont()->CalcTextSizeA(plotTextHeight(), FLT_MAX, 0, text.c_str());
}

float plotNamesWidth(std::span<const char* const> names) {
    float width = 0;
    for (const char* name : names)
        width = std::max(width, plotTextSize(tr(name)).x);
    return std::ceil(width + ImGui::GetFontSize() * 0.5F);
}

void plotNames(float left, std::span<const char* const> names, std::span<const PlotBox> boxes) {
    for (std::size_t i = 0; i < names.size(); ++i)
        plotText({left, boxes[i].middle()}, {0, 0.5F}, tr(names[i]), color::dim);
}

void rowName(const char* words, float x, float gap) {
    ImGui::AlignTextToFramePadding();
    dimText(words);
    ImGui::SameLine(x, gap);
}

void shrunkText(ImVec2 at, const std::string& words, float size, float room, ImU32 ink) {
    constexpr float minScale = 0.75F;
    const float width = ImGui::GetFont()->CalcTextSizeA(size, FLT_MAX, 0, words.c_str()).x;
    const float fitting = width > room ? std::max(size * minScale, size * room / width) : size;
    // The cut is measured with the window's letters.
    const std::string shown = width * fitting / size > room + 0.5F
                                  ? fitted(ProperName{words}, room * ImGui::GetFontSize() / fitting)
                                  : words;
    ImGui::GetWindowDrawList()->AddText(ImGui::GetFont(), fitting,
                                        {std::round(at.x), std::round(at.y + (size - fitting) / 2)}, ink,
                                        shown.c_str());
}

void hatch(std::span<const ImVec2> polygon, float gap, ImU32 tint, float width) {
    if (polygon.size() < 3 || gap <= 0)
        return;
    // A line is where x + y = c; y points downwards.
    const auto sum = [](ImVec2 at) { return at.x + at.y; };
    const auto [least, most] = std::ranges::minmax(polygon, {}, sum);
    for (float c = std::ceil(sum(least) / gap) * gap; c < sum(most); c += gap) {
        std::array<ImVec2, 2> ends{};
        std::size_t found = 0;
        for (std::size_t i = 0; i < polygon.size() && found < ends.size(); ++i) {
            const ImVec2 a = polygon[i];
            const ImVec2 b = polygon[(i + 1) % polygon.size()];
            const float before = sum(a) - c;
            const float after = sum(b) - c;
            if ((before <= 0) == (after <= 0))
                continue;
            const float share = before / (before - after);
            ends.at(found++) = a + (b - a) * share;
        }
        if (found == ends.size())
            ImGui::GetWindowDrawList()->AddLine(ends[0], ends[1], tint, width);
    }
}

float plotLine() {
    return std::max(1.0F, ImGui::GetFontSize() / 12);
}

} // namespace texplorer::ui

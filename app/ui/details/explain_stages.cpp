#include "app/ui/details/explain_cards.h"
#include "app/ui/details/explain_pipeline.h"
#include "app/ui/language/translate.h"
#include "app/ui/widgets/fitted_text.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_places.h"
#include "app/ui/widgets/wrapped_text.h"

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace texplorer::ui {
namespace {

/// In one line, or in two if there is not enough width.
struct StagesPlan {
    float em = ImGui::GetFontSize();
    float pad = std::floor(em * 0.4F);
    float arrow = std::floor(em * 0.85F);
    float title = std::floor(em * 1.2F);
    float width = 0; ///< of a card
    float scale = 1; ///< of its text
    std::vector<std::vector<const StageRow*>> lines;

    [[nodiscard]] float textHeight(const StageRow& row) const {
        const float wrap = (width - 2 * pad) / scale;
        return wrappedSize(tr(row.help), wrap).y * scale;
    }
    [[nodiscard]] float height(const std::vector<const StageRow*>& line) const {
        float height = 0;
        for (const StageRow* row : line)
            height = std::max(height, textHeight(*row));
        return height + title + 3 * pad;
    }
    [[nodiscard]] float height() const {
        float sum = -ImGui::GetStyle().ItemSpacing.y;
        for (const auto& line : lines)
            sum += height(line) + ImGui::GetStyle().ItemSpacing.y;
        return sum;
    }
};

StagesPlan planStages(ImVec2 available) {
    constexpr float minStageWidth = 6.5F; // for its longest word, in heights of the text
    StagesPlan plan;
    std::vector<const StageRow*> all;
    for (const StageRow& row : stageRows) {
        if (row.always)
            all.push_back(&row);
    }
    const auto widthOf = [&](std::size_t count) {
        const auto n = static_cast<float>(count);
        return std::floor((available.x - (n - 1) * plan.arrow) / n);
    };
    std::size_t perLine = all.size();
    if (widthOf(perLine) < minStageWidth * plan.em)
        perLine = (all.size() + 1) / 2;
    plan.width = widthOf(perLine);
    for (std::size_t i = 0; i < all.size(); i += perLine)
        plan.lines.emplace_back(all.begin() + static_cast<std::ptrdiff_t>(i),
                                all.begin() + static_cast<std::ptrdiff_t>(std::min(i + perLine, all.size())));
    if (plan.height() > available.y) {
        plan.scale = 0.85F;
        plan.pad = std::floor(plan.em * 0.2F);
        plan.title = std::floor(plan.em * 1.05F);
    }
    return plan;
}

void drawStage(const StagesPlan& plan, const StageRow& row, ImVec2 low, ImVec2 high) {
    const float wrap = plan.width - 2 * plan.pad;
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled(low, high, ImGui::GetColorU32(ImGuiCol_FrameBg, 0.5F),
                       ImGui::GetStyle().FrameRounding);
    draw.AddText({low.x + plan.pad, low.y + plan.pad}, color::text, fitted(row.name, wrap).c_str());
    draw.AddText(ImGui::GetFont(), ImGui::GetFontSize() * plan.scale,
                 {low.x + plan.pad, low.y + plan.pad + plan.title}, color::dim,
                 wrappedLines(tr(row.help), wrap / plan.scale).c_str());
    noteDrawn(fmt::format("stage:{}", row.name), low, high);
    if (&row != &stageRows.back())
        drawStageArrow(high.x, (low.y + high.y) / 2, plan.arrow);
}

} // namespace

void drawStages() {
    const ImVec2 available = ImGui::GetContentRegionAvail();
    const StagesPlan plan = planStages(available);
    const ImVec2 begin = ImGui::GetCursorScreenPos();
    float y = begin.y;
    for (const auto& line : plan.lines) {
        const float height = plan.height(line);
        float x = begin.x;
        for (const StageRow* row : line) {
            drawStage(plan, *row, {x, y}, {x + plan.width, y + height});
            x += plan.width + plan.arrow;
        }
        y += height + ImGui::GetStyle().ItemSpacing.y;
    }
    ImGui::Dummy({available.x, plan.height()});
}

} // namespace texplorer::ui

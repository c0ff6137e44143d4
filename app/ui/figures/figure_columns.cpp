#include "app/ui/figures/figure_columns.h"

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace texplorer::ui {

float figureColumnGap() {
    return std::floor(ImGui::GetFontSize() * 0.9F);
}

void drawFigureColumns(std::span<const FigureColumn> columns) {
    const float room = ImGui::GetContentRegionAvail().x;
    const float gap = figureColumnGap();
    for (std::size_t first = 0; first < columns.size();) {
        float width = std::min(columns[first].width, room);
        std::size_t end = first + 1;
        while (end < columns.size() && width + gap + columns[end].width <= room)
            width += gap + columns[end++].width;
        ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, {gap / 2, 1});
        constexpr ImGuiTableFlags flags = ImGuiTableFlags_NoSavedSettings | ImGuiTableFlags_NoPadOuterX |
                                          ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_NoClip;
        if (ImGui::BeginTable(fmt::format("row {}", first).c_str(), static_cast<int>(end - first), flags)) {
            for (std::size_t i = first; i < end; ++i)
                ImGui::TableSetupColumn(fmt::format("{}", i).c_str(), ImGuiTableColumnFlags_WidthFixed,
                                        std::min(columns[i].width, room));
            ImGui::TableNextRow();
            for (std::size_t i = first; i < end; ++i) {
                ImGui::TableNextColumn();
                columns[i].draw();
            }
            ImGui::EndTable();
        }
        ImGui::PopStyleVar();
        first = end;
    }
}

} // namespace texplorer::ui

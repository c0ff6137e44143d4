#include "app/ui/details/details_panel.h"

#include "app/ui/details/explain_tab.h"
#include "app/ui/details/memory_tab.h"
#include "app/ui/widgets/panel.h"
#include "app/ui/widgets/param_widgets.h"

#include <fmt/core.h>

#include <string>
#include <utility>

namespace texplorer::ui {
namespace {

void drawTab(Session& session, DetailsState& state, const Pictures& pictures, Tab tab) {
    switch (tab) {
    case Tab::Vertices:
        return drawVerticesTab(session, state.vertices);
    case Tab::Commands:
        return drawCommandsTab(session, state.commands);
    case Tab::Glsl:
        return drawGlslTab(session, state.glsl, pictures);
    case Tab::Explain:
        return drawExplainTab(session, pictures);
    case Tab::File:
        return drawFileTab(session, state.file);
    case Tab::Memory:
        return drawMemoryTab(session, pictures);
    }
}

} // namespace

void drawDetailsPanel(Session& session, DetailsState& state, const Pictures& pictures, const Layout& layout) {
    beginPanel("Details", layout.details, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    session.window.explaining.isOpen = false;
    // Close together: all of their names fit into a narrow panel.
    const auto pushTabStyle = [] {
        ImGui::PushStyleVar(ImGuiStyleVar_FramePadding,
                            {ImGui::GetFontSize() * 0.2F, ImGui::GetStyle().FramePadding.y});
        ImGui::PushStyleVar(ImGuiStyleVar_ItemInnerSpacing, {1, ImGui::GetStyle().ItemInnerSpacing.y});
    };
    const float available = ImGui::GetContentRegionAvail().x;
    const auto haveRoom = [&] {
        float width = 0;
        for (const TabRow& row : tabRows)
            width += ImGui::CalcTextSize(row.label).x + ImGui::GetFontSize() * 0.4F + 2;
        return width <= available;
    };
    pushTabStyle();
    const bool hasTabs = ImGui::BeginTabBar("tabs");
    ImGui::PopStyleVar(2);
    if (hasTabs) {
        const std::optional<Tab> wanted = std::exchange(session.window.wantedTab, std::nullopt);
        const bool brief = !haveRoom();
        for (const TabRow& row : tabRows) {
            pushTabStyle();
            const std::string label = fmt::format("{}###{}", brief ? row.brief : row.label, row.label);
            const bool open = ImGui::BeginTabItem(label.c_str(), nullptr,
                                                  wanted == row.tab ? ImGuiTabItemFlags_SetSelected : 0);
            ImGui::PopStyleVar(2);
            noteItem(std::string("tab:") + row.label);
            if (open) {
                session.window.shownTab = row.tab;
                drawTab(session, state, pictures, row.tab);
                ImGui::EndTabItem();
            }
        }
        ImGui::EndTabBar();
    }
    ImGui::End();
}

} // namespace texplorer::ui

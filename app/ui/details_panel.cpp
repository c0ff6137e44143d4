#include "app/ui/panels.h"
#include "app/ui/param_widgets.h"

#include <utility>

namespace texplorer::ui {
namespace {

void drawTab(Session& session, const Pictures& pictures, Tab tab) {
    switch (tab) {
    case Tab::Vertices:
        return drawVerticesTab(session);
    case Tab::Commands:
        return drawCommandsTab(session);
    case Tab::Glsl:
        return drawGlslTab(session, pictures);
    case Tab::Explain:
        return drawExplainTab(session, pictures);
    case Tab::File:
        return drawFileTab(session);
    case Tab::Memory:
        return drawMemoryTab(session, pictures);
    }
}

} // namespace

void drawDetailsPanel(Session& session, const Pictures& pictures, const Layout& layout) {
    beginPanel("Details", layout.details, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    session.explaining.isOpen = false;
    if (ImGui::BeginTabBar("tabs")) {
        const std::optional<Tab> wanted = std::exchange(session.wantedTab, std::nullopt);
        for (const TabRow& row : tabRows) {
            const bool open = ImGui::BeginTabItem(row.label, nullptr,
                                                  wanted == row.tab ? ImGuiTabItemFlags_SetSelected : 0);
            noteItem(session, std::string("tab:") + row.label);
            if (open) {
                session.shownTab = row.tab;
                drawTab(session, pictures, row.tab);
                ImGui::EndTabItem();
            }
        }
        ImGui::EndTabBar();
    }
    ImGui::End();
}

} // namespace texplorer::ui

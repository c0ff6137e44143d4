#include "app/ui/language/translate.h"
#include "app/ui/widgets/panel.h"
#include "app/ui/widgets/param_widgets.h"
#include "app/ui/widgets/popups.h"
#include "app/ui/window/window_parts.h"

#include <fmt/core.h>

#include <optional>
#include <utility>

namespace texplorer::ui {
namespace {

Dock dockOf(Panel panel) {
    return panel == Panel::Right ? Dock::Right : Dock::Below;
}

const char* nameOf(const Workspace& workspace, Panel sheet) {
    if (sheet == Panel::Parameters)
        return N_("Parameters");
    if (sheet == Panel::TextureSpace)
        return N_("Texture space");
    return rowOf(*frontOf(workspace, dockOf(sheet))).label;
}

void offer(const Session& session, const char* name, bool isShown, const auto& choose) {
    if (ImGui::Selectable(label(name), isShown))
        rearrange(session, [choose](Workspace& workspace) {
            workspace.maximised = Maximised::None;
            choose(workspace);
        });
    noteItem(fmt::format("lower:{}", name));
}

void offerSheets(const Session& session, Panel sheet) {
    const Workspace& workspace = session.settings.workspace;
    for (const auto& [panel, isThere] : {std::pair(Panel::Parameters, workspace.parameters),
                                         std::pair(Panel::TextureSpace, workspace.textureSpace)}) {
        if (isThere)
            offer(session, nameOf(workspace, panel), sheet == panel,
                  [panel](Workspace& changed) { changed.sheet = panel; });
    }
    for (const TabRow& row : tabRows) {
        const Dock dock = ui::dockOf(workspace, row.tab);
        if (isOpen(workspace, row.tab))
            offer(session, row.label, sheet == panelOf(dock) && frontOf(workspace, dock) == row.tab,
                  [&row](Workspace& changed) { showTab(changed, row.tab); });
    }
}

} // namespace

void drawSheets(const Session& session, const Layout& layout) {
    const Workspace& workspace = session.settings.workspace;
    const std::optional<Panel> sheet = sheetOf(workspace);
    if (layout.sheets.isEmpty() || !sheet)
        return;
    beginPanel(N_("Panels"), layout.sheets,
               ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    ImGui::SetCursorPosY((static_cast<float>(layout.sheets.height) - ImGui::GetFrameHeight()) / 2);
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const bool canFill = *sheet != Panel::Parameters;
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - (canFill ? ImGui::GetFrameHeight() + gap : 0));
    const bool open = beginCombo("##sheets", tr(nameOf(workspace, *sheet)), ImGuiComboFlags_HeightLargest);
    noteItem("lower panel");
    if (open) {
        offerSheets(session, *sheet);
        endCombo();
    }
    if (canFill) {
        const Maximised whole =
            *sheet == Panel::TextureSpace ? Maximised::TextureSpace : maximised(dockOf(*sheet));
        const bool fills = maximisedOf(workspace) == whole;
        ImGui::SameLine(0, gap);
        if (squareButton(fills ? "❐" : "□", "maximise:lower",
                         fills ? N_("Restores the height") : N_("Covers the view"), true))
            rearrange(session, [whole](Workspace& changed) { toggleMaximised(changed, whole); });
    }
    ImGui::End();
}

} // namespace texplorer::ui

#include "app/ui/details/details_panel.h"

#include "app/ui/language/translate.h"
#include "app/ui/lesson/lesson_tab.h"
#include "app/ui/levels/memory_tab.h"
#include "app/ui/widgets/panel.h"
#include "app/ui/widgets/panel_menus.h"
#include "app/ui/widgets/param_widgets.h"
#include "app/ui/widgets/popups.h"
#include "app/ui/widgets/theme.h"

#include <fmt/core.h>

#include <algorithm>
#include <string>

namespace texplorer::ui {
namespace {

void drawTab(const Session& session, DetailsState& state, const Pictures& pictures, Tab tab) {
    switch (tab) {
    case Tab::Lesson:
        return drawLessonTab(session, pictures);
    case Tab::Vertices:
        return drawVerticesTab(session, state.vertices);
    case Tab::Levels:
        return drawLevelsTab(session, state.levels, pictures);
    case Tab::Commands:
        return drawCommandsTab(session, state.commands);
    case Tab::Glsl:
        return drawGlslTab(session, state.glsl, pictures);
    case Tab::Explain:
        return drawExplainTab(session, state.explain, pictures);
    case Tab::File:
        return drawFileTab(session, state.file, pictures);
    case Tab::Memory:
        return drawMemoryTab(session, pictures);
    case Tab::Kept:
        return drawKeptTab(session, state.kept);
    case Tab::History:
        return drawHistoryTab(session, state.history, pictures);
    case Tab::Figures:
        return drawFiguresTab(session, state.figures, pictures);
    case Tab::Timeline:
        return drawTimelineTab(session, state.timeline);
    }
}

/// With little space: all their names fit into a narrow panel.
void pushTabStyle() {
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding,
                        {ImGui::GetFontSize() * 0.2F, ImGui::GetStyle().FramePadding.y});
    ImGui::PushStyleVar(ImGuiStyleVar_ItemInnerSpacing, {1, ImGui::GetStyle().ItemInnerSpacing.y});
}

bool liesIn(const Workspace& workspace, Tab tab, Dock dock) {
    return isOpen(workspace, tab) && dockOf(workspace, tab) == dock;
}

/// Handles the mouse on a tab, which is the last widget.
void handleTab(const Session& session, DetailsState& state, const TabRow& row, Dock dock) {
    if (ImGui::IsItemActivated())
        rearrange(session, [&row](Workspace& workspace) { showTab(workspace, row.tab); });
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left))
        rearrange(session, [dock](Workspace& workspace) { toggleMaximised(workspace, maximised(dock)); });
    if (ImGui::IsItemActive() && ImGui::IsMouseDragging(ImGuiMouseButton_Left, ImGui::GetFontSize()))
        state.dragged = row.tab;
    if (ImGui::IsItemClicked(ImGuiMouseButton_Middle))
        rearrange(session, [&row](Workspace& workspace) { closeTab(workspace, row.tab); });
    if (beginPopupContextItem()) {
        tabMenuItems(session, row.tab);
        endPopup();
    }
}

/// The tabs, with short labels if the long ones do not fit.
void drawTabBar(const Session& session, DetailsState& state, Dock dock) {
    const Workspace& workspace = session.settings.workspace;
    const float em = ImGui::GetFontSize();
    float width = 0;
    for (const TabRow& row : tabRows)
        width += liesIn(workspace, row.tab, dock) ? ImGui::CalcTextSize(tr(row.label)).x + em * 0.4F + 2 : 0;
    const bool brief = width > ImGui::GetContentRegionAvail().x;
    pushTabStyle();
    const bool hasTabs = ImGui::BeginTabBar("tabs");
    ImGui::PopStyleVar(2);
    if (!hasTabs)
        return;
    for (const TabRow& row : tabRows) {
        if (!liesIn(workspace, row.tab, dock))
            continue;
        pushTabStyle();
        const std::string shown = fmt::format("{}###{}", tr(brief ? row.brief : row.label), row.label);
        const bool isFront = frontOf(workspace, dock) == row.tab;
        const bool open =
            ImGui::BeginTabItem(shown.c_str(), nullptr, isFront ? ImGuiTabItemFlags_SetSelected : 0);
        ImGui::PopStyleVar(2);
        noteItem(std::string("tab:") + row.label);
        handleTab(session, state, row, dock);
        if (open)
            ImGui::EndTabItem();
    }
    ImGui::EndTabBar();
}

/// The menu of the whole dock, at the right end of its tabs.
void dockButtons(const Session& session, Dock dock) {
    const Workspace& shown = session.settings.workspace;
    ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetColorU32(ImGuiCol_Button, 0));
    if (squareButton("+", fmt::format("panels:{}", rowOf(dock).name), "The tabs of this panel", true))
        ImGui::OpenPopup("panels");
    const bool fills = maximisedOf(shown) == maximised(dock);
    ImGui::SameLine(0, 0);
    if (squareButton(fills ? "❐" : "□", fmt::format("maximise:{}", rowOf(dock).name),
                     fills ? N_("Restores the size (double click on a tab, Escape)")
                           : N_("Maximises the panel (double click on a tab)"),
                     true))
        rearrange(session, [dock](Workspace& workspace) { toggleMaximised(workspace, maximised(dock)); });
    const std::optional<Tab> front = frontOf(shown, dock);
    ImGui::SameLine(0, 0);
    if (squareButton("✕", fmt::format("close:{}", rowOf(dock).name),
                     "Closes this tab (middle click). View › Panels opens it again.", front.has_value()))
        rearrange(session, [tab = *front](Workspace& workspace) { closeTab(workspace, tab); });
    ImGui::PopStyleColor();
    if (beginPopup("panels")) {
        dockMenuItems(session, dock);
        endPopup();
    }
}

void tabRow(const Session& session, DetailsState& state, Dock dock) {
    const float line = ImGui::GetFrameHeight();
    const float top = ImGui::GetCursorPosY() + line + ImGui::GetStyle().ItemSpacing.y;
    ImGui::BeginChild("tab row", {std::max(1.0F, ImGui::GetContentRegionAvail().x - 3 * line), line}, false,
                      ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    drawTabBar(session, state, dock);
    ImGui::EndChild();
    ImGui::SameLine(0, 0);
    dockButtons(session, dock);
    ImGui::SetCursorPos({ImGui::GetStyle().WindowPadding.x, top});
}

/// Where a tab is dropped into a dock, even into an empty one.
Rect dropZone(const Layout& layout, Dock dock) {
    if (!layout.of(dock).isEmpty())
        return layout.of(dock);
    const int left = layout.leftSeam.right();
    const int width = layout.window.right() - left;
    const int height = layout.status.y - layout.menu.bottom();
    if (dock == Dock::Below)
        return {left, layout.status.y - height / 4, width, height / 4};
    return {layout.window.right() - width / 4, layout.menu.bottom(), width / 4, height * 3 / 4};
}

} // namespace

void drawDock(const Session& session, DetailsState& state, const Pictures& pictures, const Layout& layout,
              Dock dock) {
    if (layout.of(dock).isEmpty())
        return;
    beginPanel(rowOf(dock).window, layout.of(dock),
               ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    if (!layout.isStacked) // there, the list of sheets has its tabs
        tabRow(session, state, dock);
    if (const std::optional<Tab> front = frontOf(session.settings.workspace, dock)) {
        ImGui::PushID(rowOf(*front).label);
        drawTab(session, state, pictures, *front);
        ImGui::PopID();
    }
    ImGui::End();
}

void drawDraggedTab(const Session& session, DetailsState& state, const Layout& layout) {
    if (!state.dragged)
        return;
    const Dock target =
        dockOf(session.settings.workspace, *state.dragged) == Dock::Right ? Dock::Below : Dock::Right;
    const Rect zone = dropZone(layout, target);
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const bool falls = zone.contains(mouse.x, mouse.y);
    if (!ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
        if (falls)
            rearrange(session, [tab = *state.dragged, target](Workspace& workspace) {
                moveTab(workspace, tab, target);
            });
        state.dragged.reset();
        return;
    }
    ImDrawList& draw = *ImGui::GetForegroundDrawList();
    const ImVec2 low = lowOf(zone);
    const ImVec2 high = highOf(zone);
    if (falls)
        draw.AddRectFilled(low, high, ImGui::GetColorU32(ImGuiCol_SeparatorHovered, 0.25F));
    draw.AddRect(low, high, ImGui::GetColorU32(ImGuiCol_SeparatorHovered), 0, 0, 2);
    const float em = ImGui::GetFontSize();
    const ImVec2 at(mouse.x + em * 0.8F, mouse.y + em * 0.8F);
    const char* name = tr(rowOf(*state.dragged).label);
    const ImVec2 size = ImGui::CalcTextSize(name);
    draw.AddRectFilled({at.x - em * 0.3F, at.y - em * 0.2F},
                       {at.x + size.x + em * 0.3F, at.y + size.y + em * 0.2F},
                       ImGui::GetColorU32(ImGuiCol_PopupBg), em * 0.2F);
    draw.AddText(at, color::text, name);
    noteDrawn(N_("tab falls"), low, high);
}

} // namespace texplorer::ui

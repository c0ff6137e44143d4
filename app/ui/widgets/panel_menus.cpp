#include "app/ui/widgets/panel_menus.h"

#include "app/ui/language/translate.h"
#include "app/ui/widgets/fitted_text.h"
#include "app/ui/widgets/param_tips.h"
#include "app/ui/widgets/param_widgets.h"

namespace texplorer::ui {
namespace {

bool panelItem(const char* words, const char* keys, bool marked, bool enabled = true) {
    const bool pressed = ImGui::MenuItem(label(words), keys ? tr(keys) : nullptr, marked, enabled);
    noteItem(fmt::format("menu:{}", words));
    return pressed;
}

bool panelSubmenu(const char* words) {
    const bool open = ImGui::BeginMenu(label(words));
    noteItem(fmt::format("menu:{}", words));
    return open;
}

void textureSpaceItems(Workspace& workspace) {
    if (panelItem("Shown", nullptr, workspace.textureSpace))
        workspace.textureSpace = !workspace.textureSpace;
    const bool fills = maximisedOf(workspace) == Maximised::TextureSpace;
    if (panelItem("Maximised", "Double click", fills)) {
        workspace.textureSpace = true;
        toggleMaximised(workspace, Maximised::TextureSpace);
    }
}

} // namespace

void textureSpaceTitle(Session& session, float room) {
    Workspace& workspace = session.window.settings.workspace;
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(fitted("Texture space", room).c_str());
    noteItem("title:Texture space");
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left))
        toggleMaximised(workspace, Maximised::TextureSpace);
    helpTip("Double click: maximises the panel, or restores it. Right click: more.");
    if (ImGui::BeginPopupContextItem("texture space menu")) {
        textureSpaceItems(workspace);
        ImGui::EndPopup();
    }
}

void tabMenuItems(Workspace& workspace, Tab tab) {
    const bool open = isOpen(workspace, tab);
    for (const DockRow& row : dockRows) {
        if (panelItem(row.label, nullptr, open && dockOf(workspace, tab) == row.dock))
            moveTab(workspace, tab, row.dock);
    }
    if (panelItem("Closed", nullptr, !open))
        closeTab(workspace, tab);
    ImGui::Separator();
    const Maximised what = maximised(dockOf(workspace, tab));
    const bool fills = isShown(workspace, tab) && maximisedOf(workspace) == what;
    if (panelItem("Maximised", "Double click", fills)) {
        if (!fills)
            showTab(workspace, tab);
        toggleMaximised(workspace, what);
    }
}

void dockMenuItems(Workspace& workspace, Dock dock) {
    for (const TabRow& row : tabRows) {
        const bool here = isOpen(workspace, row.tab) && dockOf(workspace, row.tab) == dock;
        if (!panelItem(row.label, nullptr, here))
            continue;
        if (here)
            closeTab(workspace, row.tab);
        else
            moveTab(workspace, row.tab, dock);
    }
}

void panelsMenu(Session& session) {
    if (!panelSubmenu("Panels"))
        return;
    Workspace& workspace = session.window.settings.workspace;
    if (panelItem("Parameters", nullptr, workspace.parameters))
        workspace.parameters = !workspace.parameters;
    if (panelSubmenu("Texture space")) {
        textureSpaceItems(workspace);
        ImGui::EndMenu();
    }
    ImGui::Separator();
    for (const TabRow& row : tabRows) {
        if (!panelSubmenu(row.label))
            continue;
        tabMenuItems(workspace, row.tab);
        ImGui::EndMenu();
    }
    ImGui::EndMenu();
}

void layoutsMenu(Session& session) {
    if (!panelSubmenu("Layout"))
        return;
    Workspace& workspace = session.window.settings.workspace;
    for (const LayoutRow& row : layoutRows) {
        const LayoutRow* now = layoutOf(workspace);
        if (panelItem(row.label, nullptr, now && now->name == row.name))
            chooseLayout(workspace, row);
        helpTip(row.help);
    }
    ImGui::EndMenu();
}

} // namespace texplorer::ui

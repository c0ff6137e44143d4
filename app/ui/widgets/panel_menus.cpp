#include "app/ui/widgets/panel_menus.h"

#include "app/ui/language/translate.h"
#include "app/ui/state/layout.h"
#include "app/ui/widgets/fitted_text.h"
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

void textureSpaceItems(const Session& session) {
    const Workspace& shown = session.settings.workspace;
    if (panelItem("Shown", nullptr, shown.textureSpace))
        rearrange(session, [](Workspace& workspace) { workspace.textureSpace = !workspace.textureSpace; });
    const bool fills = maximisedOf(shown) == Maximised::TextureSpace;
    if (panelItem("Maximised", "Double click", fills))
        rearrange(session, [](Workspace& workspace) {
            workspace.textureSpace = true;
            toggleMaximised(workspace, Maximised::TextureSpace);
        });
}

} // namespace

void textureSpaceTitle(const Session& session, float room) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(fitted("Texture space", room).c_str());
    noteItem("title:Texture space");
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left))
        rearrange(session, [](Workspace& workspace) { toggleMaximised(workspace, Maximised::TextureSpace); });
    helpTip("Double click: maximises the panel, or restores it. Right click: more.");
    if (ImGui::BeginPopupContextItem("texture space menu")) {
        textureSpaceItems(session);
        ImGui::EndPopup();
    }
}

void tabMenuItems(const Session& session, Tab tab) {
    const Workspace& shown = session.settings.workspace;
    const bool open = isOpen(shown, tab);
    for (const DockRow& row : dockRows) {
        if (panelItem(row.label, nullptr, open && dockOf(shown, tab) == row.dock))
            rearrange(session, [tab, &row](Workspace& workspace) { moveTab(workspace, tab, row.dock); });
    }
    if (panelItem("Closed", nullptr, !open))
        rearrange(session, [tab](Workspace& workspace) { closeTab(workspace, tab); });
    ImGui::Separator();
    const Maximised what = maximised(dockOf(shown, tab));
    const bool fills = isShown(shown, tab) && maximisedOf(shown) == what;
    if (panelItem("Maximised", "Double click", fills))
        rearrange(session, [=](Workspace& workspace) {
            if (!fills)
                showTab(workspace, tab);
            toggleMaximised(workspace, what);
        });
}

void dockMenuItems(const Session& session, Dock dock) {
    const Workspace& shown = session.settings.workspace;
    for (const TabRow& row : tabRows) {
        const bool here = isOpen(shown, row.tab) && dockOf(shown, row.tab) == dock;
        if (panelItem(row.label, nullptr, here))
            rearrange(session, [=, &row](Workspace& workspace) {
                if (here)
                    closeTab(workspace, row.tab);
                else
                    moveTab(workspace, row.tab, dock);
            });
    }
}

void panelsMenu(const Session& session) {
    if (!panelSubmenu("Panels"))
        return;
    if (panelItem("Parameters", nullptr, session.settings.workspace.parameters))
        rearrange(session, [](Workspace& workspace) { workspace.parameters = !workspace.parameters; });
    if (panelSubmenu("Texture space")) {
        textureSpaceItems(session);
        ImGui::EndMenu();
    }
    ImGui::Separator();
    for (const TabRow& row : tabRows) {
        if (!panelSubmenu(row.label))
            continue;
        tabMenuItems(session, row.tab);
        ImGui::EndMenu();
    }
    ImGui::EndMenu();
}

void layoutsMenu(const Session& session) {
    if (!panelSubmenu("Layout"))
        return;
    const LayoutRow* now = layoutOf(session.settings.workspace);
    for (const LayoutRow& row : layoutRows) {
        if (panelItem(row.label, nullptr, now && now->name == row.name))
            rearrange(session, [&row](Workspace& workspace) { chooseLayout(workspace, row); });
        helpTip(row.help);
    }
    ImGui::EndMenu();
}

} // namespace texplorer::ui

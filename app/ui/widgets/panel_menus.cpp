#include "app/ui/widgets/panel_menus.h"

#include "app/ui/language/translate.h"
#include "app/ui/state/layout.h"
#include "app/ui/widgets/buttons.h"
#include "app/ui/widgets/fitted_text.h"
#include "app/ui/widgets/param_widgets.h"
#include "app/ui/widgets/popups.h"

namespace texplorer::ui {
namespace {

void textureSpaceItems(const Session& session) {
    const Workspace& shown = session.settings.workspace;
    if (menuChoice(N_("Shown"), shown.textureSpace))
        rearrange(session, [](Workspace& workspace) {
            workspace.textureSpace = !workspace.textureSpace;
            workspace.sheet = Panel::TextureSpace;
        });
    if (menuItem("Maximised", tr("Double click"), true, maximisedOf(shown) == Maximised::TextureSpace))
        rearrange(session, [](Workspace& workspace) {
            workspace.textureSpace = true;
            toggleMaximised(workspace, Maximised::TextureSpace);
        });
}

} // namespace

bool menuItem(const Sentence& name, const std::string& keys, bool enabled, bool marked) {
    const bool pressed = ImGui::MenuItem(label(name).c_str(), keys.c_str(), marked, enabled);
    noteItem("menu:" + name.english());
    return pressed;
}

bool menuChoice(const Sentence& name, bool marked) {
    return menuItem(name, {}, true, marked);
}

void menuOf(const char* name, const std::function<void()>& items) {
    const bool open = beginMenu(label(name));
    noteItem(std::string("menu:") + name);
    if (!open)
        return;
    items();
    endMenu();
}

void textureSpaceTitle(const Session& session, float room) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(fitted("Texture space", room).c_str());
    noteItem("title:Texture space");
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left))
        rearrange(session, [](Workspace& workspace) { toggleMaximised(workspace, Maximised::TextureSpace); });
    helpTip("Double click: maximises the panel, or restores it. Right click: more.");
    if (beginPopupContextItem(N_("texture space menu"))) {
        textureSpaceItems(session);
        endPopup();
    }
}

void tabMenuItems(const Session& session, Tab tab) {
    const Workspace& shown = session.settings.workspace;
    const bool open = isOpen(shown, tab);
    for (const DockRow& row : dockRows) {
        if (menuChoice(row.label, open && dockOf(shown, tab) == row.dock))
            rearrange(session, [tab, &row](Workspace& workspace) { moveTab(workspace, tab, row.dock); });
    }
    if (menuChoice(N_("Closed"), !open))
        rearrange(session, [tab](Workspace& workspace) { closeTab(workspace, tab); });
    ImGui::Separator();
    const Maximised what = maximised(dockOf(shown, tab));
    const bool fills = isShown(shown, tab) && maximisedOf(shown) == what;
    if (menuItem("Maximised", tr("Double click"), true, fills))
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
        if (menuChoice(row.label, here))
            rearrange(session, [=, &row](Workspace& workspace) {
                if (here)
                    closeTab(workspace, row.tab);
                else
                    moveTab(workspace, row.tab, dock);
            });
    }
}

void panelItems(const Session& session) {
    if (menuChoice(N_("Parameters"), session.settings.workspace.parameters))
        rearrange(session, [](Workspace& workspace) {
            workspace.parameters = !workspace.parameters;
            workspace.sheet = Panel::Parameters;
        });
    menuOf("Texture space", [&] { textureSpaceItems(session); });
    ImGui::Separator();
    for (const TabRow& row : tabRows)
        menuOf(row.label, [&] { tabMenuItems(session, row.tab); });
}

void layoutItems(const Session& session) {
    const LayoutRow* now = layoutOf(session.settings.workspace);
    for (const LayoutRow& row : layoutRows) {
        if (menuChoice(row.label, now && now->name == row.name))
            rearrange(session, [&row](Workspace& workspace) { chooseLayout(workspace, row); });
        helpTip(row.help);
    }
}

} // namespace texplorer::ui

#include "app/ui/state/workspace.h"

#include <algorithm>

namespace texplorer::ui {
namespace {

auto& placeOf(auto& workspace, Tab tab) {
    return workspace.tabs[static_cast<std::size_t>(tab)];
}

bool liesIn(const Workspace& workspace, Tab tab, Dock dock) {
    return placeOf(workspace, tab) == TabPlace{dock, true};
}

} // namespace

bool isOpen(const Workspace& workspace, Tab tab) {
    return placeOf(workspace, tab).open;
}

Dock dockOf(const Workspace& workspace, Tab tab) {
    return placeOf(workspace, tab).dock;
}

std::optional<Tab> frontOf(const Workspace& workspace, Dock dock) {
    const Tab front = workspace.front[static_cast<std::size_t>(dock)];
    if (liesIn(workspace, front, dock))
        return front;
    const auto first =
        std::ranges::find_if(tabRows, [&](const TabRow& row) { return liesIn(workspace, row.tab, dock); });
    return first == tabRows.end() ? std::nullopt : std::optional(first->tab);
}

std::optional<Panel> sheetOf(const Workspace& workspace) {
    const auto isThere = [&](Panel panel) {
        return panel == Panel::Parameters ? workspace.parameters
               : panel == Panel::TextureSpace
                   ? workspace.textureSpace
                   : frontOf(workspace, panel == Panel::Right ? Dock::Right : Dock::Below).has_value();
    };
    const Maximised whole = maximisedOf(workspace);
    if (whole == Maximised::TextureSpace)
        return Panel::TextureSpace;
    if (whole == Maximised::Right || whole == Maximised::Below)
        return whole == Maximised::Right ? Panel::Right : Panel::Below;
    if (isThere(workspace.sheet))
        return workspace.sheet;
    const auto first = std::ranges::find_if(panelRows, isThere, &PanelRow::panel);
    return first == panelRows.end() ? std::nullopt : std::optional(first->panel);
}

bool isShown(const Workspace& workspace, Tab tab) {
    const Dock dock = dockOf(workspace, tab);
    const Maximised filling = maximisedOf(workspace);
    return frontOf(workspace, dock) == tab && (filling == Maximised::None || filling == maximised(dock));
}

Maximised maximisedOf(const Workspace& workspace) {
    const auto dockIsThere = [&](Dock dock) {
        return workspace.maximised == maximised(dock) && frontOf(workspace, dock);
    };
    const bool isThere = workspace.maximised == Maximised::View ||
                         (workspace.maximised == Maximised::TextureSpace && workspace.textureSpace) ||
                         dockIsThere(Dock::Right) || dockIsThere(Dock::Below);
    return isThere ? workspace.maximised : Maximised::None;
}

void showTab(Workspace& workspace, Tab tab) {
    moveTab(workspace, tab, dockOf(workspace, tab));
}

void closeTab(Workspace& workspace, Tab tab) {
    placeOf(workspace, tab).open = false;
}

void moveTab(Workspace& workspace, Tab tab, Dock dock) {
    placeOf(workspace, tab) = {dock, true};
    workspace.front[static_cast<std::size_t>(dock)] = tab;
    workspace.sheet = panelOf(dock);
    if (workspace.maximised != maximised(dock))
        workspace.maximised = Maximised::None;
}

void toggleMaximised(Workspace& workspace, Maximised what) {
    workspace.maximised = workspace.maximised == what ? Maximised::None : what;
}

Workspace workspaceOf(const LayoutRow& row) {
    Workspace workspace;
    workspace.parameters = row.parameters;
    workspace.textureSpace = row.textureSpace;
    for (TabPlace& place : workspace.tabs)
        place.open = place.open && row.docks; // initially no lesson is open
    return workspace;
}

void chooseLayout(Workspace& workspace, const LayoutRow& row) {
    const TabPlace lesson = placeOf(workspace, Tab::Lesson);
    workspace = workspaceOf(row);
    if (lesson.open)
        moveTab(workspace, Tab::Lesson, lesson.dock);
}

const LayoutRow* layoutOf(const Workspace& workspace) {
    const auto found = std::ranges::find_if(layoutRows, [&](const LayoutRow& row) {
        Workspace named = workspaceOf(row);
        named.front = workspace.front;
        named.sheet = workspace.sheet;
        named.seams = workspace.seams;
        named.maximised = workspace.maximised;
        placeOf(named, Tab::Lesson) = placeOf(workspace, Tab::Lesson);
        return named == workspace;
    });
    return found == layoutRows.end() ? nullptr : &*found;
}

} // namespace texplorer::ui

#pragma once

#include "app/ui/model/session.h"

namespace texplorer::ui {

// Menus that say which panels are open, and where: of View, and of the tabs themselves.

/// The items for one tab: the docks, maximise, close. To be called in an open menu.
void tabMenuItems(Workspace& workspace, Tab tab);

/// The name of the texture space at the head of its panel, with its menu: a right click opens it, a double
/// click maximises. `room`: in pixels; it is cut short where it takes more.
void textureSpaceTitle(Session& session, float room);

/// View › Panels: each panel, and a menu for each tab.
void panelsMenu(Session& session);

/// View › Layout.
void layoutsMenu(Session& session);

/// Which tabs lie in a dock: for the button at the end of its tabs.
void dockMenuItems(Workspace& workspace, Dock dock);

} // namespace texplorer::ui

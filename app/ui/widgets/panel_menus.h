#pragma once

#include "app/ui/model/session.h"

#include <functional>
#include <string>

namespace texplorer::ui {

/// An item with its keys, "Ctrl+S". Its name in tests is "menu:Save".
bool menuItem(const Sentence& name, const std::string& keys = {}, bool enabled = true, bool marked = false);

/// The same for a choice of several.
bool menuChoice(const Sentence& name, bool marked);

/// A menu, and its items while it is open.
void menuOf(const char* name, const std::function<void()>& items);

// Menus for opening and moving panels: of View, and of the tabs themselves.

/// The menu items for one tab: the docks, maximise, close. Call it in an open menu.
void tabMenuItems(const Session& session, Tab tab);

/// The title of the texture space at the top of its panel, with its menu: a right click opens it, a double
/// click maximises the panel. `room`: in pixels; a longer title is cut.
void textureSpaceTitle(const Session& session, float room);

/// View › Panels: each panel, and a menu for each tab.
void panelItems(const Session& session);

/// View › Layout.
void layoutItems(const Session& session);

/// The choice of the tabs in a dock, for the button at the end of its tabs.
void dockMenuItems(const Session& session, Dock dock);

} // namespace texplorer::ui

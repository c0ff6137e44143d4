#pragma once

#include "app/ui/model/session.h"
#include "app/ui/state/layout.h"

#include <functional>
#include <string>
#include <string_view>

namespace texplorer::ui {

/// An item with its keys, "Ctrl+S". Its name in tests is "menu:Save".
bool menuItem(const std::string& name, const std::string& keys = {}, bool enabled = true,
              bool marked = false);

/// The same for a choice of several.
bool menuChoice(const std::string& name, bool marked);

/// An item that does the same as the shortcut with this name.
void shortcutItem(const Session& session, const Layout& layout, const std::string& name,
                  std::string_view shortcut, bool enabled = true, bool marked = false);

/// A menu, and its items while it is open.
void menuOf(const char* name, const std::function<void()>& items);

} // namespace texplorer::ui

#include "app/ui/window/menu_items.h"

#include "app/ui/language/translate.h"
#include "app/ui/state/layout.h"
#include "app/ui/widgets/widget_places.h"
#include "app/ui/window/shortcuts.h"

#include <imgui.h>

namespace texplorer::ui {

bool menuItem(const std::string& name, const std::string& keys, bool enabled, bool marked) {
    const bool pressed = ImGui::MenuItem(label(name).c_str(), keys.c_str(), marked, enabled);
    noteItem("menu:" + name);
    return pressed;
}

bool menuChoice(const std::string& name, bool marked) {
    return menuItem(name, {}, true, marked);
}

void shortcutItem(const Session& session, const Layout& layout, const std::string& name,
                  std::string_view shortcut, bool enabled, bool marked) {
    const Shortcut& row = shortcutOf(shortcut);
    if (menuItem(name, keysOf(session, shortcut), enabled, marked))
        act(session, [&row, layout](Session& s) { row.act(s, layout); });
}

void menuOf(const char* name, const std::function<void()>& items) {
    const bool open = ImGui::BeginMenu(label(name));
    noteItem(std::string("menu:") + name);
    if (!open)
        return;
    items();
    ImGui::EndMenu();
}

} // namespace texplorer::ui

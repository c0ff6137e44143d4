#pragma once

#include <imgui.h>

namespace texplorer::ui {

// Lists and menus: Dear ImGui's functions of these names. With large controls, a finger finds each entry.

[[nodiscard]] bool beginMenu(const char* label);
[[nodiscard]] bool beginCombo(const char* name, const char* shown, ImGuiComboFlags flags = 0);
[[nodiscard]] bool beginPopup(const char* name);
[[nodiscard]] bool beginPopupContextItem(const char* name = nullptr);

void endMenu();
void endCombo();
void endPopup();

// The same for a list in a panel.
void beginEntries();
void endEntries();

} // namespace texplorer::ui

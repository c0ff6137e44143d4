#pragma once

#include <imgui.h>

#include <string>

namespace texplorer::ui {

/// ImGui::InputText for a text of any length; `hint` is shown while it is empty. (Dear ImGui's own
/// imgui_stdlib.h is in a library that supports only one standard library's strings.)
bool textField(const char* label, std::string& text, ImGuiInputTextFlags flags, const char* hint = "");

} // namespace texplorer::ui

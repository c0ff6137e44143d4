#include "app/ui/widgets/keys.h"

#include <imgui.h>

namespace texplorer::ui {

bool isMenuAsked() {
    return ImGui::IsItemFocused() && (ImGui::IsKeyPressed(key::menu, false) ||
                                      (ImGui::GetIO().KeyShift && ImGui::IsKeyPressed(key::f10, false)));
}

void mapKeys() {
    int* map = ImGui::GetIO().KeyMap;
    map[ImGuiKey_Tab] = key::tab;
    map[ImGuiKey_LeftArrow] = key::left;
    map[ImGuiKey_RightArrow] = key::right;
    map[ImGuiKey_UpArrow] = key::up;
    map[ImGuiKey_DownArrow] = key::down;
    map[ImGuiKey_PageUp] = key::pageUp;
    map[ImGuiKey_PageDown] = key::pageDown;
    map[ImGuiKey_Home] = key::home;
    map[ImGuiKey_End] = key::end;
    map[ImGuiKey_Insert] = key::insert;
    map[ImGuiKey_Delete] = key::del;
    map[ImGuiKey_Backspace] = key::backspace;
    map[ImGuiKey_Space] = key::space;
    map[ImGuiKey_Enter] = key::enter;
    map[ImGuiKey_Escape] = key::escape;
    map[ImGuiKey_KeyPadEnter] = key::keypadEnter;
    map[ImGuiKey_A] = 'A';
    map[ImGuiKey_C] = 'C';
    map[ImGuiKey_V] = 'V';
    map[ImGuiKey_X] = 'X';
    map[ImGuiKey_Y] = 'Y';
    map[ImGuiKey_Z] = 'Z';
}

} // namespace texplorer::ui

#include "app/ui/widgets/keys.h"

#include <imgui.h>
#include <imgui_internal.h> // the owner of Tab, and whether a number is typed

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>

namespace texplorer::ui {

namespace {

struct KeyRow {
    int code;
    ImGuiKey name;
};

constexpr std::array keyRows {
    // Keys that Dear ImGui has always had names for.
    KeyRow{key::tab, ImGuiKey_Tab}, KeyRow{key::left, ImGuiKey_LeftArrow},
        KeyRow{key::right, ImGuiKey_RightArrow}, KeyRow{key::up, ImGuiKey_UpArrow},
        KeyRow{key::down, ImGuiKey_DownArrow}, KeyRow{key::pageUp, ImGuiKey_PageUp},
        KeyRow{key::pageDown, ImGuiKey_PageDown}, KeyRow{key::home, ImGuiKey_Home},
        KeyRow{key::end, ImGuiKey_End}, KeyRow{key::insert, ImGuiKey_Insert},
        KeyRow{key::del, ImGuiKey_Delete}, KeyRow{key::backspace, ImGuiKey_Backspace},
        KeyRow{key::space, ImGuiKey_Space}, KeyRow{key::enter, ImGuiKey_Enter},
        KeyRow{key::escape, ImGuiKey_Escape},
#if IMGUI_VERSION_NUM >= 18700
        KeyRow{key::keypadEnter, ImGuiKey_KeypadEnter}, KeyRow{'\'', ImGuiKey_Apostrophe},
        KeyRow{',', ImGuiKey_Comma}, KeyRow{'-', ImGuiKey_Minus}, KeyRow{'.', ImGuiKey_Period},
        KeyRow{'/', ImGuiKey_Slash}, KeyRow{';', ImGuiKey_Semicolon}, KeyRow{'=', ImGuiKey_Equal},
        KeyRow{'[', ImGuiKey_LeftBracket}, KeyRow{'\\', ImGuiKey_Backslash},
        KeyRow{']', ImGuiKey_RightBracket}, KeyRow{'`', ImGuiKey_GraveAccent},
        KeyRow{key::keypadMinus, ImGuiKey_KeypadSubtract}, KeyRow{key::keypadPlus, ImGuiKey_KeypadAdd},
        KeyRow{340, ImGuiKey_LeftShift}, KeyRow{341, ImGuiKey_LeftCtrl}, KeyRow{342, ImGuiKey_LeftAlt},
        KeyRow{343, ImGuiKey_LeftSuper}, KeyRow{344, ImGuiKey_RightShift}, KeyRow{345, ImGuiKey_RightCtrl},
        KeyRow{346, ImGuiKey_RightAlt}, KeyRow{347, ImGuiKey_RightSuper}, KeyRow{key::menu, ImGuiKey_Menu},
#else
        KeyRow{key::keypadEnter, ImGuiKey_KeyPadEnter}, KeyRow{'A', ImGuiKey_A}, KeyRow{'C', ImGuiKey_C},
        KeyRow{'V', ImGuiKey_V}, KeyRow{'X', ImGuiKey_X}, KeyRow{'Y', ImGuiKey_Y}, KeyRow{'Z', ImGuiKey_Z},
#endif
};

#if IMGUI_VERSION_NUM >= 18700

ImGuiKey nameOf(int code) {
    const auto after = [code](ImGuiKey first, int from) {
        return static_cast<ImGuiKey>(static_cast<int>(first) + code - from);
    };
    if (code >= 'A' && code <= 'Z')
        return after(ImGuiKey_A, 'A');
    if (code >= '0' && code <= '9')
        return after(ImGuiKey_0, '0');
    if (code >= key::f1 && code <= key::f12)
        return after(ImGuiKey_F1, key::f1);
    const auto* row = std::ranges::find(keyRows, code, &KeyRow::code);
    return row != keyRows.end() ? row->name : ImGuiKey_None;
}

} // namespace

void prepareKeys() {
    ImGui::GetIO().ConfigInputTrickleEventQueue = false; // our input queue does this
}

void setKey(int code, bool down) {
    const ImGuiKey name = nameOf(code);
    if (name != ImGuiKey_None)
        ImGui::GetIO().AddKeyEvent(name, down);
}

void setModifiers(bool control, bool shift, bool alt, bool super) {
    ImGuiIO& io = ImGui::GetIO();
    io.AddKeyEvent(ImGuiMod_Ctrl, control);
    io.AddKeyEvent(ImGuiMod_Shift, shift);
    io.AddKeyEvent(ImGuiMod_Alt, alt);
    io.AddKeyEvent(ImGuiMod_Super, super);
}

void letTabMove(bool moves) {
    const ImGuiID other = ImHashStr("tab-other");
    ImGui::SetKeyOwner(ImGuiKey_Tab, moves ? ImGuiKeyOwner_None : other, ImGuiInputFlags_None);
}

#else // Dear ImGui 1.86 uses the host's codes, and needs to know the keys for editing text

int nameOf(int code) {
    return code;
}

} // namespace

void prepareKeys() {
    for (const KeyRow& row : keyRows)
        ImGui::GetIO().KeyMap[row.name] = row.code;
}

void setKey(int code, bool down) {
    ImGuiIO& io = ImGui::GetIO();
    if (code >= 0 && static_cast<std::size_t>(code) < std::size(io.KeysDown))
        io.KeysDown[code] = down;
}

void setModifiers(bool control, bool shift, bool alt, bool super) {
    ImGuiIO& io = ImGui::GetIO();
    io.KeyCtrl = control;
    io.KeyShift = shift;
    io.KeyAlt = alt;
    io.KeySuper = super;
}

void letTabMove(bool moves) {
    ImGui::GetIO().KeyMap[ImGuiKey_Tab] = moves ? key::tab : -1;
}

#endif

void addCharacter(char32_t character) {
    constexpr ImGuiInputTextFlags ofNumbers =
        ImGuiInputTextFlags_CharsDecimal | ImGuiInputTextFlags_CharsScientific;
    const ImGuiInputTextState* field = ImGui::GetInputTextState(ImGui::GetActiveID());
    const bool isPoint = character == ',' && field && (field->Flags & ofNumbers) != 0;
    ImGui::GetIO().AddInputCharacter(isPoint ? '.' : character);
}

bool isKeyDown(int code) {
    return ImGui::IsKeyDown(nameOf(code));
}

bool isKeyPressed(int code, bool repeats) {
    return ImGui::IsKeyPressed(nameOf(code), repeats);
}

void focusNextWidget() {
    ImGui::SetWindowFocus(); // Dear ImGui 1.90 finds the widget only in the focused window
    ImGui::SetKeyboardFocusHere();
}

bool isMenuAsked() {
    return ImGui::IsItemFocused() &&
           (isKeyPressed(key::menu, false) || (ImGui::GetIO().KeyShift && isKeyPressed(key::f10, false)));
}

} // namespace texplorer::ui

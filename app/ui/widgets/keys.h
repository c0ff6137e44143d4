#pragma once

namespace texplorer::ui {

// Keys have GLFW's codes everywhere: letters and digits are ASCII, the others below. Hosts report these
// codes, and all code queries keys by these functions, because versions of Dear ImGui number them
// differently.
namespace key {
inline constexpr int space = 32;
inline constexpr int escape = 256;
inline constexpr int enter = 257;
inline constexpr int tab = 258;
inline constexpr int backspace = 259;
inline constexpr int insert = 260;
inline constexpr int del = 261;
inline constexpr int right = 262;
inline constexpr int left = 263;
inline constexpr int down = 264;
inline constexpr int up = 265;
inline constexpr int pageUp = 266;
inline constexpr int pageDown = 267;
inline constexpr int home = 268;
inline constexpr int end = 269;
inline constexpr int f1 = 290;
inline constexpr int f6 = 295;
inline constexpr int f10 = 299;
inline constexpr int f11 = 300;
inline constexpr int f12 = 301;
inline constexpr int keypadMinus = 333;
inline constexpr int keypadPlus = 334;
inline constexpr int keypadEnter = 335;
inline constexpr int firstModifier = 340; ///< Shift, Control, Alt, Super: left, then right
inline constexpr int lastModifier = 347;
inline constexpr int menu = 348;
} // namespace key

[[nodiscard]] bool isKeyDown(int code);

/// Whether a key was pressed in this frame, or repeats in it.
[[nodiscard]] bool isKeyPressed(int code, bool repeats = true);

/// Whether the keyboard opens the menu of the last widget, like a right click: the menu key or Shift+F10
/// while the widget has the focus.
[[nodiscard]] bool isMenuAsked();

/// Prepares a new Dear ImGui context for the functions below.
void prepareKeys();

/// Passes a key to Dear ImGui, before the frame. Unknown codes are ignored.
void setKey(int code, bool down);

/// Passes the held modifiers, on either side of the keyboard, to Dear ImGui, before the frame.
void setModifiers(bool control, bool shift, bool alt, bool super);

/// Passes a typed character to Dear ImGui, before the frame. In its own fields of numbers, those of sliders,
/// a comma is the decimal point: Dear ImGui 1.86 would drop it, so that 2,5 became 25.
void addCharacter(char32_t character);

/// Gives the keyboard to the next widget of the window.
void focusNextWidget();

/// Whether Tab moves between fields in the next frame; otherwise it has another meaning.
void letTabMove(bool moves);

} // namespace texplorer::ui

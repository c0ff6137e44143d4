#pragma once

namespace texplorer::ui {

// Dear ImGui 1.86 leaves key codes to the host. Ours are GLFW's: letters are their capitals in ASCII, the
// others below. Every host reports keys under these numbers.
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

/// Whether the keyboard opens the menu of the last widget, as a right click does: the key for menus, or
/// Shift+F10, where the keyboard is.
[[nodiscard]] bool isMenuAsked();

/// Tells Dear ImGui which of the codes are its own editing keys.
void mapKeys();

} // namespace texplorer::ui

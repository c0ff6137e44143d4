#pragma once

#include "app/ui/model/session.h"
#include "app/ui/state/layout.h"

#include <span>
#include <string>
#include <string_view>

namespace texplorer::ui {

/// An action of a key, with exactly the modifiers Control and Shift that it names.
struct Shortcut {
    std::string_view name; ///< for keysOf; empty: another key for the action above
    int key;               ///< see keys.h
    bool control;
    bool shift;
    const char* effect;                                  ///< "play or pause"
    void (*act)(Session& session, const Layout& layout); ///< at the end of the frame
    bool repeats = false;                                ///< repeats while the key is held
};

[[nodiscard]] std::span<const Shortcut> shortcuts();

/// The shortcut with this name.
[[nodiscard]] const Shortcut& shortcutOf(std::string_view name);

/// "Ctrl+Shift+Z"
[[nodiscard]] std::string labelOf(const Shortcut& shortcut);

/// Whether the open lesson uses the key, so that the shortcut does nothing.
[[nodiscard]] bool isTaken(const Session& session, const Shortcut& shortcut);

/// The label of the shortcut with this name, for a menu; empty while the lesson uses it.
[[nodiscard]] std::string keysOf(const Session& session, std::string_view name);

/// Handles the keys of the open lesson before the window's shortcuts and removes them from the input.
/// `popup`: a menu or a list has the keyboard. Call it before the panels are drawn.
void takeLessonKeys(Session& session, bool popup);

/// Handles the keys of this frame. Call it after the panels.
void handleShortcuts(const Session& session, const Layout& layout);

} // namespace texplorer::ui

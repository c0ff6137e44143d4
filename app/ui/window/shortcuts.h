#pragma once

#include "app/ui/model/session.h"

#include <span>
#include <string>
#include <string_view>

namespace texplorer::ui {

/// Something that a key does, with Control or Shift as it says and not otherwise.
struct Shortcut {
    std::string_view name; ///< for keysOf; empty: another key for the row above
    int key;               ///< see keys.h
    bool control;
    bool shift;
    const char* effect; ///< "play or pause"
    void (*act)(Session& session, const Layout& layout);
    bool repeats = false; ///< goes on while the key is held
};

[[nodiscard]] std::span<const Shortcut> shortcuts();

/// "Ctrl+Shift+Z"
[[nodiscard]] std::string labelOf(const Shortcut& shortcut);

/// Whether the open lesson has taken the key, so that the shortcut does nothing.
[[nodiscard]] bool isTaken(const Session& session, const Shortcut& shortcut);

/// The label of the shortcut with this name, for a menu; empty while it is taken.
[[nodiscard]] std::string keysOf(const Session& session, std::string_view name);

/// Does what the keys of this frame say. After the panels.
void handleShortcuts(Session& session, const Layout& layout);

} // namespace texplorer::ui

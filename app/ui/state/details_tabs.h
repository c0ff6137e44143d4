#pragma once

#include "texplorer/base/translatable.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

namespace texplorer::ui {

/// The places of tabs.
enum class Dock { Right, Below };

struct DockRow {
    Dock dock;
    std::string_view name; ///< in the settings file
    const char* label;
    const char* window; ///< of Dear ImGui
};

inline constexpr std::array dockRows{
    DockRow{Dock::Right, "right", N_("On the right"), N_("Right dock")},
    DockRow{Dock::Below, "below", N_("Below"), N_("Dock below")},
};

[[nodiscard]] constexpr const DockRow& rowOf(Dock dock) {
    return dockRows[static_cast<std::size_t>(dock)];
}

enum class Tab {
    Lesson,
    Vertices,
    Levels,
    Commands,
    Glsl,
    Explain,
    File,
    Memory,
    Kept,
    History,
    Figures,
    Timeline
};

struct TabRow {
    Tab tab;
    std::string_view name; ///< for texshot's --tab
    const char* label;
    const char* brief; ///< the short label
    Dock home = Dock::Below;
};

// All tabs start in the dock below: the right column is for texture space, which would be too low above a
// list, and the levels of a texture are wider than high.
inline constexpr std::array tabRows{
    TabRow{Tab::Lesson, "lesson", N_("Lesson"), N_("Lesson"), Dock::Right},
    TabRow{Tab::Vertices, "vertices", N_("Vertices"), N_("Vertices")},
    TabRow{Tab::Levels, "levels", N_("Levels"), N_("Levels")},
    TabRow{Tab::Commands, "commands", N_("Commands"), N_("Calls")},
    TabRow{Tab::Glsl, "glsl", "GLSL", "GLSL"},
    TabRow{Tab::Explain, "explain", N_("Explain"), N_("Explain")},
    TabRow{Tab::File, "file", N_("File"), N_("File")},
    TabRow{Tab::Memory, "memory", N_("Memory"), N_("Memory")},
    TabRow{Tab::Kept, "a-b", N_("A and B"), "A/B"},
    TabRow{Tab::History, "history", N_("History"), N_("History")},
    TabRow{Tab::Figures, "figures", N_("Figures"), N_("Figures")},
    TabRow{Tab::Timeline, "timeline", N_("Timeline"), N_("Time")},
};

[[nodiscard]] constexpr const TabRow& rowOf(Tab tab) {
    return tabRows[static_cast<std::size_t>(tab)];
}
static_assert(std::ranges::all_of(tabRows, [](const TabRow& row) { return &rowOf(row.tab) == &row; }));

} // namespace texplorer::ui

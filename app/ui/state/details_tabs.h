#pragma once

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
    DockRow{Dock::Right, "right", "On the right", "Right dock"},
    DockRow{Dock::Below, "below", "Below", "Dock below"},
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
    TabRow{Tab::Lesson, "lesson", "Lesson", "Lesson", Dock::Right},
    TabRow{Tab::Vertices, "vertices", "Vertices", "Vertices"},
    TabRow{Tab::Levels, "levels", "Levels", "Levels"},
    TabRow{Tab::Commands, "commands", "Commands", "Calls"},
    TabRow{Tab::Glsl, "glsl", "GLSL", "GLSL"},
    TabRow{Tab::Explain, "explain", "Explain", "Explain"},
    TabRow{Tab::File, "file", "File", "File"},
    TabRow{Tab::Memory, "memory", "Memory", "Memory"},
    TabRow{Tab::Kept, "a-b", "A and B", "A/B"},
    TabRow{Tab::History, "history", "History", "History"},
    TabRow{Tab::Figures, "figures", "Figures", "Figures"},
    TabRow{Tab::Timeline, "timeline", "Timeline", "Time"},
};

[[nodiscard]] constexpr const TabRow& rowOf(Tab tab) {
    return tabRows[static_cast<std::size_t>(tab)];
}
static_assert(std::ranges::all_of(tabRows, [](const TabRow& row) { return &rowOf(row.tab) == &row; }));

} // namespace texplorer::ui

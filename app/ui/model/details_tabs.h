#pragma once

#include <array>
#include <string_view>

namespace texplorer::ui {

/// The tabs at the lower right.
enum class Tab { Vertices, Commands, Glsl, Explain, File, Memory };

struct TabRow {
    Tab tab;
    std::string_view name; ///< for texshot's --tab
    const char* label;
    const char* brief; ///< the label where it has no room
};

inline constexpr std::array tabRows{
    TabRow{Tab::Vertices, "vertices", "Vertices", "Vertices"},
    TabRow{Tab::Commands, "commands", "Commands", "Calls"},
    TabRow{Tab::Glsl, "glsl", "GLSL", "GLSL"},
    TabRow{Tab::Explain, "explain", "Explain", "Explain"},
    TabRow{Tab::File, "file", "File", "File"},
    TabRow{Tab::Memory, "memory", "Memory", "Memory"},
};

} // namespace texplorer::ui

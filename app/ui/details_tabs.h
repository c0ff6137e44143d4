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
};

inline constexpr std::array tabRows{
    TabRow{Tab::Vertices, "vertices", "Vertices"},
    TabRow{Tab::Commands, "commands", "Commands"},
    TabRow{Tab::Glsl, "glsl", "GLSL"},
    TabRow{Tab::Explain, "explain", "Explain"},
    TabRow{Tab::File, "file", "File"},
    TabRow{Tab::Memory, "memory", "Memory"},
};

} // namespace texplorer::ui

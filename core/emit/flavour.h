#pragma once

#include "texplorer/gl/enum_row.h"

#include <array>
#include <string_view>

namespace texplorer::emit {

/// What a program is written for.
enum class Flavour : std::uint32_t { Fixed, Glsl };

inline constexpr std::array flavourRows{
    row(Flavour::Fixed, "fixed", "C with OpenGL 2.1", "C99 with GLFW, fixed function: no shaders."),
    row(Flavour::Glsl, "glsl", "C with OpenGL 3.3",
        "C99 with GLFW, the core profile and shaders in GLSL 3.30."),
};
static_assert(flavourRows.size() == 2);

} // namespace texplorer::emit

template<>
struct texplorer::EnumTable<texplorer::emit::Flavour> {
    static constexpr std::span<const EnumRow> rows = texplorer::emit::flavourRows;
};

#pragma once

#include "texplorer/gl/enum_row.h"

#include <array>
#include <string_view>

namespace texplorer::emit {

/// What a program is written for.
enum class Flavour : std::uint32_t { Fixed, Glsl, WebGl };

inline constexpr std::array flavourRows{
    row(Flavour::Fixed, "fixed", "C with OpenGL 2.1", "C99 with GLFW, fixed function: no shaders."),
    row(Flavour::Glsl, "glsl", "C with OpenGL 3.3",
        "C99 with GLFW, the core profile and shaders in GLSL 3.30."),
    row(Flavour::WebGl, "webgl", "Page with WebGL 2", "An HTML page for a browser, with shaders."),
};
static_assert(flavourRows.size() == 3);

/// Its extension, with the dot.
[[nodiscard]] constexpr std::string_view extensionOf(Flavour flavour) {
    return flavour == Flavour::WebGl ? ".html" : ".c";
}

} // namespace texplorer::emit

template<>
struct texplorer::EnumTable<texplorer::emit::Flavour> {
    static constexpr std::span<const EnumRow> rows = texplorer::emit::flavourRows;
};

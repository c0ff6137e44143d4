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

/// Where a program gets the functions of OpenGL after 1.1 from.
enum class Loader : std::uint32_t { Prototypes, Glew, Glad };

inline constexpr std::array loaderRows{
    row(Loader::Prototypes, "prototypes", "OpenGL's library",
        "GL_GLEXT_PROTOTYPES: the library has all functions, as on Linux and macOS."),
    row(Loader::Glew, "glew", "GLEW", "For Windows, too, whose library ends with OpenGL 1.1."),
    row(Loader::Glad, "glad", "glad 2",
        "For Windows, too. Needs the files that \"glad --api gl:compatibility --out-path glad c\" writes."),
};
static_assert(loaderRows.size() == 3);

} // namespace texplorer::emit

template<>
struct texplorer::EnumTable<texplorer::emit::Flavour> {
    static constexpr std::span<const EnumRow> rows = texplorer::emit::flavourRows;
};
template<>
struct texplorer::EnumTable<texplorer::emit::Loader> {
    static constexpr std::span<const EnumRow> rows = texplorer::emit::loaderRows;
};

#pragma once

#include "core/gl/enum_row.h"

namespace texplorer {

/// What draws a Scene. All draw the same; where they don't, one of them is wrong.
enum class RendererKind : std::uint32_t { Fixed, Shader, Reference };

inline constexpr std::array rendererKindRows{
    EnumRow{0,
            "fixed",
            "Fixed function",
            "OpenGL's own texture units, as programs used them before there were shaders.",
            "1.0",
            {},
            "Fixed"},
    row(RendererKind::Shader, "shader", "Shader", "The same written out in GLSL, one program for each pass.",
        "3.3"),
    row(RendererKind::Reference, "reference", "Reference",
        "The specification itself, worked out on the processor without OpenGL."),
};

template<>
struct EnumTable<RendererKind> {
    static constexpr std::span<const EnumRow> rows = rendererKindRows;
};

static_assert(rendererKindRows.size() == 3);

} // namespace texplorer

#pragma once

#include "texplorer/gl/enum_row.h"

namespace texplorer {

/// The renderers. All must draw the same picture; a difference is an error in one of them.
enum class RendererKind : std::uint32_t { Fixed, Shader, Reference };

inline constexpr std::array rendererKindRows{
    EnumRow{0,
            "fixed",
            N_("Fixed function"),
            N_("OpenGL's texture units, as programs used them before shaders."),
            "1.0",
            {},
            N_("Fixed")},
    row(RendererKind::Shader, "shader", "Shader", "The same in GLSL, with one program for each pass.", "3.3"),
    row(RendererKind::Reference, "reference", "Reference",
        "The specification, computed on the CPU without OpenGL."),
};

template<>
struct EnumTable<RendererKind> {
    static constexpr std::span<const EnumRow> rows = rendererKindRows;
};

static_assert(rendererKindRows.size() == 3);

} // namespace texplorer

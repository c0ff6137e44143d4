#pragma once

// How fog thickens with the distance: OpenGL 2.1, section 3.10.

#include "core/gl/enum_row.h"

namespace texplorer {

enum class FogMode : std::uint32_t { Linear = 0x2601, Exp = 0x0800, Exp2 = 0x0801 };

inline constexpr std::array fogModeRows{
    row(FogMode::Linear, "GL_LINEAR", "Linear", "From no fog at the start to nothing else at the end.",
        "1.0"),
    row(FogMode::Exp, "GL_EXP", "Exponential",
        "What is left is e^(-density * distance): thick at once, never quite everything.", "1.0"),
    row(FogMode::Exp2, "GL_EXP2", "Exp. squared",
        "What is left is e^(-(density * distance)^2): clear nearby, then quickly thick.", "1.0"),
};

template<>
struct EnumTable<FogMode> {
    static constexpr std::span<const EnumRow> rows = fogModeRows;
};

static_assert(fogModeRows.size() == 3);

} // namespace texplorer

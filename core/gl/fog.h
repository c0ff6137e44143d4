#pragma once

// How fog depends on the distance: OpenGL 2.1, section 3.10.

#include "texplorer/gl/enum_row.h"

namespace texplorer {

enum class FogMode : std::uint32_t { Linear = 0x2601, Exp = 0x0800, Exp2 = 0x0801 };

inline constexpr std::array fogModeRows{
    row(FogMode::Linear, "GL_LINEAR", "Linear", "No fog at the start, only fog at the end.", "1.0"),
    row(FogMode::Exp, "GL_EXP", "Exponential",
        "e^(-density * distance) of a colour is left. Dense from the beginning, never complete.", "1.0"),
    row(FogMode::Exp2, "GL_EXP2", "Exp. squared",
        "e^(-(density * distance)^2) of a colour is left. Clear nearby, then quickly dense.", "1.0"),
};

template<>
struct EnumTable<FogMode> {
    static constexpr std::span<const EnumRow> rows = fogModeRows;
};

static_assert(fogModeRows.size() == 3);

} // namespace texplorer

#pragma once

// Hints, which OpenGL may ignore: OpenGL 2.1, section 5.6.

#include "texplorer/gl/enum_row.h"

namespace texplorer {

enum class HintMode : std::uint32_t { DontCare = 0x1100, Fastest = 0x1101, Nicest = 0x1102 };

inline constexpr std::array hintModeRows{
    row(HintMode::DontCare, "GL_DONT_CARE", "Don't care", "OpenGL decides.", "1.0"),
    row(HintMode::Fastest, "GL_FASTEST", "Fastest", "The fastest method of OpenGL, regardless of quality.",
        "1.0"),
    row(HintMode::Nicest, "GL_NICEST", "Nicest", "The most correct method of OpenGL.", "1.0"),
};

template<>
struct EnumTable<HintMode> {
    static constexpr std::span<const EnumRow> rows = hintModeRows;
};

static_assert(hintModeRows.size() == 3);

} // namespace texplorer

#pragma once

#include "texplorer/gl/combine.h"

namespace texplorer {

/// The equation of a GL_COMBINE function, before scale and clamp: OpenGL 2.1, table 3.23.
[[nodiscard]] constexpr std::string_view equationOf(CombineRgb function) {
    switch (function) {
    case CombineRgb::Replace:
        return N_("Arg0");
    case CombineRgb::Modulate:
        return N_("Arg0 × Arg1");
    case CombineRgb::Add:
        return N_("Arg0 + Arg1");
    case CombineRgb::AddSigned:
        return N_("Arg0 + Arg1 − ½");
    case CombineRgb::Interpolate:
        return N_("Arg0 × Arg2 + Arg1 × (1 − Arg2)");
    case CombineRgb::Subtract:
        return N_("Arg0 − Arg1");
    case CombineRgb::Dot3Rgb:
    case CombineRgb::Dot3Rgba:
        return N_("4 × (Arg0 − ½) · (Arg1 − ½)");
    }
    return {};
}
[[nodiscard]] constexpr std::string_view equationOf(CombineAlpha function) {
    return equationOf(static_cast<CombineRgb>(function));
}

} // namespace texplorer

#pragma once

// How a colour passes through the texture units: OpenGL 2.1, section 3.8.13, tables 3.20 to 3.24. Included
// only by diagnosis*.cpp.

#include "texplorer/diagnosis/diagnosis_rules.h"

namespace texplorer::diagnosis {

/// The parts of a colour that a value can depend on.
struct Parts {
    bool rgb = false;
    bool alpha = false;

    [[nodiscard]] bool any() const { return rgb || alpha; }
    bool operator==(const Parts&) const = default;
};
[[nodiscard]] constexpr Parts operator|(Parts a, Parts b) {
    return {a.rgb || b.rgb, a.alpha || b.alpha};
}

/// What the colour and the alpha of a fragment can depend on.
struct ColorFlow {
    Parts rgb;
    Parts alpha;

    [[nodiscard]] Parts all() const { return rgb | alpha; }
    bool operator==(const ColorFlow&) const = default;
};
[[nodiscard]] constexpr ColorFlow operator|(const ColorFlow& a, const ColorFlow& b) {
    return {a.rgb | b.rgb, a.alpha | b.alpha};
}

/// The colour itself: rgb depends on rgb, alpha on alpha.
inline constexpr ColorFlow wholeColor{{true, false}, {false, true}};

/// Returns what can leave an active unit that receives `previous`, with the primary colour `primary`. If the
/// specification leaves the result undefined, everything that enters can leave.
[[nodiscard]] ColorFlow flowThrough(const Case& about, const Pass& pass, const Unit& unit,
                                    const ColorFlow& previous, const ColorFlow& primary);

/// The parts of the primary colour that the fragments of a pass depend on before the colour sum.
[[nodiscard]] Parts primaryInFragments(const Case& about, const Pass& pass);

} // namespace texplorer::diagnosis

#pragma once

// How far a colour gets through the texture units: OpenGL 2.1, section 3.8.13, tables 3.20 to 3.24. Only
// diagnosis*.cpp include this.

#include "core/diagnosis/diagnosis_rules.h"

namespace texplorer::diagnosis {

/// Which parts of one colour a value may depend on.
struct Parts {
    bool rgb = false;
    bool alpha = false;

    [[nodiscard]] bool any() const { return rgb || alpha; }
    bool operator==(const Parts&) const = default;
};
[[nodiscard]] constexpr Parts operator|(Parts a, Parts b) {
    return {a.rgb || b.rgb, a.alpha || b.alpha};
}

/// What the colour and the alpha of a fragment may depend on.
struct ColorFlow {
    Parts rgb;
    Parts alpha;

    [[nodiscard]] Parts all() const { return rgb | alpha; }
    bool operator==(const ColorFlow&) const = default;
};
[[nodiscard]] constexpr ColorFlow operator|(const ColorFlow& a, const ColorFlow& b) {
    return {a.rgb | b.rgb, a.alpha | b.alpha};
}

/// The colour itself: its rgb depends on its rgb.
inline constexpr ColorFlow wholeColor{{true, false}, {false, true}};

/// What leaves a unit that works, when `previous` enters it and `primary` is the primary colour. Where the
/// specification leaves the result undefined, everything that enters may leave.
[[nodiscard]] ColorFlow flowThrough(const Case& about, const Pass& pass, const Unit& unit,
                                    const ColorFlow& previous, const ColorFlow& primary);

/// Which parts of the primary colour the fragments of a pass depend on before the colour sum.
[[nodiscard]] Parts primaryInFragments(const Case& about, const Pass& pass);

} // namespace texplorer::diagnosis

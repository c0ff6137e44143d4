// GL_COMBINE: OpenGL 2.1, section 3.8.13.

#include "texplorer/diagnosis/diagnosis_rules.h"
#include "texplorer/gl/combine_arguments.h"

#include <fmt/core.h>

#include <algorithm>

namespace texplorer::diagnosis {
namespace {

/// The texture of a unit that is off, or incomplete, is undefined.
void undefinedCrossbar(const Case& about, Report& report) {
    forEachUnit(about.scene, [&](const Unit& unit, const std::string& path, std::size_t pass) {
        if (unit.envMode != EnvMode::Combine || !about.works(unit))
            return;
        for (const Argument& each : argumentsOf(unit.combine)) {
            const std::optional<std::size_t> asked = crossbarUnit(each.source);
            if (!each.read || !asked)
                continue;
            const Unit& other = about.scene.passes[pass].units[*asked];
            if (about.works(other))
                continue;
            const std::string source = fmt::format("{}{}.{}", path, keyOf<&Unit::combine>(), each.sourceKey);
            report.add(source,
                       other.enabled
                           ? Sentence("{0} is undefined: unit {1} has no complete texture",
                                      named(each.source), *asked)
                           : Sentence("{0} is undefined: unit {1} is off", named(each.source), *asked),
                       Fix{N_("Take this unit's texture"), {{source, nameOf(CombineSource::Texture)}}});
        }
    });
}

void unreadArguments(const Case& about, Report& report) {
    forEachUnit(about.scene, [&](const Unit& unit, const std::string& path, std::size_t) {
        if (unit.envMode != EnvMode::Combine)
            return;
        const Combine& combine = unit.combine;
        const std::string own = fmt::format("{}{}.", path, keyOf<&Unit::combine>());
        const bool dot = combine.rgb == CombineRgb::Dot3Rgba;
        const Sentence overruled = Sentence("{0} gives alpha, too", named(combine.rgb));
        if (dot) // its scale stays: ARB_texture_env_dot3 multiplies alpha by it
            report.add(own + keyOf<&Combine::alpha>(), overruled);
        for (const Argument& each : argumentsOf(combine)) {
            if (each.read)
                continue;
            const int count = each.ofAlpha ? argumentCount(combine.alpha) : argumentCount(combine.rgb);
            const Sentence function = each.ofAlpha ? named(combine.alpha) : named(combine.rgb);
            const Sentence reason = each.ofAlpha && dot
                                        ? overruled
                                        : Sentence("{0} reads {1} only", function,
                                                   Sentence::plural("{0} argument", "{0} arguments", count));
            report.add(own + std::string(each.sourceKey), reason);
            report.add(own + std::string(each.operandKey), reason);
        }
    });
}

void otherMode(const Case& about, Report& report) {
    forEachUnit(about.scene, [&](const Unit& unit, const std::string& path, std::size_t) {
        if (unit.envMode != EnvMode::Combine)
            report.add(path + keyOf<&Unit::combine>(),
                       Sentence("the mode is {0}, not {1}", named(unit.envMode), named(EnvMode::Combine)));
    });
}

struct ArgumentRow {
    Key sourceKey;
    Key operandKey;
    CombineSource Combine::*source;
    int number;
    bool ofAlpha;
};

template<auto Source, auto Operand>
constexpr ArgumentRow argument(int number, bool ofAlpha) {
    return {keyOf<Source>, keyOf<Operand>, Source, number, ofAlpha};
}

constexpr std::array arguments{
    argument<&Combine::source0Rgb, &Combine::operand0Rgb>(0, false),
    argument<&Combine::source1Rgb, &Combine::operand1Rgb>(1, false),
    argument<&Combine::source2Rgb, &Combine::operand2Rgb>(2, false),
    argument<&Combine::source0Alpha, &Combine::operand0Alpha>(0, true),
    argument<&Combine::source1Alpha, &Combine::operand1Alpha>(1, true),
    argument<&Combine::source2Alpha, &Combine::operand2Alpha>(2, true),
};

constexpr std::array combineRuleRows{
    Rule{"undefined-crossbar", Severity::Warning, undefinedCrossbar},
    Rule{"unread-argument", Severity::Hint, unreadArguments},
    Rule{"other-environment", Severity::Unused, otherMode},
};

} // namespace

std::array<Argument, 6> argumentsOf(const Combine& combine) {
    const int rgb = argumentCount(combine.rgb);
    const int alpha = combine.rgb == CombineRgb::Dot3Rgba ? 0 : argumentCount(combine.alpha);
    std::array<Argument, 6> found{};
    std::ranges::transform(arguments, found.begin(), [&](const ArgumentRow& row) {
        return Argument{row.sourceKey(), row.operandKey(), combine.*row.source,
                        row.number < (row.ofAlpha ? alpha : rgb), row.ofAlpha};
    });
    return found;
}

std::span<const Rule> combineRules() {
    return combineRuleRows;
}

} // namespace texplorer::diagnosis

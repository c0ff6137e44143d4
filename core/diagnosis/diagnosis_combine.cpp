// GL_COMBINE: OpenGL 2.1, section 3.8.13.

#include "core/gl/combine_arguments.h"
#include "core/diagnosis/diagnosis_rules.h"

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
            const std::string source = path + "combine." + std::string(each.sourceKey);
            report.add(source,
                       nameOf(each.source) + " is undefined: unit " + std::to_string(*asked) +
                           (other.enabled ? " has no texture that is complete" : " is off"),
                       Fix{"Take this unit's texture", {{source, nameOf(CombineSource::Texture)}}});
        }
    });
}

void unreadArguments(const Case& about, Report& report) {
    forEachUnit(about.scene, [&](const Unit& unit, const std::string& path, std::size_t) {
        if (unit.envMode != EnvMode::Combine)
            return;
        const Combine& combine = unit.combine;
        const std::string own = path + "combine.";
        const bool dot = combine.rgb == CombineRgb::Dot3Rgba;
        const std::string overruled = nameOf(combine.rgb) + " gives alpha, too";
        if (dot) // its scale stays: ARB_texture_env_dot3 multiplies alpha by it
            report.add(own + "alpha", overruled);
        for (const Argument& each : argumentsOf(combine)) {
            if (each.read)
                continue;
            const int count = each.ofAlpha ? argumentCount(combine.alpha) : argumentCount(combine.rgb);
            const std::string function = each.ofAlpha ? nameOf(combine.alpha) : nameOf(combine.rgb);
            const std::string reason = each.ofAlpha && dot
                                           ? overruled
                                           : function + " reads " + std::to_string(count) +
                                                 (count == 1 ? " argument" : " arguments") + " only";
            report.add(own + std::string(each.sourceKey), reason);
            report.add(own + std::string(each.operandKey), reason);
        }
    });
}

void otherMode(const Case& about, Report& report) {
    forEachUnit(about.scene, [&](const Unit& unit, const std::string& path, std::size_t) {
        if (unit.envMode != EnvMode::Combine)
            report.add(path + "combine",
                       "the mode is " + nameOf(unit.envMode) + ", not " + nameOf(EnvMode::Combine));
    });
}

constexpr std::array rules{
    Rule{"undefined-crossbar", Severity::Warning, undefinedCrossbar},
    Rule{"unread-argument", Severity::Hint, unreadArguments},
    Rule{"other-environment", Severity::Unused, otherMode},
};

} // namespace

std::array<Argument, 6> argumentsOf(const Combine& combine) {
    const int rgb = argumentCount(combine.rgb);
    const int alpha = combine.rgb == CombineRgb::Dot3Rgba ? 0 : argumentCount(combine.alpha);
    return {{{"source0Rgb", "operand0Rgb", combine.source0Rgb, rgb > 0, false},
             {"source1Rgb", "operand1Rgb", combine.source1Rgb, rgb > 1, false},
             {"source2Rgb", "operand2Rgb", combine.source2Rgb, rgb > 2, false},
             {"source0Alpha", "operand0Alpha", combine.source0Alpha, alpha > 0, true},
             {"source1Alpha", "operand1Alpha", combine.source1Alpha, alpha > 1, true},
             {"source2Alpha", "operand2Alpha", combine.source2Alpha, alpha > 2, true}}};
}

std::span<const Rule> combineRules() {
    return rules;
}

} // namespace texplorer::diagnosis

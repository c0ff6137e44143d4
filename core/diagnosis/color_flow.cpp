#include "texplorer/diagnosis/color_flow.h"

#include "texplorer/gl/combine_arguments.h"

#include <algorithm>

namespace texplorer::diagnosis {
namespace {

bool hasColor(BaseFormat format) {
    return format != BaseFormat::Alpha;
}

bool hasAlpha(BaseFormat format) {
    return format != BaseFormat::Luminance && format != BaseFormat::Rgb;
}

/// A combiner's argument: its source's colour or alpha.
Parts argumentFlow(const Case& about, const Pass& pass, const CombineArgument& argument, bool ofAlpha,
                   const ColorFlow& previous, const ColorFlow& primary) {
    const std::optional<std::size_t> asked = crossbarUnit(argument.source);
    if (asked && !about.works(pass.units[*asked]))
        return previous.all() | primary.all();
    const bool takesAlpha = ofAlpha || argument.operand == OperandRgb::SrcAlpha ||
                            argument.operand == OperandRgb::OneMinusSrcAlpha;
    if (argument.source == CombineSource::Previous)
        return takesAlpha ? previous.alpha : previous.rgb;
    if (argument.source == CombineSource::PrimaryColor)
        return takesAlpha ? primary.alpha : primary.rgb;
    return {};
}

ColorFlow combined(const Case& about, const Pass& pass, const Combine& combine, const ColorFlow& previous,
                   const ColorFlow& primary) {
    ColorFlow result;
    const auto add = [&](Parts& to, const CombineArguments& arguments, int count, bool ofAlpha) {
        for (int i = 0; i < count; ++i)
            to = to | argumentFlow(about, pass, arguments[static_cast<std::size_t>(i)], ofAlpha, previous,
                                   primary);
    };
    add(result.rgb, rgbArguments(combine), argumentCount(combine.rgb), false);
    if (combine.rgb == CombineRgb::Dot3Rgba)
        result.alpha = result.rgb;
    else
        add(result.alpha, alphaArguments(combine), argumentCount(combine.alpha), true);
    return result;
}

} // namespace

ColorFlow flowThrough(const Case& about, const Pass& pass, const Unit& unit, const ColorFlow& previous,
                      const ColorFlow& primary) {
    const BaseFormat format = about.textureOf(unit)->as(unit.target)->format;
    switch (unit.envMode) {
    case EnvMode::Replace:
        return {hasColor(format) ? Parts{} : previous.rgb, hasAlpha(format) ? Parts{} : previous.alpha};
    case EnvMode::Decal: // RGB: the texture's colour; RGBA: between it and the fragment's
        if (format == BaseFormat::Rgb)
            return {{}, previous.alpha};
        return format == BaseFormat::Rgba ? previous : ColorFlow{previous.all(), previous.all()};
    case EnvMode::Combine:
        return combined(about, pass, unit.combine, previous, primary);
    case EnvMode::Modulate:
    case EnvMode::Blend:
    case EnvMode::Add: // each component of the fragment's has a share in its own
        return previous;
    }
    return {previous.all(), previous.all()};
}

Parts primaryInFragments(const Case& about, const Pass& pass) {
    const auto limit = static_cast<std::size_t>(std::max(0, about.driver.textureUnits));
    ColorFlow flow = wholeColor;
    for (std::size_t u = 0; u < maxUnits; ++u) {
        const Unit& unit = pass.units[u];
        if (!about.works(unit))
            continue;
        const ColorFlow left = flowThrough(about, pass, unit, flow, wholeColor);
        flow = u < limit ? left : flow | left; // the driver draws without it, the reference with it
    }
    return flow.all();
}

} // namespace texplorer::diagnosis

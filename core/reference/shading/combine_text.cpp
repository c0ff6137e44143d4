#include "texplorer/gl/combine_arguments.h"
#include "texplorer/gl/combine_equation.h"
#include "texplorer/reference/shading/combine.h"
#include "texplorer/reference/shading/equation_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <string>

namespace texplorer::reference {

namespace {

/// "Cs", or "As2" where the operand takes the alpha of unit 2.
std::string symbolOf(const CombineArgument& argument, bool alpha) {
    std::string symbol(alpha ? "A" : "C");
    switch (argument.source) {
    case CombineSource::Texture:
        return symbol + "s";
    case CombineSource::Constant:
        return symbol + "c";
    case CombineSource::PrimaryColor:
        return symbol + "f";
    case CombineSource::Previous:
        return symbol + "p";
    default:
        return fmt::format("{}s{}", symbol, crossbarUnit(argument.source).value_or(0));
    }
}

std::string withOperand(const CombineArgument& argument, bool forAlpha) {
    switch (argument.operand) {
    case OperandRgb::SrcColor:
        return symbolOf(argument, forAlpha);
    case OperandRgb::OneMinusSrcColor:
        return fmt::format("(1 - {})", symbolOf(argument, forAlpha));
    case OperandRgb::SrcAlpha:
        return symbolOf(argument, true);
    case OperandRgb::OneMinusSrcAlpha:
        return fmt::format("(1 - {})", symbolOf(argument, true));
    }
    return symbolOf(argument, forAlpha);
}

void replaceAll(std::string& text, std::string_view from, std::string_view to) {
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
        text.replace(at, from.size(), to);
}

/// The function with its arguments and its scale, in the signs that the other environments are written with.
std::string functionText(CombineRgb function, const CombineArguments& arguments, CombineScale scale,
                         bool forAlpha) {
    std::string text(equationOf(function));
    replaceAll(text, "×", "*");
    replaceAll(text, "−", "-");
    replaceAll(text, "½", "0.5");
    for (std::size_t i = 0; i < arguments.size(); ++i)
        replaceAll(text, fmt::format("Arg{}", i), withOperand(arguments[i], forAlpha));
    if (scale == CombineScale::One)
        return text;
    const std::string factor = fmt::format("{} * ", static_cast<int>(scale));
    return text.find(' ') == std::string::npos ? factor + text : fmt::format("{}({})", factor, text);
}

bool isDot(CombineRgb function) {
    return function == CombineRgb::Dot3Rgb || function == CombineRgb::Dot3Rgba;
}

/// Every symbol's value in one component.
class Values {
public:
    Values(const EnvironmentInputs& inputs, std::span<const glm::vec4* const> textures)
        : inputs_(inputs)
        , textures_(textures) {}

    [[nodiscard]] std::string operator()(std::string_view symbols, int component) const {
        const auto textureOf = [&](std::size_t unit) {
            return unit < textures_.size() && textures_[unit] ? *textures_[unit] : glm::vec4(0);
        };
        const std::array units{textureOf(0), textureOf(1), textureOf(2), textureOf(3)};
        return inNumbers(symbols, {{N_("Cp"), inputs_.previous[component]},
                                   {N_("Cs"), inputs_.source[component]},
                                   {N_("Cc"), inputs_.constant[component]},
                                   {N_("Cf"), inputs_.primary[component]},
                                   {N_("Ap"), inputs_.previous.a},
                                   {N_("As"), inputs_.source.a},
                                   {N_("Ac"), inputs_.constant.a},
                                   {N_("Af"), inputs_.primary.a},
                                   {N_("Cs0"), units[0][component]},
                                   {N_("Cs1"), units[1][component]},
                                   {N_("Cs2"), units[2][component]},
                                   {N_("Cs3"), units[3][component]},
                                   {N_("As0"), units[0].a},
                                   {N_("As1"), units[1].a},
                                   {N_("As2"), units[2].a},
                                   {N_("As3"), units[3].a}});
    }

private:
    const EnvironmentInputs& inputs_;
    std::span<const glm::vec4* const> textures_;
};

/// Red's, green's and blue's terms of a dot product differ, so that each is written with its own numbers.
std::string dotNumbers(const CombineArguments& arguments, CombineScale scale, const Values& values) {
    const std::string term = fmt::format("({} - 0.5) * ({} - 0.5)", withOperand(arguments[0], false),
                                         withOperand(arguments[1], false));
    std::string sum;
    for (int component = 0; component < 3; ++component)
        sum += (component == 0 ? "" : " + ") + values(term, component);
    const std::string text = fmt::format("4 * ({})", sum);
    return scale == CombineScale::One ? text : fmt::format("{} * {}", static_cast<int>(scale), text);
}

} // namespace

EnvironmentEquations equationsOf(const Combine& combine, const EnvironmentInputs& inputs,
                                 std::span<const glm::vec4* const> textures) {
    const Values values(inputs, textures);
    EnvironmentEquations equations;
    const EnvironmentResult result = evaluateUnclamped(combine, inputs, textures);
    equations.undefined = result.undefined;
    if (equations.undefined) {
        equations.color.symbols = N_("Cv = undefined; here Cp");
        equations.alpha.symbols = N_("Av = undefined; here Ap");
        for (int i = 0; i < 4; ++i)
            (i < 3 ? equations.color : equations.alpha)
                .numbers.push_back(withResult(shortNumber(inputs.previous[i]), inputs.previous[i]));
        return equations;
    }
    const CombineArguments rgb = rgbArguments(combine);
    const bool dot = isDot(combine.rgb);
    const std::string color = functionText(combine.rgb, rgb, combine.rgbScale, false);
    equations.color.symbols = fmt::format("Cv = {}", color);
    for (int i = 0; i < 3; ++i)
        equations.color.numbers.push_back(
            withResult(dot ? dotNumbers(rgb, combine.rgbScale, values) : values(color, i), result.color[i]));
    if (combine.rgb == CombineRgb::Dot3Rgba) { // the same product, with alpha's scale
        equations.alpha.symbols =
            fmt::format("Av = {}", functionText(combine.rgb, rgb, combine.alphaScale, false));
        equations.alpha.numbers.push_back(
            withResult(dotNumbers(rgb, combine.alphaScale, values), result.color.a));
        return equations;
    }
    const std::string alpha = functionText(static_cast<CombineRgb>(combine.alpha), alphaArguments(combine),
                                           combine.alphaScale, true);
    equations.alpha.symbols = fmt::format("Av = {}", alpha);
    equations.alpha.numbers.push_back(withResult(values(alpha, 3), result.color.a));
    return equations;
}

} // namespace texplorer::reference

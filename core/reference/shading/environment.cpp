#include "texplorer/reference/shading/environment.h"

#include "texplorer/reference/shading/equation_text.h"

#include <fmt/core.h>
#include <glm/common.hpp>

#include <algorithm>
#include <array>

namespace texplorer::reference {

namespace {

using Function = EnvFunction;

struct FunctionRow {
    Function function;
    std::string_view color; ///< with the symbols of the specification
    std::string_view alpha;
};

constexpr std::array functionRows{
    FunctionRow{Function::Previous, N_("Cp"), N_("Ap")},
    FunctionRow{Function::Source, N_("Cs"), N_("As")},
    FunctionRow{Function::Product, N_("Cp * Cs"), N_("Ap * As")},
    FunctionRow{Function::Sum, N_("Cp + Cs"), N_("Ap + As")},
    FunctionRow{Function::Decal, N_("Cp * (1 - As) + Cs * As"), ""},
    FunctionRow{Function::Blend, N_("Cp * (1 - Cs) + Cc * Cs"), N_("Ap * (1 - As) + Ac * As")},
    FunctionRow{Function::Undefined, N_("undefined; here Cp"), N_("undefined; here Ap")},
};

/// One component: `previous`, `source` and `constant` are those of this component.
float apply(Function function, float previous, float source, float constant, float sourceAlpha) {
    switch (function) {
    case Function::Previous:
    case Function::Undefined:
        return previous;
    case Function::Source:
        return source;
    case Function::Product:
        return previous * source;
    case Function::Sum:
        return previous + source;
    case Function::Decal:
        return previous * (1 - sourceAlpha) + source * sourceAlpha;
    case Function::Blend:
        return previous * (1 - source) + constant * source;
    }
    return previous;
}

const FunctionRow& rowOf(Function function) {
    return functionRows[static_cast<std::size_t>(function)];
}

Sentence numbersOf(std::string_view symbols, const EnvironmentInputs& in, int component, float result) {
    return withResult(inNumbers(symbols, {{N_("Cp"), in.previous[component]},
                                          {N_("Cs"), in.source[component]},
                                          {N_("Cc"), in.constant[component]},
                                          {N_("Ap"), in.previous.a},
                                          {N_("As"), in.source.a},
                                          {N_("Ac"), in.constant.a}}),
                      result);
}

} // namespace

/// The cell of the tables. A format without colour leaves the incoming colour alone, one without alpha the
/// incoming alpha; intensity stands for both.
EnvCell environmentCell(EnvMode mode, BaseFormat format) {
    using F = Function;
    const bool hasColor = format != BaseFormat::Alpha;
    const bool hasAlpha = format != BaseFormat::Luminance && format != BaseFormat::Rgb;
    const bool isIntensity = format == BaseFormat::Intensity;
    const auto color = [&](F function) { return hasColor ? function : F::Previous; };
    const auto alpha = [&](F function) { return hasAlpha ? function : F::Previous; };
    switch (mode) {
    case EnvMode::Replace:
        return {color(F::Source), alpha(F::Source)};
    case EnvMode::Modulate:
        return {color(F::Product), alpha(F::Product)};
    case EnvMode::Decal:
        if (format == BaseFormat::Rgb)
            return {F::Source, F::Previous};
        if (format == BaseFormat::Rgba)
            return {F::Decal, F::Previous};
        return {F::Undefined, F::Undefined};
    case EnvMode::Blend:
        return {color(F::Blend), isIntensity ? F::Blend : alpha(F::Product)};
    case EnvMode::Add:
        return {color(F::Sum), isIntensity ? F::Sum : alpha(F::Product)};
    case EnvMode::Combine: // see combine.h
        break;
    }
    return {F::Undefined, F::Undefined};
}

EnvironmentResult evaluate(EnvMode mode, BaseFormat format, const EnvironmentInputs& inputs) {
    const auto& [previous, source, constant, primary] = inputs;
    const EnvCell cell = environmentCell(mode, format);
    EnvironmentResult result;
    for (int i = 0; i < 4; ++i)
        result.color[i] =
            apply(i < 3 ? cell.color : cell.alpha, previous[i], source[i], constant[i], source.a);
    result.color = glm::clamp(result.color, 0.0F, 1.0F);
    result.undefined = cell.color == Function::Undefined;
    return result;
}

EnvironmentEquations equationsOf(EnvMode mode, BaseFormat format, const EnvironmentInputs& inputs) {
    const auto& [previous, source, constant, primary] = inputs;
    const EnvCell cell = environmentCell(mode, format);
    EnvironmentEquations equations;
    equations.undefined = cell.color == Function::Undefined;
    equations.color.symbols = fmt::format("Cv = {}", rowOf(cell.color).color);
    equations.alpha.symbols = fmt::format("Av = {}", rowOf(cell.alpha).alpha);
    for (int i = 0; i < 4; ++i) {
        const Function function = i < 3 ? cell.color : cell.alpha;
        const float result = apply(function, previous[i], source[i], constant[i], source.a);
        const bool undefined = function == Function::Undefined;
        const std::string_view symbols = undefined ? (i < 3 ? N_("Cp") : N_("Ap"))
                                         : i < 3   ? rowOf(function).color
                                                   : rowOf(function).alpha;
        (i < 3 ? equations.color : equations.alpha).numbers.push_back(numbersOf(symbols, inputs, i, result));
    }
    return equations;
}

} // namespace texplorer::reference

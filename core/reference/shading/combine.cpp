#include "texplorer/reference/shading/combine.h"

#include "texplorer/gl/combine_arguments.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <optional>

namespace texplorer::reference {

namespace {

/// Table 3.24's and 3.25's SRCn.
std::optional<glm::vec4> sourceOf(CombineSource source, const EnvironmentInputs& in,
                                  std::span<const glm::vec4* const> textures) {
    switch (source) {
    case CombineSource::Texture:
        return in.source;
    case CombineSource::Constant:
        return in.constant;
    case CombineSource::PrimaryColor:
        return in.primary;
    case CombineSource::Previous:
        return in.previous;
    default:
        break;
    }
    const std::optional<std::size_t> unit = crossbarUnit(source);
    if (!unit || *unit >= textures.size() || !textures[*unit])
        return std::nullopt;
    return *textures[*unit];
}

/// OPERANDn.
glm::vec4 operandOf(OperandRgb operand, glm::vec4 source) {
    switch (operand) {
    case OperandRgb::SrcColor:
        return source;
    case OperandRgb::OneMinusSrcColor:
        return 1.0F - source;
    case OperandRgb::SrcAlpha:
        return glm::vec4(source.a);
    case OperandRgb::OneMinusSrcAlpha:
        return glm::vec4(1 - source.a);
    }
    return source;
}

/// Table 3.23; alpha's functions are six of these, with the same numbers.
glm::vec4 applyFunction(CombineRgb function, const std::array<glm::vec4, 3>& arguments) {
    const auto& [first, second, third] = arguments;
    switch (function) {
    case CombineRgb::Replace:
        return first;
    case CombineRgb::Modulate:
        return first * second;
    case CombineRgb::Add:
        return first + second;
    case CombineRgb::AddSigned:
        return first + second - 0.5F;
    case CombineRgb::Interpolate:
        return first * third + second * (1.0F - third);
    case CombineRgb::Subtract:
        return first - second;
    case CombineRgb::Dot3Rgb:
    case CombineRgb::Dot3Rgba:
        return glm::vec4(4 * glm::dot(glm::vec3(first) - 0.5F, glm::vec3(second) - 0.5F));
    }
    return first;
}

/// The function of the arguments that it reads, or nothing where one of them is undefined.
std::optional<glm::vec4> combined(CombineRgb function, const CombineArguments& from,
                                  const EnvironmentInputs& in, std::span<const glm::vec4* const> textures) {
    std::array<glm::vec4, 3> arguments{};
    for (std::size_t i = 0; i < static_cast<std::size_t>(argumentCount(function)); ++i) {
        const std::optional<glm::vec4> source = sourceOf(from[i].source, in, textures);
        if (!source)
            return std::nullopt;
        arguments[i] = operandOf(from[i].operand, *source);
    }
    return applyFunction(function, arguments);
}

float factorOf(CombineScale scale) {
    return static_cast<float>(scale);
}

} // namespace

EnvironmentResult evaluateUnclamped(const Combine& combine, const EnvironmentInputs& inputs,
                                    std::span<const glm::vec4* const> textures) {
    const EnvironmentResult passedOn{inputs.previous, true};
    const std::optional<glm::vec4> rgb = combined(combine.rgb, rgbArguments(combine), inputs, textures);
    if (!rgb)
        return passedOn;
    glm::vec4 color = *rgb * factorOf(combine.rgbScale);
    if (combine.rgb == CombineRgb::Dot3Rgba) { // alpha's function is ignored, its scale is not
        color.a = rgb->a * factorOf(combine.alphaScale);
    } else {
        const std::optional<glm::vec4> alpha =
            combined(static_cast<CombineRgb>(combine.alpha), alphaArguments(combine), inputs, textures);
        if (!alpha)
            return passedOn;
        color.a = alpha->a * factorOf(combine.alphaScale);
    }
    return {color, false};
}

EnvironmentResult evaluate(const Combine& combine, const EnvironmentInputs& inputs,
                           std::span<const glm::vec4* const> textures) {
    EnvironmentResult result = evaluateUnclamped(combine, inputs, textures);
    result.color = glm::clamp(result.color, 0.0F, 1.0F);
    return result;
}

} // namespace texplorer::reference

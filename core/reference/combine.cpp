#include "core/reference/combine.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace texplorer::reference {

namespace {

constexpr auto firstUnit = static_cast<std::uint32_t>(CombineSource::Texture0);

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
    const auto unit = static_cast<std::size_t>(static_cast<std::uint32_t>(source) - firstUnit);
    if (unit >= textures.size() || !textures[unit])
        return std::nullopt;
    return *textures[unit];
}

/// OPERANDn: a component of the source, or of its complement.
glm::vec4 operandOf(CombineOperand operand, glm::vec4 source) {
    switch (operand) {
    case CombineOperand::SrcColor:
        return source;
    case CombineOperand::OneMinusSrcColor:
        return 1.0F - source;
    case CombineOperand::SrcAlpha:
        return glm::vec4(source.a);
    case CombineOperand::OneMinusSrcAlpha:
        return glm::vec4(1 - source.a);
    }
    return source;
}

/// Table 3.23: how many of the three arguments a function reads.
int argumentCount(CombineFunction function) {
    return function == CombineFunction::Replace ? 1 : function == CombineFunction::Interpolate ? 3 : 2;
}

glm::vec4 applyFunction(CombineFunction function, const std::array<glm::vec4, 3>& arguments) {
    const auto& [first, second, third] = arguments;
    switch (function) {
    case CombineFunction::Replace:
        return first;
    case CombineFunction::Modulate:
        return first * second;
    case CombineFunction::Add:
        return first + second;
    case CombineFunction::AddSigned:
        return first + second - 0.5F;
    case CombineFunction::Interpolate:
        return first * third + second * (1.0F - third);
    case CombineFunction::Subtract:
        return first - second;
    case CombineFunction::Dot3Rgb:
    case CombineFunction::Dot3Rgba:
        return glm::vec4(4 * glm::dot(glm::vec3(first) - 0.5F, glm::vec3(second) - 0.5F));
    }
    return first;
}

/// The arguments that a function reads, or nothing where one of them is undefined.
std::optional<glm::vec4> combined(CombineFunction function, const std::array<CombineArgument, 3>& from,
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

bool isAlphaFunction(CombineFunction function) {
    return function != CombineFunction::Dot3Rgb && function != CombineFunction::Dot3Rgba;
}

bool isAlphaOperand(const CombineArgument& argument) {
    return argument.operand == CombineOperand::SrcAlpha ||
           argument.operand == CombineOperand::OneMinusSrcAlpha;
}

bool isAllowed(const Combine& combine) {
    return combine.rgb == CombineFunction::Dot3Rgba ||
           (isAlphaFunction(combine.alpha) && std::ranges::all_of(combine.alphaArguments, isAlphaOperand));
}

} // namespace

EnvironmentResult evaluate(const Combine& combine, const EnvironmentInputs& inputs,
                           std::span<const glm::vec4* const> textures) {
    const EnvironmentResult passedOn{glm::clamp(inputs.previous, 0.0F, 1.0F), true};
    if (!isAllowed(combine))
        return passedOn;
    const std::optional<glm::vec4> rgb = combined(combine.rgb, combine.rgbArguments, inputs, textures);
    if (!rgb)
        return passedOn;
    glm::vec4 color = *rgb * combine.rgbScale;
    // DOT3_RGBA gives alpha with the colour, and the scale of the colour; what stands for alpha is ignored.
    if (combine.rgb != CombineFunction::Dot3Rgba) {
        const std::optional<glm::vec4> alpha =
            combined(combine.alpha, combine.alphaArguments, inputs, textures);
        if (!alpha)
            return passedOn;
        color.a = alpha->a * combine.alphaScale;
    }
    return {glm::clamp(color, 0.0F, 1.0F), false};
}

} // namespace texplorer::reference

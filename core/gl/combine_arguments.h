#pragma once

// GL_COMBINE's state by argument, as it is used; in combine.h it is by parameter.

#include "texplorer/gl/combine.h"

#include <array>
#include <optional>

namespace texplorer {

/// The source and operand of an argument. Alpha's operands are two of the colour's, with the same numbers.
struct CombineArgument {
    CombineSource source;
    OperandRgb operand;
};
using CombineArguments = std::array<CombineArgument, 3>;

[[nodiscard]] constexpr CombineArguments rgbArguments(const Combine& combine) {
    return {{{combine.source0Rgb, combine.operand0Rgb},
             {combine.source1Rgb, combine.operand1Rgb},
             {combine.source2Rgb, combine.operand2Rgb}}};
}

[[nodiscard]] constexpr CombineArguments alphaArguments(const Combine& combine) {
    return {{{combine.source0Alpha, static_cast<OperandRgb>(combine.operand0Alpha)},
             {combine.source1Alpha, static_cast<OperandRgb>(combine.operand1Alpha)},
             {combine.source2Alpha, static_cast<OperandRgb>(combine.operand2Alpha)}}};
}

/// The unit that a crossbar source refers to; empty for other sources.
[[nodiscard]] constexpr std::optional<std::size_t> crossbarUnit(CombineSource source) {
    if (source < CombineSource::Texture0 || source > CombineSource::Texture3)
        return std::nullopt;
    return static_cast<std::size_t>(source) - static_cast<std::size_t>(CombineSource::Texture0);
}

} // namespace texplorer

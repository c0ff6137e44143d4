#pragma once

#include "texplorer/gl/internal_format.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace texplorer {

/// An internal format of OpenGL 3.3's core profile, which has formats of red, of two, three and four
/// components, and of depths. Texels are given as RGBA; the red of a luminance is used.
struct CoreFormat {
    std::string_view name;
    std::string_view swizzle{}; ///< of GL_TEXTURE_SWIZZLE_RGBA; empty: none
};

/// What stands for the formats of a base format that the core profile lacks.
struct CoreSubstitute {
    BaseFormat base;
    std::string_view swizzle;
    std::string_view bits8;
    std::string_view bits16;
    std::string_view float16;
    std::string_view float32;
    std::string_view srgb{};
    std::string_view compressed{};
    std::string_view compressedSrgb{};
};

inline constexpr std::array coreSubstitutes{
    CoreSubstitute{BaseFormat::Alpha, "GL_ZERO, GL_ZERO, GL_ZERO, GL_ALPHA", "GL_RGBA8", "GL_RGBA16",
                   "GL_RGBA16F", "GL_RGBA32F", "", "GL_COMPRESSED_RGBA"},
    CoreSubstitute{BaseFormat::Luminance, "GL_RED, GL_RED, GL_RED, GL_ONE", "GL_R8", "GL_R16", "GL_R16F",
                   "GL_R32F", "GL_SRGB8", "GL_COMPRESSED_RED", "GL_COMPRESSED_SRGB"},
    CoreSubstitute{BaseFormat::LuminanceAlpha, "GL_RED, GL_RED, GL_RED, GL_ALPHA", "GL_RGBA8", "GL_RGBA16",
                   "GL_RGBA16F", "GL_RGBA32F", "GL_SRGB8_ALPHA8", "GL_COMPRESSED_RGBA",
                   "GL_COMPRESSED_SRGB_ALPHA"},
    CoreSubstitute{BaseFormat::Intensity, "GL_RED, GL_RED, GL_RED, GL_RED", "GL_R8", "GL_R16", "GL_R16F",
                   "GL_R32F", "", "GL_COMPRESSED_RED"},
};

/// Formats that exist in both keep their name.
[[nodiscard]] constexpr CoreFormat coreFormatOf(InternalFormat format) {
    const FormatFacts& facts = factsOf(format);
    const auto* found = std::ranges::find(coreSubstitutes, facts.base, &CoreSubstitute::base);
    if (found == coreSubstitutes.end() || isDepth(format)) {
        std::string_view name = rowOf(facts.sized).name;
        if (isFloat(format)) // OpenGL 3.0 took them over
            name.remove_suffix(std::string_view("_ARB").size());
        return {name};
    }
    if (isFloat(format))
        return {mostBits(format) == 16 ? found->float16 : found->float32, found->swizzle};
    if (isGenericCompressed(format))
        return {isSrgb(format) ? found->compressedSrgb : found->compressed, found->swizzle};
    if (isSrgb(format))
        return {found->srgb, found->swizzle};
    return {std::ranges::max(facts.bits) > 8 ? found->bits16 : found->bits8, found->swizzle};
}

} // namespace texplorer

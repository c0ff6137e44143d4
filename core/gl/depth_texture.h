#pragma once

// How a depth texture is read: OpenGL 2.1, section 3.8.14.

#include "texplorer/gl/environment.h"
#include "texplorer/gl/sampling.h"

namespace texplorer {

enum class CompareMode : std::uint32_t { None = 0, RToTexture = 0x884E };

/// GL_DEPTH_TEXTURE_MODE: the base format for the environment.
enum class DepthMode : std::uint32_t {
    Luminance = static_cast<std::uint32_t>(BaseFormat::Luminance),
    Intensity = static_cast<std::uint32_t>(BaseFormat::Intensity),
    Alpha = static_cast<std::uint32_t>(BaseFormat::Alpha),
};

[[nodiscard]] constexpr BaseFormat baseFormat(DepthMode mode) {
    return static_cast<BaseFormat>(mode);
}

/// Section 3.8.1: glTexImage3D and cube map faces do not accept depth components.
[[nodiscard]] constexpr bool takesDepths(Target target) {
    return target == Target::Texture1D || target == Target::Texture2D;
}

inline constexpr std::array compareModeRows{
    row(CompareMode::None, "GL_NONE", "None", "A sample is the depth itself.", "1.1"),
    row(CompareMode::RToTexture, "GL_COMPARE_R_TO_TEXTURE", "Compare r",
        "A sample is 1 where r passes the comparison with the stored depth, else 0. A light's picture of "
        "depths casts shadows this way.",
        "1.4"),
};

inline constexpr std::array depthModeRows{
    row(DepthMode::Luminance, "GL_LUMINANCE", "Luminance",
        "The depth, or the result of comparing, is a "
        "grey.",
        "1.0"),
    row(DepthMode::Intensity, "GL_INTENSITY", "Intensity",
        "The depth, or the result of comparing, is all "
        "four components.",
        "1.1"),
    row(DepthMode::Alpha, "GL_ALPHA", "Alpha",
        "The depth, or the result of comparing, is alpha. An alpha "
        "test can cut out shadows.",
        "1.0"),
};

template<>
struct EnumTable<CompareMode> {
    static constexpr std::span<const EnumRow> rows = compareModeRows;
};
template<>
struct EnumTable<DepthMode> {
    static constexpr std::span<const EnumRow> rows = depthModeRows;
};

static_assert(compareModeRows.size() == 2 && depthModeRows.size() == 3);

} // namespace texplorer

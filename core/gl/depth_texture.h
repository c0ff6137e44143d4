#pragma once

// How a texture of depths is read: OpenGL 2.1, section 3.8.14.

#include "core/gl/environment.h"
#include "core/gl/sampling.h"

namespace texplorer {

enum class CompareMode : std::uint32_t { None = 0, RToTexture = 0x884E };

/// GL_DEPTH_TEXTURE_MODE: the base format that the environment sees.
enum class DepthMode : std::uint32_t {
    Luminance = static_cast<std::uint32_t>(BaseFormat::Luminance),
    Intensity = static_cast<std::uint32_t>(BaseFormat::Intensity),
    Alpha = static_cast<std::uint32_t>(BaseFormat::Alpha),
};

[[nodiscard]] constexpr BaseFormat baseFormat(DepthMode mode) {
    return static_cast<BaseFormat>(mode);
}

/// Section 3.8.1: glTexImage3D and the faces of a cube map have no depth components.
[[nodiscard]] constexpr bool takesDepths(Target target) {
    return target == Target::Texture1D || target == Target::Texture2D;
}

inline constexpr std::array compareModeRows{
    row(CompareMode::None, "GL_NONE", "None", "The depths themselves are what a sample gives.", "1.1"),
    row(CompareMode::RToTexture, "GL_COMPARE_R_TO_TEXTURE", "Compare r",
        "Each sample says whether r passes against the stored depth: 1 where it does, 0 where not. So a light's "
        "picture of depths casts shadows.",
        "1.4"),
};

inline constexpr std::array depthModeRows{
    row(DepthMode::Luminance, "GL_LUMINANCE", "Luminance", "A depth, or the result of comparing, is a grey.",
        "1.0"),
    row(DepthMode::Intensity, "GL_INTENSITY", "Intensity", "It is all four components.", "1.1"),
    row(DepthMode::Alpha, "GL_ALPHA", "Alpha", "It is alpha: an alpha test can cut shadows out.", "1.0"),
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

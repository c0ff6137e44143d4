#pragma once

// Tables 3.21 and 3.22 of the OpenGL 2.1 specification, worked out by hand for
//
//   fragment     Cf = (0.2, 0.4, 0.6)   Af = 0.8
//   texel        Ct = (0.6, 0.2, 0.8)   At = 0.4   Lt = It = its red, 0.6 (table 3.15)
//   environment  Cc = (0.4, 0.8, 0.2)   Ac = 0.6

#include "texplorer/gl/environment.h"

#include <glm/vec4.hpp>

#include <array>
#include <optional>
#include <ostream>

namespace texplorer::test {

struct EnvironmentCase {
    static constexpr glm::vec4 fragment{0.2F, 0.4F, 0.6F, 0.8F};
    static constexpr glm::vec4 texel{0.6F, 0.2F, 0.8F, 0.4F};
    static constexpr glm::vec4 environment{0.4F, 0.8F, 0.2F, 0.6F};

    const char* name;
    EnvMode mode;
    BaseFormat format;
    std::optional<glm::vec4> expected; ///< nothing: the specification leaves it undefined
};

inline void PrintTo(const EnvironmentCase& tried, std::ostream* out) {
    *out << tried.name;
}

inline constexpr std::array environmentCases = [] {
    using E = EnvMode;
    using F = BaseFormat;
    return std::array{
        // C = Cf or Ct, A = Af or At: whatever the texture has replaces the fragment's
        EnvironmentCase{"ReplaceAlpha", E::Replace, F::Alpha, {{0.2F, 0.4F, 0.6F, 0.4F}}},
        EnvironmentCase{"ReplaceLuminance", E::Replace, F::Luminance, {{0.6F, 0.6F, 0.6F, 0.8F}}},
        EnvironmentCase{"ReplaceLuminanceAlpha", E::Replace, F::LuminanceAlpha, {{0.6F, 0.6F, 0.6F, 0.4F}}},
        EnvironmentCase{"ReplaceIntensity", E::Replace, F::Intensity, {{0.6F, 0.6F, 0.6F, 0.6F}}},
        EnvironmentCase{"ReplaceRgb", E::Replace, F::Rgb, {{0.6F, 0.2F, 0.8F, 0.8F}}},
        EnvironmentCase{"ReplaceRgba", E::Replace, F::Rgba, {{0.6F, 0.2F, 0.8F, 0.4F}}},
        // C = Cf Ct, A = Af At
        EnvironmentCase{"ModulateAlpha", E::Modulate, F::Alpha, {{0.2F, 0.4F, 0.6F, 0.32F}}},
        EnvironmentCase{"ModulateLuminance", E::Modulate, F::Luminance, {{0.12F, 0.24F, 0.36F, 0.8F}}},
        EnvironmentCase{
            "ModulateLuminanceAlpha", E::Modulate, F::LuminanceAlpha, {{0.12F, 0.24F, 0.36F, 0.32F}}},
        EnvironmentCase{"ModulateIntensity", E::Modulate, F::Intensity, {{0.12F, 0.24F, 0.36F, 0.48F}}},
        EnvironmentCase{"ModulateRgb", E::Modulate, F::Rgb, {{0.12F, 0.08F, 0.48F, 0.8F}}},
        EnvironmentCase{"ModulateRgba", E::Modulate, F::Rgba, {{0.12F, 0.08F, 0.48F, 0.32F}}},
        // C = Cf (1 - At) + Ct At, A = Af; the other formats are undefined
        EnvironmentCase{"DecalAlpha", E::Decal, F::Alpha, std::nullopt},
        EnvironmentCase{"DecalLuminance", E::Decal, F::Luminance, std::nullopt},
        EnvironmentCase{"DecalLuminanceAlpha", E::Decal, F::LuminanceAlpha, std::nullopt},
        EnvironmentCase{"DecalIntensity", E::Decal, F::Intensity, std::nullopt},
        EnvironmentCase{"DecalRgb", E::Decal, F::Rgb, {{0.6F, 0.2F, 0.8F, 0.8F}}},
        EnvironmentCase{"DecalRgba", E::Decal, F::Rgba, {{0.36F, 0.32F, 0.68F, 0.8F}}},
        // C = Cf (1 - Ct) + Cc Ct, A = Af At; INTENSITY blends alpha too: Af (1 - It) + Ac It
        EnvironmentCase{"BlendAlpha", E::Blend, F::Alpha, {{0.2F, 0.4F, 0.6F, 0.32F}}},
        EnvironmentCase{"BlendLuminance", E::Blend, F::Luminance, {{0.32F, 0.64F, 0.36F, 0.8F}}},
        EnvironmentCase{"BlendLuminanceAlpha", E::Blend, F::LuminanceAlpha, {{0.32F, 0.64F, 0.36F, 0.32F}}},
        EnvironmentCase{"BlendIntensity", E::Blend, F::Intensity, {{0.32F, 0.64F, 0.36F, 0.68F}}},
        EnvironmentCase{"BlendRgb", E::Blend, F::Rgb, {{0.32F, 0.48F, 0.28F, 0.8F}}},
        EnvironmentCase{"BlendRgba", E::Blend, F::Rgba, {{0.32F, 0.48F, 0.28F, 0.32F}}},
        // C = Cf + Ct, A = Af At; INTENSITY adds alpha too; sums end at 1
        EnvironmentCase{"AddAlpha", E::Add, F::Alpha, {{0.2F, 0.4F, 0.6F, 0.32F}}},
        EnvironmentCase{"AddLuminance", E::Add, F::Luminance, {{0.8F, 1.0F, 1.0F, 0.8F}}},
        EnvironmentCase{"AddLuminanceAlpha", E::Add, F::LuminanceAlpha, {{0.8F, 1.0F, 1.0F, 0.32F}}},
        EnvironmentCase{"AddIntensity", E::Add, F::Intensity, {{0.8F, 1.0F, 1.0F, 1.0F}}},
        EnvironmentCase{"AddRgb", E::Add, F::Rgb, {{0.8F, 0.6F, 1.0F, 0.8F}}},
        EnvironmentCase{"AddRgba", E::Add, F::Rgba, {{0.8F, 0.6F, 1.0F, 0.32F}}}};
}();

static_assert(environmentCases.size() == 30);

} // namespace texplorer::test

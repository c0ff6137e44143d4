#pragma once

// Level of detail and the choice of levels: OpenGL 2.1, section 3.8.8.

#include "core/reference/sampling/sampled_texture.h"

#include <glm/vec3.hpp>

namespace texplorer::reference {

/// How s, t and r change from one pixel to the next, in x and in y.
struct Derivatives {
    glm::vec3 dx{0};
    glm::vec3 dy{0};
};

/// Which way a texture with a maximal anisotropy above 1 is filtered; the extension leaves it open.
enum class AnisotropyMethod : std::uint32_t { Probes, Ellipse };

inline constexpr std::array anisotropyMethodRows{
    row(AnisotropyMethod::Probes, "probes", "Probes",
        "As the text of EXT_texture_filter_anisotropic: up to max anisotropy samples in a line along the "
        "longer axis of what a pixel covers."),
    row(AnisotropyMethod::Ellipse, "ellipse", "Ellipse",
        "An elliptical weighted average of all texels that a pixel covers, as Mesa's softpipe and llvmpipe "
        "do it."),
};

/// How rho is approximated. OpenGL 2.1, section 3.8.8, allows any continuous function f of the derivatives
/// that grows with each of them, and with m_u = max{|du/dx|, |du/dy|}, m_v and m_w likewise is within
///     max{m_u, m_v, m_w} <= f <= m_u + m_v + m_w.
enum class RhoMethod : std::uint32_t { Ideal, Lower, Upper };

inline constexpr std::array rhoMethodRows{
    row(RhoMethod::Ideal, "ideal", "Ideal", "Equation 3.21: the longer side of what a pixel covers."),
    row(RhoMethod::Lower, "lower", "Lower end", "The largest derivative, as Mesa's softpipe takes it."),
    row(RhoMethod::Upper, "upper", "Upper end", "The sum of the largest derivatives of u, v and w."),
};

struct SampleOptions {
    float unitBias = 0; ///< GL_TEXTURE_LOD_BIAS of GL_TEXTURE_FILTER_CONTROL; the texture object has its own
    float shaderBias = 0; ///< a shader's own; 0 without one
    float maxBias = 16;   ///< GL_MAX_TEXTURE_LOD_BIAS, of the implementation; at least 2
    AnisotropyMethod anisotropy = AnisotropyMethod::Probes;
    RhoMethod rho = RhoMethod::Ideal; ///< of textures that aren't anisotropic
    bool seamlessCubeMap = false;     ///< GL_TEXTURE_CUBE_MAP_SEAMLESS
    /// c is 0 for all filters: OpenGL 2.1 wants 0.5 for some, OpenGL 4.1 allows either (section 3.9.12).
    bool zeroSwitchOver = false;
};

/// How lambda came about, step by step.
struct Lod {
    double lengthX = 0; ///< texels of the base level per pixel, in x; more than a float holds, possibly
    double lengthY = 0;
    int probes = 1;       ///< N of the anisotropic filter
    bool ellipse = false; ///< averaged over an ellipse instead
    RhoMethod method = RhoMethod::Ideal;
    double rho = 0;       ///< texels a pixel that count: the longer length, over N, or as `method` has it
    float base = 0;       ///< log2(rho)
    float bias = 0;       ///< the sum of all, clamped
    float biased = 0;     ///< base + bias
    float lambda = 0;     ///< clamped between GL_TEXTURE_MIN_LOD and GL_TEXTURE_MAX_LOD
    float switchOver = 0; ///< c: magnified where lambda is not above it
    bool magnified = true;
    bool undefined =
        false; ///< a derivative is NaN or infinite, or the clamp is empty: lambda was chosen here
};

/// Below equation 3.18: the biases of the texture object, the unit and the shader together, clamped to
/// GL_MAX_TEXTURE_LOD_BIAS. What is not a number counts as 0.
[[nodiscard]] float lodBias(const SamplerState& object, const SampleOptions& options);

/// rho of a texture that isn't anisotropic, whose base level has so many texels; a `method` other than Ideal
/// takes an end of what section 3.8.8 allows.
[[nodiscard]] double rhoBy(RhoMethod method, const Derivatives& derivatives, glm::ivec3 baseSize, int axes);

/// The level-of-detail parameter and whether the texture is magnified. Of a cube map the derivatives are
/// those on the face (cube.h).
[[nodiscard]] Lod levelOfDetail(const SampledTexture& texture, const Derivatives& derivatives,
                                const SampleOptions& options);

/// c: 0.5 where magnification is linear and minification takes the nearest texel of a mip level, so that
/// minification never looks sharper than magnification; else 0.
[[nodiscard]] constexpr float switchOverOf(MagFilter mag, MinFilter min) {
    return mag == MagFilter::Linear &&
                   (min == MinFilter::NearestMipmapNearest || min == MinFilter::NearestMipmapLinear)
               ? 0.5F
               : 0.0F;
}

[[nodiscard]] constexpr bool wantsMipmaps(MinFilter filter) {
    return filter != MinFilter::Nearest && filter != MinFilter::Linear;
}
/// Whether 2 x 2 texels of a level are blended.
[[nodiscard]] constexpr bool isLinear(MinFilter filter) {
    return filter == MinFilter::Linear || filter == MinFilter::LinearMipmapNearest ||
           filter == MinFilter::LinearMipmapLinear;
}
/// Whether two levels are blended.
[[nodiscard]] constexpr bool blendsLevels(MinFilter filter) {
    return filter == MinFilter::NearestMipmapLinear || filter == MinFilter::LinearMipmapLinear;
}

/// Which levels are read, and whether linearly.
struct LevelChoice {
    int first = 0;
    int second = 0;
    float share = 0; ///< of `second`
    bool linear = false;
};
[[nodiscard]] LevelChoice chooseLevels(const SampledTexture& texture, const Lod& lod);

/// q: the last level that minification uses, min(p, GL_TEXTURE_MAX_LEVEL), where level p has one texel.
[[nodiscard]] int lastMipLevel(const SampledTexture& texture);

} // namespace texplorer::reference

template<>
struct texplorer::EnumTable<texplorer::reference::AnisotropyMethod> {
    static constexpr std::span<const EnumRow> rows = texplorer::reference::anisotropyMethodRows;
};
static_assert(texplorer::reference::anisotropyMethodRows.size() == 2);
template<>
struct texplorer::EnumTable<texplorer::reference::RhoMethod> {
    static constexpr std::span<const EnumRow> rows = texplorer::reference::rhoMethodRows;
};
static_assert(texplorer::reference::rhoMethodRows.size() == 3);

#pragma once

// Level of detail and selection of levels: OpenGL 2.1, section 3.8.8.

#include "texplorer/reference/sampling/sampled_texture.h"

#include <glm/vec3.hpp>

#include <string_view>

namespace texplorer::reference {

/// The change of s, t and r from one pixel to the next, in x and in y.
struct Derivatives {
    glm::vec3 dx{0};
    glm::vec3 dy{0};
};

/// The method of filtering with a maximum anisotropy above 1; the extension leaves it open.
enum class AnisotropyMethod : std::uint32_t { Probes, Ellipse, Line };

inline constexpr std::array anisotropyMethodRows{
    row(AnisotropyMethod::Probes, "probes", "Probes",
        "As in the text of EXT_texture_filter_anisotropic: up to max anisotropy samples along the longer "
        "axis of a pixel's footprint."),
    row(AnisotropyMethod::Ellipse, "ellipse", "Ellipse",
        "An elliptical weighted average of all texels that a pixel covers, as in Mesa's softpipe, and in its "
        "llvmpipe before version 25."),
    // Translators: a filter that reads texels along a line
    row(AnisotropyMethod::Line, "line", "Line",
        "Up to max anisotropy samples of one level, evenly spaced along the longer axis of a pixel's "
        "footprint, as in Mesa's llvmpipe since version 25."),
};

/// The method of a driver, by its GL_RENDERER and GL_VERSION; Probes if it is unknown.
[[nodiscard]] AnisotropyMethod anisotropyMethodOf(std::string_view renderer, std::string_view version);

/// How rho is approximated. OpenGL 2.1, section 3.8.8, allows any continuous function f of the derivatives
/// that is monotonic in each of them and, with m_u = max{|du/dx|, |du/dy|}, m_v and m_w likewise, satisfies
///     max{m_u, m_v, m_w} <= f <= m_u + m_v + m_w.
enum class RhoMethod : std::uint32_t { Ideal, Lower, Upper };

inline constexpr std::array rhoMethodRows{
    row(RhoMethod::Ideal, "ideal", "Ideal", "Equation 3.21: the longer side of a pixel's footprint."),
    row(RhoMethod::Lower, "lower", "Lower end", "The largest derivative, as in Mesa's softpipe."),
    row(RhoMethod::Upper, "upper", "Upper end", "The sum of the largest derivatives of u, v and w."),
};

struct SampleOptions {
    float unitBias = 0; ///< GL_TEXTURE_LOD_BIAS of GL_TEXTURE_FILTER_CONTROL; the texture object has another
    float shaderBias = 0; ///< the bias of a shader; 0 without one
    float maxBias = 16;   ///< GL_MAX_TEXTURE_LOD_BIAS, of the implementation; at least 2
    AnisotropyMethod anisotropy = AnisotropyMethod::Probes;
    RhoMethod rho = RhoMethod::Ideal; ///< for textures that are not anisotropic
    bool seamlessCubeMap = false;     ///< GL_TEXTURE_CUBE_MAP_SEAMLESS
    /// Use c = 0 for all filters: OpenGL 2.1 requires 0.5 for some, OpenGL 4.1 allows both (section 3.9.12).
    bool zeroSwitchOver = false;
};

/// The computation of lambda, step by step.
struct Lod {
    double lengthX = 0; ///< texels of the base level per pixel, in x; may exceed a float's range
    double lengthY = 0;
    int probes = 1;       ///< N of the anisotropic filter
    bool alongX = false;  ///< the probes lie along the change from pixel to pixel in x, not in y
    bool ellipse = false; ///< averaged over an ellipse instead
    bool line = false;    ///< the probes read one level, linearly, whatever the filters are
    RhoMethod method = RhoMethod::Ideal;
    double rho = 0; ///< texels per pixel that are used: the longer length, over N, or as `method` defines it
    float base = 0; ///< log2(rho)
    float bias = 0; ///< the sum of the biases, clamped
    float biased = 0;     ///< base + bias
    float lambda = 0;     ///< clamped to GL_TEXTURE_MIN_LOD and GL_TEXTURE_MAX_LOD
    float switchOver = 0; ///< c: magnified if lambda <= c
    bool magnified = true;
    /// A derivative is NaN or infinite, or the range of the clamp is empty: lambda was chosen here.
    bool undefined = false;
};

/// Below equation 3.18: the sum of the biases of the texture object, the unit and the shader, clamped to
/// GL_MAX_TEXTURE_LOD_BIAS. NaN becomes 0.
[[nodiscard]] float lodBias(const SamplerState& object, const SampleOptions& options);

/// rho of a texture that is not anisotropic, for a base level of this size; a `method` other than Ideal gives
/// an end of the range that section 3.8.8 allows.
[[nodiscard]] double rhoBy(RhoMethod method, const Derivatives& derivatives, glm::ivec3 baseSize, int axes);

/// rho of the methods that average one level: texels per pixel along the longer and the shorter axis of the
/// footprint, and the maximum anisotropy.
[[nodiscard]] double rhoOfOneLevel(bool line, double longer, double shorter, double anisotropy);

/// Computes the level of detail and whether the texture is magnified. For a cube map, the derivatives are
/// those on the face (cube.h).
[[nodiscard]] Lod levelOfDetail(const SampledTexture& texture, const Derivatives& derivatives,
                                const SampleOptions& options);

/// c: 0.5 for linear magnification with minification by the nearest texel of a mip level, so that
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

/// The levels that are read, and the filter in them.
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
static_assert(texplorer::reference::anisotropyMethodRows.size() == 3);
template<>
struct texplorer::EnumTable<texplorer::reference::RhoMethod> {
    static constexpr std::span<const EnumRow> rows = texplorer::reference::rhoMethodRows;
};
static_assert(texplorer::reference::rhoMethodRows.size() == 3);

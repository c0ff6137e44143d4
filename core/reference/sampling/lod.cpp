#include "texplorer/reference/sampling/lod.h"

#include "texplorer/image/mipmaps.h"
#include "texplorer/reference/sampling/lanes.h"
#include "texplorer/reference/sampling/wrap.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace texplorer::reference {

namespace {

/// Equation 3.21's rho for one screen axis: sqrt((du/dx)^2 + (dv/dx)^2 + (dw/dx)^2). In floats, as the kernel
/// has it, unless their range is too small for the square: a double's is not.
double footprint(glm::vec3 derivative, glm::ivec3 baseSize, int axes) {
    glm::dvec3 texels(0);
    for (int axis = 0; axis < axes; ++axis)
        texels[axis] = double{derivative[axis]} * baseSize[axis];
    const glm::vec3 rounded(texels);
    const float square = glm::dot(rounded, rounded);
    return std::isnormal(square) ? double{std::sqrt(square)} : glm::length(texels);
}

/// log2(rho), in floats likewise.
float baseLambda(double rho) {
    const auto rounded = static_cast<float>(rho);
    return std::isnormal(rounded) ? logarithm2(rounded) : static_cast<float>(std::log2(rho));
}

/// EXT_texture_filter_anisotropic: N = min(ceil(Pmax / Pmin), maxAniso). Pmin may be 0.
int probeCount(double longer, double shorter, float limit) {
    const float ratio = longer > 0 ? std::ceil(static_cast<float>(longer / shorter)) : 1.0F;
    return std::max(1, static_cast<int>(std::min({ratio, limit, 1024.0F})));
}

/// Mesa's methods are for 2D textures with any filters; other targets use the probes.
bool averagesOneLevel(const SampledTexture& texture, const SampleOptions& options) {
    return options.anisotropy != AnisotropyMethod::Probes && texture.target == Target::Texture2D;
}

/// The probes of the line, one for each texel of the level along the longer axis (Mesa 25,
/// lp_bld_sample_soa.c).
void placeLine(Lod& lod, const SampledTexture& texture, const Derivatives& derivatives, float limit) {
    const Level* level = texture.level(chooseLevels(texture, lod).first);
    if (!level)
        return;
    const auto texels = [](glm::vec3 change, int size) {
        return std::max(std::abs(change.s), std::abs(change.t)) * static_cast<float>(size);
    };
    const float x = texels(derivatives.dx, level->width);
    const float y = texels(derivatives.dy, level->height);
    lod.alongX = x > y;
    lod.probes = static_cast<int>(std::clamp(std::ceil(std::max(x, y)), 1.0F, std::min(limit, 1024.0F)));
}

/// Mesa keeps the maximal anisotropy as a whole number. So the probes are counted, too.
float wholeAnisotropy(const SampledTexture& texture) {
    return std::floor(texture.maxAnisotropy);
}

} // namespace

AnisotropyMethod anisotropyMethodOf(std::string_view renderer, std::string_view version) {
    if (renderer.starts_with("softpipe"))
        return AnisotropyMethod::Ellipse;
    if (!renderer.starts_with("llvmpipe"))
        return AnisotropyMethod::Probes;
    constexpr std::string_view name = "Mesa ";
    const std::size_t place = version.find(name);
    int mesa = 0;
    if (place != std::string_view::npos)
        std::from_chars(version.data() + place + name.size(), version.data() + version.size(), mesa);
    return mesa < 25 ? AnisotropyMethod::Ellipse : AnisotropyMethod::Line;
}

float lodBias(const SamplerState& object, const SampleOptions& options) {
    const float sum = object.lodBias + options.unitBias + options.shaderBias;
    return std::isnan(sum) ? 0.0F : std::clamp(sum, -options.maxBias, options.maxBias);
}

double rhoBy(RhoMethod method, const Derivatives& derivatives, glm::ivec3 baseSize, int axes) {
    if (method == RhoMethod::Ideal)
        return std::max(footprint(derivatives.dx, baseSize, axes), footprint(derivatives.dy, baseSize, axes));
    glm::dvec3 most(0); // m_u, m_v and m_w
    for (int axis = 0; axis < axes; ++axis)
        most[axis] = std::max(std::abs(double{derivatives.dx[axis]} * baseSize[axis]),
                              std::abs(double{derivatives.dy[axis]} * baseSize[axis]));
    if (method == RhoMethod::Lower)
        return std::max({most.x, most.y, most.z});
    const glm::vec3 rounded(most); // in floats likewise
    const float sum = rounded.x + rounded.y + rounded.z;
    return std::isnormal(sum) ? double{sum} : most.x + most.y + most.z;
}

// Mesa 25 divides the square of the longer axis by the anisotropy, not by its square (lp_build_pmin).
double rhoOfOneLevel(bool line, double longer, double shorter, double anisotropy) {
    if (line)
        return longer > shorter * anisotropy ? longer / std::sqrt(anisotropy) : shorter;
    return std::max(shorter, longer / anisotropy);
}

Lod levelOfDetail(const SampledTexture& texture, const Derivatives& derivatives,
                  const SampleOptions& options) {
    Lod lod;
    lod.switchOver = options.zeroSwitchOver ? 0 : switchOverOf(texture.magFilter, texture.minFilter);
    const Level* base = texture.level(texture.baseLevel);
    if (!base)
        return lod;
    lod.lengthX = footprint(derivatives.dx, base->size(), axesOf(texture.target));
    lod.lengthY = footprint(derivatives.dy, base->size(), axesOf(texture.target));
    const double longer = std::max(lod.lengthX, lod.lengthY);
    const double shorter = std::min(lod.lengthX, lod.lengthY);
    lod.undefined = !std::isfinite(lod.lengthX) || !std::isfinite(lod.lengthY);
    // Without a derivative there is nothing to minify by: as if one texel covered one pixel.
    lod.rho = lod.undefined ? 1.0 : longer;
    const float anisotropy = wholeAnisotropy(texture);
    if (anisotropy > 1 && !lod.undefined && averagesOneLevel(texture, options)) {
        lod.line = options.anisotropy == AnisotropyMethod::Line;
        lod.ellipse = !lod.line && longer > shorter;
        lod.rho = rhoOfOneLevel(lod.line, longer, shorter, anisotropy);
    } else if (anisotropy > 1 && !lod.undefined) {
        lod.probes = probeCount(longer, shorter, anisotropy);
        lod.alongX = lod.lengthX > lod.lengthY;
        lod.rho = longer / lod.probes;
    } else if (options.rho != RhoMethod::Ideal && !lod.undefined) {
        lod.method = options.rho;
        lod.rho = rhoBy(lod.method, derivatives, base->size(), axesOf(texture.target));
    }
    lod.base = baseLambda(lod.rho); // minus infinity where nothing changes: magnified, after the clamp
    lod.bias = lodBias(texture, options);
    lod.biased = lod.base + lod.bias;
    // Equation 3.20; undefined where the limits contradict each other: the upper one wins here.
    lod.undefined = lod.undefined || texture.minLod > texture.maxLod;
    lod.lambda = std::min(std::max(lod.biased, texture.minLod), texture.maxLod);
    lod.magnified = !(lod.lambda > lod.switchOver);
    if (lod.line)
        placeLine(lod, texture, derivatives, anisotropy);
    return lod;
}

int lastMipLevel(const SampledTexture& texture) {
    const Level* base = texture.level(texture.baseLevel);
    if (!base)
        return texture.baseLevel;
    const int axes = axesOf(texture.target);
    const int steps = mipLevelCount(base->width, axes > 1 ? base->height : 1, axes > 2 ? base->depth : 1) - 1;
    return std::max(texture.baseLevel, std::min(texture.baseLevel + steps, texture.maxLevel));
}

LevelChoice chooseLevels(const SampledTexture& texture, const Lod& lod) {
    const int base = texture.baseLevel;
    if (lod.line) {
        const int steps = wantsMipmaps(texture.minFilter) ? lastMipLevel(texture) - base : 0;
        const int step =
            lod.lambda >= static_cast<float>(steps) ? steps : std::max(0, floorToInt(lod.lambda));
        return {base + step, base + step, 0, true};
    }
    if (lod.magnified) // section 3.8.9
        return {base, base, 0, texture.magFilter == MagFilter::Linear};
    const bool linear = isLinear(texture.minFilter);
    if (!wantsMipmaps(texture.minFilter))
        return {base, base, 0, linear};

    const int steps = lastMipLevel(texture) - base;
    const float lambda = lod.lambda;
    if (!blendsLevels(texture.minFilter) && !lod.ellipse) { // which takes the larger level, and one alone
        // Equation 3.25: half-way between two levels the lower one is taken. Its ceil(lambda + 1/2) - 1 is
        // ceil(lambda - 1/2), a difference that needs no rounding.
        int step = 0;
        if (lambda > 0.5F)
            step = lambda <= static_cast<float>(steps) + 0.5F ? -floorToInt(0.5F - lambda) : steps;
        return {base + step, base + step, 0, linear};
    }
    // Equations 3.26 and 3.27.
    if (lambda >= static_cast<float>(steps))
        return {base + steps, base + steps, 0, linear};
    const int step = floorToInt(lambda);
    return {base + step, base + step + 1, lambda - std::floor(lambda), linear};
}

} // namespace texplorer::reference

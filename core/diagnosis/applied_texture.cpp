#include "texplorer/diagnosis/applied_texture.h"

#include <algorithm>
#include <array>

namespace texplorer {

namespace {

using reference::SampledTexture;

// Mesa rounds it to a whole number, downwards.
bool isAnisotropic(const Texture& texture) {
    return texture.maxAnisotropy >= 2;
}

void withoutAnisotropy(Texture& texture) {
    texture.maxAnisotropy = 1;
}

// llvmpipe reads a second coordinate that a line doesn't have.
bool filtersLine(const Texture& texture, const SampledTexture& shape, const TextureUse* /*use*/) {
    return isAnisotropic(texture) && shape.target == Target::Texture1D;
}

// Its anisotropic filter averages the texels themselves.
bool comparesDepths(const Texture& texture, const SampledTexture& /*shape*/, const TextureUse* /*use*/) {
    return isAnisotropic(texture) && isDepth(texture.internalFormat) &&
           texture.compareMode == CompareMode::RToTexture;
}

// It visits so many in about a second, on one processor of 2020; a large picture may have what textures with
// mipmaps want for each of its pixels.
bool visitsWithoutEnd(const Texture& texture, const SampledTexture& shape, const TextureUse* use) {
    if (!use || !isAnisotropic(texture))
        return false;
    const double limit = 0x1p28 + 256.0 * use->width * use->height;
    return visitedTexels(shape, *use, limit) > limit;
}

// It takes as many samples as the coordinates pass texels: none, and divides by their number.
bool takesNoSample(const Texture& texture, const SampledTexture& shape, const TextureUse* use) {
    return use && isAnisotropic(texture) && axesOf(shape.target) == 2 && hasConstantCoords(shape, *use);
}

bool hasTwoFilters(const Texture& texture) {
    return reference::isLinear(texture.minFilter) != (texture.magFilter == MagFilter::Linear);
}

bool hasOneLevel(const SampledTexture& shape) {
    return reference::lastMipLevel(shape) == shape.baseLevel;
}

// Section 3.8.8 has the base level read then. llvmpipe computes lambda to choose the filter, and takes the
// level from it, too.
bool readsOtherLevels(const Texture& texture, const SampledTexture& shape, const TextureUse* /*use*/) {
    return isAnisotropic(texture) && hasTwoFilters(texture) && !reference::wantsMipmaps(texture.minFilter) &&
           !hasOneLevel(shape);
}

// Where lambda chooses between two filters and nothing else, and is biased, llvmpipe may have no level of
// detail and read it all the same. Whose bias it is, the shader's or the texture object's, doesn't count.
bool choosesFilterAlone(const Texture& texture, const SampledTexture& shape, const TextureUse* /*use*/) {
    return isAnisotropic(texture) && hasTwoFilters(texture) && hasOneLevel(shape);
}

// Its anisotropic filter averages over an ellipse, regardless of both.
void withOneFilter(Texture& texture) {
    texture.magFilter = reference::isLinear(texture.minFilter) ? MagFilter::Linear : MagFilter::Nearest;
}

constexpr auto ellipse = reference::AnisotropyMethod::Ellipse; // of Mesa before version 25
constexpr auto line = reference::AnisotropyMethod::Line;       // since then

// Of Mesa 22.3 and 25.0; tests/render/sampler_matrix.cpp says whether that is all.
constexpr std::array flaws{
    DriverFlaw{
        "llvmpipe", ellipse, filtersLine, withoutAnisotropy,
        N_("llvmpipe before Mesa 25 ends in a segmentation fault where it filters GL_TEXTURE_1D anisotropically; drawn "
           "without anisotropy")},
    DriverFlaw{
        "llvmpipe", ellipse, comparesDepths, withoutAnisotropy,
        N_("llvmpipe before Mesa 25 compares no depths where it filters them anisotropically; drawn without anisotropy")},
    DriverFlaw{
        "llvmpipe", ellipse, visitsWithoutEnd, withoutAnisotropy,
        N_("before Mesa 25, llvmpipe's anisotropic filter visits every texel that a pixel covers, which would take seconds "
           "to hours here, where coordinates run fast or q runs through 0; drawn without anisotropy")},
    DriverFlaw{
        "llvmpipe", line, takesNoSample, withoutAnisotropy,
        N_("llvmpipe since Mesa 25 draws black where it filters anisotropically and the coordinates do not "
           "change; drawn without anisotropy")},
    DriverFlaw{
        "llvmpipe", std::nullopt, readsOtherLevels, withOneFilter,
        N_("llvmpipe reads mipmap levels that GL_TEXTURE_MIN_FILTER doesn't ask for where it filters anisotropically and "
           "the two filters differ; drawn with one filter")},
    DriverFlaw{"llvmpipe", std::nullopt, choosesFilterAlone, withOneFilter, ""},
};

} // namespace

std::span<const DriverFlaw> driverFlaws() {
    return flaws;
}

AppliedTexture appliedTexture(const Texture& texture, SampledTexture shape, int lastLevel,
                              const DriverFacts& driver, const TextureUse* use) {
    AppliedTexture applied{texture, {}, {}};
    Texture& given = applied.texture;
    given.baseLevel = std::max(0, given.baseLevel); // GL refuses another, and keeps 0
    given.maxLevel = std::min(given.maxLevel, lastLevel);
    // Section 3.8.8: the base level alone is read then, and where it is doesn't matter.
    if (!reference::wantsMipmaps(given.minFilter))
        given.maxLevel = std::max(given.maxLevel, given.baseLevel);
    reference::setParameters(shape, given, lastLevel);
    applied.completeness = reference::checkCompleteness(shape);
    if (!applied.completeness.complete())
        return applied;
    const reference::AnisotropyMethod method = reference::anisotropyMethodOf(driver.renderer, driver.version);
    for (const DriverFlaw& flaw : flaws) {
        const bool isThere =
            driver.renderer.starts_with(flaw.driver) && (!flaw.method || *flaw.method == method);
        if (!isThere || !flaw.meets(given, shape, use))
            continue;
        flaw.avoid(given);
        if (!flaw.sentence.empty())
            applied.heldBack.push_back(flaw.sentence);
    }
    return applied;
}

} // namespace texplorer

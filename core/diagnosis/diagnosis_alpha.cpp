// What filters and mip levels do to alpha: fringes of invisible colours, and shapes that vanish.

#include "texplorer/diagnosis/diagnosis_rules.h"
#include "texplorer/image/alpha_coverage.h"
#include "texplorer/image/convert.h"
#include "texplorer/image/linear_light.h"
#include "texplorer/image/mipmaps.h"
#include "texplorer/reference/sampling/lod.h"
#include "texplorer/scene/params/param_text.h"
#include "texplorer/texture/texture_levels.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace texplorer::diagnosis {
namespace {

/// A scene is diagnosed after every edit: larger images are not looked at.
constexpr std::size_t maxTexels = std::size_t{1} << 20;

/// A picture whose alpha reaches the tests and the blending of a pass as it is.
struct AlphaUse {
    const Texture& texture;
    const TextureFacts& facts;
    const Pass& pass;
    std::string texturePath; ///< "textures[0]."
    std::string passPath;    ///< "passes[0]."
};

bool hasAlpha(const TextureFacts& facts, Target target) {
    const TargetFacts* as = facts.as(target);
    return as && as->completeness.complete() &&
           (as->format == BaseFormat::Rgba || as->format == BaseFormat::LuminanceAlpha);
}

template<class Visit> ///< visit(use)
void forEachUse(const Case& about, Visit visit) {
    forEachUnit(about.scene, [&](const Unit& unit, const std::string&, std::size_t p) {
        const TextureFacts* facts = about.textureOf(unit);
        const bool keeps = unit.envMode == EnvMode::Replace || unit.envMode == EnvMode::Modulate;
        if (!about.works(unit) || !keeps || !hasAlpha(*facts, unit.target))
            return;
        const auto index = static_cast<std::size_t>(unit.texture);
        const Texture& texture = about.scene.textures[index];
        if (texture.transparency == Transparency::File || texture.transparency == Transparency::Alpha)
            visit(AlphaUse{texture, *facts, about.scene.passes[p], elementOf<&Scene::textures>(index) + ".",
                           elementOf<&Scene::passes>(p) + "."});
    });
}

/// The base level after its preparation; empty where it is too large to be looked at.
Image preparedBase(const AlphaUse& use) {
    const Surface& base = use.facts.image->surfaces.front();
    const auto texels = static_cast<double>(widthOf(base)) * heightOf(base) * depthOf(base);
    Image last;
    if (texels <= static_cast<double>(maxTexels))
        eachPreparationStep(use.texture, use.facts.pictures, [&](const Image& image) { last = image; });
    return alphaComponent(last.format) < 0 ? Image() : last;
}

using Texel = std::array<std::uint8_t, 4>;

/// Whether a filter that mixes two texels would mix a colour into the visible one that is far from its own.
bool isFringe(const Texel& one, const Texel& other) {
    constexpr int visibly = 16;
    if ((one[3] == 0) == (other[3] == 0))
        return false;
    for (std::size_t i = 0; i < 3; ++i)
        if (std::abs(one[i] - other[i]) >= visibly)
            return true;
    return false;
}

bool hasFringe(const Image& image) {
    const auto at = [&](int x, int y) { return rgbaOf(image.format, image.at(x, y).data()); };
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            if ((x > 0 && isFringe(at(x - 1, y), at(x, y))) || (y > 0 && isFringe(at(x, y - 1), at(x, y))))
                return true;
    return false;
}

bool mixesTexels(const Texture& texture) {
    return texture.magFilter == MagFilter::Linear || reference::isLinear(texture.minFilter) ||
           reference::wantsMipmaps(texture.minFilter);
}

void fringe(const Case& about, Report& report) {
    forEachUse(about, [&](const AlphaUse& use) {
        if (!use.pass.blend || use.pass.blendSrc != BlendFactor::SrcAlpha ||
            use.pass.blendDst != BlendFactor::OneMinusSrcAlpha || !mixesTexels(use.texture) ||
            !hasFringe(preparedBase(use)))
            return;
        const edit::Set blend{use.passPath + keyOf<&Pass::blendSrc>(), nameOf(BlendFactor::One)};
        const bool premultiplied = std::ranges::find(use.texture.preparation, ImageOp::Premultiply,
                                                     &ImageStep::op) != use.texture.preparation.end();
        std::vector<Fix> fixes;
        if (premultiplied)
            fixes = {{Sentence("Blend with {0}", named(BlendFactor::One)), {blend}}};
        else if (use.texture.preparation.size() < maxImageSteps)
            fixes = {{N_("Spread colours"), {newStep(use.texturePath, ImageOp::Spread)}},
                     {N_("Premultiply"), {newStep(use.texturePath, ImageOp::Premultiply), blend}}};
        report.add(use.texturePath + keyOf<&Texture::preparation>(),
                   premultiplied
                       ? Sentence("the image is premultiplied: blended with {0}, edges are too dark",
                                  named(BlendFactor::SrcAlpha))
                       : N_("invisible texels have another colour than the visible ones next to them: "
                            "filters mix it into a fringe at the edges"),
                   std::move(fixes));
    });
}

int percent(double share) {
    return static_cast<int>(std::lround(100 * share));
}

/// The share of texels whose alpha is above a reference.
double shareAbove(const Image& image, float reference) {
    std::size_t above = 0;
    for (const std::byte alpha : image.pixels)
        above += static_cast<float>(std::to_integer<int>(alpha)) > 255 * reference ? 1U : 0U;
    return static_cast<double>(above) / static_cast<double>(image.pixels.size());
}

Image alphaOf(const Image& image) {
    Image alpha = Image::uninitialised(PixelFormat::Alpha8, image.width, image.height, image.depth);
    const auto step = static_cast<std::size_t>(bytesPerPixel(image.format));
    for (std::size_t i = 0; i < alpha.pixels.size(); ++i)
        alpha.pixels[i] = image.pixels[i * step + static_cast<std::size_t>(alphaComponent(image.format))];
    return alpha;
}

struct Loss {
    int level = 0;
    double share = 1;
};

/// The level of which the least passes. Of small levels few texels say little.
Loss worstOf(const MipChain& levels, float reference) {
    constexpr std::size_t fewTexels = 64;
    Loss worst;
    for (std::size_t i = 0; i < levels.size() && levels[i].pixels.size() >= fewTexels; ++i) {
        if (const double share = shareAbove(levels[i], reference); share < worst.share)
            worst = {static_cast<int>(i), share};
    }
    return worst;
}

void lostCoverage(const Case& about, Report& report) {
    forEachUse(about, [&](const AlphaUse& use) {
        const Texture& texture = use.texture;
        const Pass& pass = use.pass;
        const bool tests =
            pass.alphaTest && pass.alphaRef > 0 &&
            (pass.alphaFunc == CompareFunc::Greater || pass.alphaFunc == CompareFunc::GreaterEqual);
        const bool makesLevels = takesFilter(texture.mipmaps) || isMadeByDriver(texture.mipmaps) ||
                                 texture.mipmaps == MipPolicy::Glu;
        const bool keeps = takesFilter(texture.mipmaps) && texture.mipCoverage > 0;
        if (!tests || !makesLevels || keeps || !reference::wantsMipmaps(texture.minFilter))
            return;
        const Image base = preparedBase(use);
        if (base.empty())
            return;
        const double whole = shareAbove(alphaOf(base), pass.alphaRef);
        const Loss worst = worstOf(buildMipChain(alphaOf(base)), pass.alphaRef);
        if (worst.share >= whole * 2 / 3)
            return;
        const std::string coverage = use.texturePath + keyOf<&Texture::mipCoverage>();
        const std::string mipmaps = use.texturePath + keyOf<&Texture::mipmaps>();
        Fix fix{N_("Keep the coverage"), {{coverage, formatNumber(pass.alphaRef)}}};
        if (!takesFilter(texture.mipmaps))
            fix.assignments.push_back({mipmaps, nameOf(MipPolicy::Generated)});
        report.add(
            takesFilter(texture.mipmaps) ? coverage : mipmaps,
            Sentence("the alpha test passes {0} % of the image, but only {1} % of level {2}: what is far "
                     "away vanishes",
                     percent(whole), percent(worst.share), worst.level),
            std::move(fix));
    });
}

constexpr std::array alphaRuleRows{
    Rule{"fringe", Severity::Note, fringe},
    Rule{"lost-coverage", Severity::Note, lostCoverage},
};

} // namespace

edit::Set newStep(const std::string& texture, ImageOp op) {
    return {fmt::format("{}{}{}.{}", texture, keyOf<&Texture::preparation>(), newElement,
                        keyOf<&ImageStep::op>()),
            nameOf(op)};
}

std::span<const Rule> alphaRules() {
    return alphaRuleRows;
}

} // namespace texplorer::diagnosis

namespace texplorer {

bool looksAtTexels(const Scene& scene) {
    return std::ranges::any_of(scene.passes, [](const Pass& pass) { return pass.blend || pass.alphaTest; });
}

} // namespace texplorer

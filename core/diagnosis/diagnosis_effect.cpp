// Which settings of a texture object change nothing at present.

#include "texplorer/diagnosis/diagnosis_rules.h"
#include "texplorer/image/border.h"
#include "texplorer/image/power_of_two.h"
#include "texplorer/reference/sampling/lod.h"

#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace texplorer::diagnosis {
namespace {

/// A setting and why it changes nothing: an empty reason says that it does.
struct Setting {
    Key key;
    Sentence (*reason)(const Texture& texture, const TextureFacts& facts);
};

/// Section 3.8.7: GL_CLAMP leaves the image by half a texel, which a linear filter alone sees.
bool showsBorder(const Texture& texture, Wrap wrap) {
    return wrap == Wrap::ClampToBorder || (wrap == Wrap::Clamp && (texture.magFilter == MagFilter::Linear ||
                                                                   reference::isLinear(texture.minFilter)));
}

Sentence noFlip(const Texture& texture, const TextureFacts& facts) {
    if (texture.source == SourceKind::Pattern)
        return N_("a built-in pattern is upright");
    if (texture.source == SourceKind::LightDepth)
        return N_("the picture that the light sees is upright");
    if (texture.source == SourceKind::Picture)
        return N_("a picture of passes is upright");
    const auto isCube = [](const TargetFacts& each) { return each.target == Target::CubeMap; };
    if (std::ranges::any_of(facts.targets, isCube)) // whose rows begin at the top
        return facts.image && facts.image->fileTopFirst && std::ranges::all_of(facts.targets, isCube)
                   ? N_("the file begins with the top row, as the faces of a cube map do")
                   : "";
    if (facts.image && !facts.image->fileTopFirst)
        return N_("the file begins with the bottom row, as OpenGL does");
    return {};
}

Sentence noInternalFormat(const Texture&, const TextureFacts& facts) {
    const bool compressed = std::ranges::all_of(
        facts.targets, [](const TargetFacts& each) { return each.plan.blocks.has_value(); });
    return compressed ? N_("a compressed texture has a format of its own; one of depths is not compressed")
                      : "";
}

Sentence noScaling(const Texture&, const TextureFacts& facts) {
    if (!facts.image)
        return {};
    const Surface& base = facts.image->surfaces.front();
    return arePowersOfTwo(widthOf(base), heightOf(base), depthOf(base))
               ? N_("the image's size is a power of two")
               : "";
}

Sentence noWrapS(const Texture&, const TextureFacts& facts) {
    return facts.seamless
               ? N_("a seamless cube map is filtered across the edges of its faces, whatever the wrap modes "
                    "are")
               : "";
}

Sentence noWrapT(const Texture& texture, const TextureFacts& facts) {
    if (facts.seamless)
        return noWrapS(texture, facts);
    const bool line = std::ranges::all_of(
        facts.targets, [](const TargetFacts& each) { return each.target == Target::Texture1D; });
    return line ? N_("a 1D texture has only s") : "";
}

Sentence noWrapR(const Texture&, const TextureFacts& facts) {
    return facts.hasTarget(Target::Texture3D) ? ""
                                              : Sentence("only a 3D texture has r; the unit's target is {0}",
                                                         named(facts.targets.front().target));
}

Sentence noBorderColor(const Texture& texture, const TextureFacts& facts) {
    if (facts.seamless)
        return N_("a seamless cube map shows no border");
    const bool shown = showsBorder(texture, texture.wrapS) ||
                       (showsBorder(texture, texture.wrapT) && noWrapT(texture, facts).empty()) ||
                       (showsBorder(texture, texture.wrapR) && facts.hasTarget(Target::Texture3D));
    return shown ? ""
                 : Sentence("no wrap mode shows the border; {0} does, and {1} under a linear filter",
                            named(Wrap::ClampToBorder), named(Wrap::Clamp));
}

/// Where the border is cut off the image, the image is another one.
Sentence noBorder(const Texture& texture, const TextureFacts& facts) {
    const bool cuts = facts.image && std::ranges::any_of(facts.targets, [&](const TargetFacts& each) {
                          const Surface& base = facts.image->surfaces.front();
                          const int axes = axesOf(each.target);
                          return texture.mipmaps != MipPolicy::FromFile &&
                                 hasBorderExtents(widthOf(base), heightOf(base), depthOf(base), axes);
                      });
    return cuts || texture.border > 1 ? "" : noBorderColor(texture, facts);
}

Sentence noMipmaps(const Texture& texture, const TextureFacts&) {
    return reference::wantsMipmaps(texture.minFilter)
               ? ""
               : Sentence("{0} reads no mipmaps", named(texture.minFilter));
}

/// Without mipmaps λ decides only which of the two filters is taken.
Sentence noLod(const Texture& texture, const TextureFacts&) {
    const bool same =
        static_cast<std::uint32_t>(texture.minFilter) == static_cast<std::uint32_t>(texture.magFilter);
    return same ? Sentence("{0} reads no mipmaps, and both filters are the same", named(texture.minFilter))
                : "";
}

/// glCompressedTexImage takes blocks as they are, and glCopyTexImage reads no memory.
Sentence noUpload(const Texture& texture, const TextureFacts& facts) {
    if (texture.source == SourceKind::LightDepth)
        return N_("the driver copies the picture that the light sees");
    if (texture.source == SourceKind::Picture)
        return N_("the driver draws or copies the picture");
    const bool isRead = std::ranges::any_of(
        facts.targets, [](const TargetFacts& each) { return each.plan.upload.has_value(); });
    return texture.upload.custom && facts.image && !isRead
               ? N_("glCompressedTexImage uploads blocks, which have no format, type or rows")
               : "";
}

Sentence noFallback(const Texture& texture, const TextureFacts& /*facts*/) {
    return texture.source == SourceKind::LightDepth ? N_("the driver copies the picture that the light sees")
                                                    : "";
}

bool isDepthTexture(const Texture& texture) {
    return isDepth(texture.internalFormat);
}

Sentence noCompression(const Texture& texture, const TextureFacts&) {
    return isDepthTexture(texture) ? N_("OpenGL has no compressed depth textures") : "";
}

Sentence noTransparency(const Texture& texture, const TextureFacts&) {
    return isDepthTexture(texture) ? N_("a depth texture has no alpha of its own") : "";
}

Sentence noComparing(const Texture& texture, const TextureFacts&) {
    return isDepthTexture(texture) ? "" : Sentence("{0} holds no depths", named(texture.internalFormat));
}

Sentence noCompareFunc(const Texture& texture, const TextureFacts& facts) {
    const bool compares = texture.compareMode == CompareMode::RToTexture;
    return compares ? noComparing(texture, facts)
                    : Sentence("nothing is compared: {0}", named(texture.compareMode));
}

constexpr std::array settings{
    Setting{keyOf<&Texture::compression>, noCompression},
    Setting{keyOf<&Texture::transparency>, noTransparency},
    Setting{keyOf<&Texture::compareMode>, noComparing},
    Setting{keyOf<&Texture::compareFunc>, noCompareFunc},
    Setting{keyOf<&Texture::depthMode>, noComparing},
    Setting{keyOf<&Texture::flip>, noFlip},
    Setting{keyOf<&Texture::upload>, noUpload},
    Setting{keyOf<&Texture::internalFormat>, noInternalFormat},
    Setting{keyOf<&Texture::npot>, noScaling},
    Setting{keyOf<&Texture::oversize>, noFallback},
    Setting{keyOf<&Texture::wrapT>, noWrapT},
    Setting{keyOf<&Texture::wrapS>, noWrapS},
    Setting{keyOf<&Texture::wrapR>, noWrapR},
    Setting{keyOf<&Texture::borderColor>, noBorderColor},
    Setting{keyOf<&Texture::border>, noBorder},
    Setting{keyOf<&Texture::mipFilter>, noMipmaps},
    Setting{keyOf<&Texture::mipGamma>, noMipmaps},
    Setting{keyOf<&Texture::mipCoverage>, noMipmaps},
    Setting{keyOf<&Texture::maxLevel>, noMipmaps},
    Setting{keyOf<&Texture::minLod>, noLod},
    Setting{keyOf<&Texture::maxLod>, noLod},
    Setting{keyOf<&Texture::lodBias>, noLod},
};

void noEffect(const Case& about, Report& report) {
    for (std::size_t i = 0; i < about.textures.size(); ++i) {
        for (const Setting& setting : settings) {
            Sentence reason = setting.reason(about.scene.textures[i], about.textures[i]);
            if (!reason.empty())
                report.add(fmt::format("{}.{}", elementOf<&Scene::textures>(i), setting.key()),
                           std::move(reason));
        }
    }
}

/// A border of texels stands where the border colour would (below equation 3.23).
void ownBorder(const Case& about, Report& report) {
    for (std::size_t i = 0; i < about.textures.size(); ++i) {
        if (about.scene.textures[i].border != 0 && about.driver.textureBorders)
            report.add(fmt::format("{}.{}", elementOf<&Scene::textures>(i), keyOf<&Texture::borderColor>()),
                       N_("the texture has a border of texels"));
    }
}

/// A pass that would show a texture, were it drawn.
std::optional<std::size_t> passOffThatShows(const Scene& scene, std::size_t texture) {
    for (std::size_t p = 0; p < scene.passes.size(); ++p) {
        const auto shows = [&](const Unit& unit) {
            return unit.enabled && std::cmp_equal(unit.texture, texture);
        };
        if (!scene.passes[p].enabled && std::ranges::any_of(scene.passes[p].units, shows))
            return p;
    }
    return std::nullopt;
}

void notShown(const Case& about, Report& report) {
    for (std::size_t i = 0; i < about.textures.size(); ++i) {
        if (about.textures[i].shown)
            continue;
        const std::string path = elementOf<&Scene::textures>(i);
        if (const std::optional<std::size_t> pass = passOffThatShows(about.scene, i)) {
            const std::string enabled =
                fmt::format("{}.{}", elementOf<&Scene::passes>(*pass), keyOf<&Pass::enabled>());
            report.add(path, N_("the pass that shows this texture is not drawn"),
                       Fix{N_("Draw it"), {{enabled, "true"}}});
            continue;
        }
        std::vector<Fix> fixes;
        forEachUnit(about.scene, [&](const Unit& unit, const std::string& owner, std::size_t) {
            if (fixes.empty() && !unit.enabled && unit.texture == static_cast<int>(i))
                fixes = {{N_("Switch the unit on"), {{owner + keyOf<&Unit::enabled>(), "true"}}}};
        });
        report.add(path, N_("no enabled unit shows this texture"), std::move(fixes));
    }
}

/// Levels that are given where others are taken.
void levelsUnread(const Case& about, Report& report) {
    for (std::size_t i = 0; i < about.textures.size(); ++i) {
        const Texture& texture = about.scene.textures[i];
        if (texture.levels.empty() || texture.mipmaps == MipPolicy::Given)
            continue;
        const std::string path = elementOf<&Scene::textures>(i) + ".";
        const std::string given = nameOf(MipPolicy::Given);
        report.add(path + keyOf<&Texture::levels>(),
                   Sentence("these levels are not read with the mipmaps \"{0}\"", named(texture.mipmaps)),
                   Fix{N_("Read them"), {{path + keyOf<&Texture::mipmaps>(), given}}});
    }
}

/// What the light sees stays as it is in a depth texture.
void depthsUnprepared(const Case& about, Report& report) {
    for (std::size_t i = 0; i < about.textures.size(); ++i) {
        const Texture& texture = about.scene.textures[i];
        if (texture.source == SourceKind::LightDepth && isDepthTexture(texture) &&
            !texture.preparation.empty())
            report.add(fmt::format("{}.{}", elementOf<&Scene::textures>(i), keyOf<&Texture::preparation>()),
                       N_("depths from the light are not changed before they are compared"));
    }
}

bool makesAlpha(const ImageStep& step) {
    return step.op == ImageOp::AlphaFrom || step.op == ImageOp::LuminanceToAlpha ||
           (step.op == ImageOp::Swizzle && step.alpha != ComponentSource::Alpha);
}

/// Whether colours depend on the alpha before the step.
bool colorsFromAlpha(const ImageStep& step) {
    constexpr ComponentSource alpha = ComponentSource::Alpha;
    return step.op == ImageOp::Premultiply || step.op == ImageOp::Spread ||
           (step.op == ImageOp::Swizzle && (step.red == alpha || step.green == alpha || step.blue == alpha));
}

/// Why an alpha that a step makes is lost; empty: it isn't.
Sentence lostAlpha(const Texture& texture, const TextureFacts& facts, std::size_t step) {
    const auto later = texture.preparation.begin() + static_cast<std::ptrdiff_t>(step) + 1;
    for (auto each = later; each != texture.preparation.end(); ++each) {
        if (colorsFromAlpha(*each))
            return {};
        if (makesAlpha(*each))
            return N_("a later step replaces alpha");
    }
    if (texture.transparency != Transparency::File && texture.transparency != Transparency::Alpha)
        return Sentence("the transparency \"{0}\" replaces alpha", named(texture.transparency));
    const auto isWithout = [](const TargetFacts& each) {
        return !each.plan.blocks && (each.format == BaseFormat::Rgb || each.format == BaseFormat::Luminance);
    };
    if (std::ranges::all_of(facts.targets, isWithout))
        return Sentence("{0} keeps no alpha", named(texture.internalFormat));
    return {};
}

void alphaLost(const Case& about, Report& report) {
    for (std::size_t i = 0; i < about.textures.size(); ++i) {
        const Texture& texture = about.scene.textures[i];
        for (std::size_t step = 0; step < texture.preparation.size(); ++step) {
            if (!makesAlpha(texture.preparation[step]))
                continue;
            Sentence reason = lostAlpha(texture, about.textures[i], step);
            if (!reason.empty())
                report.add(fmt::format("{}.{}", elementOf<&Scene::textures>(i),
                                       elementOf<&Texture::preparation>(step)),
                           std::move(reason));
        }
    }
}

/// What belongs to another choice than the one that is made.
void unused(const Case& about, Report& report) {
    for (std::size_t i = 0; i < about.textures.size(); ++i) {
        const Texture& texture = about.scene.textures[i];
        const std::string path = elementOf<&Scene::textures>(i) + ".";
        const auto unless = [&](bool used, const std::string& key, const Sentence& chosen) {
            if (!used)
                report.add(path + key, Sentence("it is not used with \"{0}\"", chosen));
        };
        unless(texture.source == SourceKind::Pattern, keyOf<&Texture::pattern>(), named(texture.source));
        unless(texture.source == SourceKind::File, keyOf<&Texture::file>(), named(texture.source));
        unless(texture.source == SourceKind::LightDepth, keyOf<&Texture::depthSize>(), named(texture.source));
        for (const Key& key : {keyOf<&Texture::picture>, keyOf<&Texture::pictureSize>,
                               keyOf<&Texture::frames>, keyOf<&Texture::pictureCall>})
            unless(texture.source == SourceKind::Picture, key(), named(texture.source));
        unless(texture.transparency == Transparency::Stencil, keyOf<&Texture::stencilColor>(),
               named(texture.transparency));
        const bool cached = texture.compression == Compression::Cached;
        unless(cached || texture.compression == Compression::Driver, keyOf<&Texture::compressedFormat>(),
               named(texture.compression));
        unless(cached, keyOf<&Texture::compressionQuality>(), named(texture.compression));
        unless(takesFilter(texture.mipmaps), keyOf<&Texture::mipFilter>(), named(texture.mipmaps));
        unless(takesFilter(texture.mipmaps), keyOf<&Texture::mipGamma>(), named(texture.mipmaps));
        unless(takesFilter(texture.mipmaps), keyOf<&Texture::mipCoverage>(), named(texture.mipmaps));
        unless(texture.mipmaps != MipPolicy::FromFile && texture.mipmaps != MipPolicy::Glu,
               keyOf<&Texture::npot>(), named(texture.mipmaps));
        const std::string upload = keyOf<&Texture::upload>() + ".";
        for (const ParamRow& row : uploadTable().params) {
            if (!texture.upload.custom && row.member != memberId<&Upload::custom>)
                report.add(path + upload + std::string(row.key), N_("the custom upload is off"));
        }
        for (const Key& key :
             {keyOf<&Upload::memoryFormat>, keyOf<&Upload::memoryType>, keyOf<&Upload::memoryAlignment>})
            unless(!texture.upload.custom || texture.upload.memory == MemoryRows::Layout, upload + key(),
                   named(texture.upload.memory));
        for (std::size_t k = 0; k < texture.levels.size(); ++k) {
            const GivenLevel& level = texture.levels[k];
            const std::string owner = elementOf<&Texture::levels>(k) + ".";
            const bool isFile = level.source == SourceKind::File;
            unless(!isFile, owner + keyOf<&GivenLevel::pattern>(), named(level.source));
            unless(isFile, owner + keyOf<&GivenLevel::file>(), named(level.source));
        }
        for (std::size_t k = 0; k < texture.subimages.size(); ++k) {
            const Subimage& subimage = texture.subimages[k];
            const std::string owner = elementOf<&Texture::subimages>(k) + ".";
            const bool isFile = subimage.source == SourceKind::File;
            for (const Key& key :
                 {keyOf<&Subimage::pattern>, keyOf<&Subimage::width>, keyOf<&Subimage::height>})
                unless(!isFile, owner + key(), named(subimage.source));
            unless(isFile, owner + keyOf<&Subimage::file>(), named(subimage.source));
        }
        for (std::size_t k = 0; k < texture.preparation.size(); ++k) {
            const ImageStep& step = texture.preparation[k];
            const std::string owner = elementOf<&Texture::preparation>(k) + ".";
            const bool asks = readsOther(step);
            const bool resizes = step.op == ImageOp::Resize;
            const bool isFile = step.source == SourceKind::File;
            unless(step.op == ImageOp::Scale, owner + keyOf<&ImageStep::factor>(), named(step.op));
            unless(step.op == ImageOp::Scale, owner + keyOf<&ImageStep::bias>(), named(step.op));
            unless(step.op == ImageOp::Sharpen || step.op == ImageOp::Normals,
                   owner + keyOf<&ImageStep::amount>(), named(step.op));
            for (const Key& key : {keyOf<&ImageStep::red>, keyOf<&ImageStep::green>, keyOf<&ImageStep::blue>,
                                   keyOf<&ImageStep::alpha>})
                unless(step.op == ImageOp::Swizzle, owner + key(), named(step.op));
            for (const Key& key :
                 {keyOf<&ImageStep::share>, keyOf<&ImageStep::width>, keyOf<&ImageStep::height>})
                unless(resizes, owner + key(), named(step.op));
            unless(asks, owner + keyOf<&ImageStep::source>(), named(step.op));
            unless(asks && !isFile, owner + keyOf<&ImageStep::pattern>(),
                   asks ? named(step.source) : named(step.op));
            unless(asks && isFile, owner + keyOf<&ImageStep::file>(),
                   asks ? named(step.source) : named(step.op));
        }
    }
}

constexpr std::array effectRuleRows{
    Rule{"texture-setting", Severity::Hint, noEffect},
    Rule{"own-border", Severity::Hint, ownBorder},
    Rule{"texture-not-shown", Severity::Hint, notShown},
    Rule{"levels-not-read", Severity::Hint, levelsUnread},
    Rule{"depths-not-prepared", Severity::Hint, depthsUnprepared},
    Rule{"lost-alpha", Severity::Hint, alphaLost},
    Rule{"other-texture-choice", Severity::Unused, unused},
};

} // namespace

std::span<const Rule> textureEffectRules() {
    return effectRuleRows;
}

} // namespace texplorer::diagnosis

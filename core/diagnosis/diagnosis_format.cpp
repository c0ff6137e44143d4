// What an internal format does to an image's colours that surprises.

#include "texplorer/diagnosis/diagnosis_rules.h"
#include "texplorer/image/convert.h"
#include "texplorer/reference/sampling/lod.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>

namespace texplorer::diagnosis {
namespace {

template<class Visit> ///< visit(texture, its facts, "textures[0]."), of those that keep their internal format
void forEachShown(const Case& about, Visit visit) {
    for (std::size_t i = 0; i < about.textures.size(); ++i) {
        const TextureFacts& facts = about.textures[i];
        const bool compressed = std::ranges::all_of(
            facts.targets, [](const TargetFacts& each) { return each.plan.blocks.has_value(); });
        if (facts.image && facts.shown && !compressed)
            visit(about.scene.textures[i], facts, elementOf<&Scene::textures>(i) + ".");
    }
}

/// The format of eight bits without a curve that has the same components.
Fix plainFormat(const std::string& path, InternalFormat format) {
    const InternalFormat plain = internalFormat(baseFormat(format));
    return {Sentence("Make it {0}", named(plain)),
            {{path + keyOf<&Texture::internalFormat>(), nameOf(plain)}}};
}

/// How many of its places along each axis an image is looked at.
constexpr int lookedAt = 96;

/// Whether most neighbours differ, and by less than half of what a stored number stands for: where such
/// colours are rounded, several texels in a row have the same.
bool changesSlowly(const Image& image, InternalFormat format) {
    const auto& bits = factsOf(format).bits;
    int slow = 0;
    int all = 0;
    const auto compare = [&](const std::array<std::uint8_t, 4>& a, const std::array<std::uint8_t, 4>& b) {
        bool differs = false;
        for (std::size_t i = 0; i < bits.size(); ++i) {
            const int change = std::abs(a[i] - b[i]);
            if (bits[i] > 0 && 2 * change * ((1 << bits[i]) - 1) >= 255)
                return;
            differs = differs || (bits[i] > 0 && change > 0);
        }
        slow += differs ? 1 : 0;
    };
    const int stepX = std::max(1, image.width / lookedAt);
    const int stepY = std::max(1, image.height / lookedAt);
    for (int y = 0; y + 1 < image.height; y += stepY) {
        for (int x = 0; x + 1 < image.width; x += stepX) {
            const auto here = rgbaOf(image.format, image.at(x, y).data());
            compare(here, rgbaOf(image.format, image.at(x + 1, y + 1).data()));
            ++all;
        }
    }
    return 2 * slow > all;
}

/// Whether a texture may keep texels outside 0 … 1.
bool exceedsOne(const Texture& texture) {
    return isFloat(texture.internalFormat) && texture.upload.custom;
}

/// OpenGL 2.1, section 3.8.1.
void refused(const Case& about, Report& report) {
    forEachShown(about, [&](const Texture& texture, const TextureFacts& facts, const std::string& path) {
        if (isRefused(texture.internalFormat))
            report.add(path + keyOf<&Texture::internalFormat>(),
                       Sentence("{0}: the texture has no image; drawn as if the unit were off",
                                facts.targets.front().plan.refusal),
                       plainFormat(path, texture.internalFormat));
    });
}

void driversChoice(const Case& about, Report& report) {
    forEachShown(about, [&](const Texture& texture, const TextureFacts&, const std::string& path) {
        if (isGenericCompressed(texture.internalFormat))
            report.add(
                path + keyOf<&Texture::internalFormat>(),
                Sentence("the driver chooses what {0} is stored as: the picture may differ from driver "
                         "to driver",
                         named(texture.internalFormat)),
                plainFormat(path, texture.internalFormat));
    });
}

void banding(const Case& about, Report& report) {
    forEachShown(about, [&](const Texture& texture, const TextureFacts& facts, const std::string& path) {
        const Image* base =
            hasPixels(*facts.image) ? std::get_if<Image>(&facts.image->surfaces.front()) : nullptr;
        if (!base || !hasFewBits(texture.internalFormat) || !changesSlowly(*base, texture.internalFormat))
            return;
        const auto& bits = factsOf(texture.internalFormat).bits;
        const int most = *std::ranges::max_element(bits);
        report.add(path + keyOf<&Texture::internalFormat>(),
                   Sentence("colours change slowly in this image, and {0} has at most {1} steps for a "
                            "component: bands show",
                            named(texture.internalFormat), 1 << most),
                   plainFormat(path, texture.internalFormat));
    });
}

/// EXT_texture_sRGB decodes; what encodes again, GL_FRAMEBUFFER_SRGB, is no part of OpenGL 2.1.
void decodedOnly(const Case& about, Report& report) {
    forEachShown(about, [&](const Texture& texture, const TextureFacts&, const std::string& path) {
        if (isSrgb(texture.internalFormat))
            report.add(path + keyOf<&Texture::internalFormat>(),
                       Sentence("{0} converts the image's colours to amounts of light, and nothing converts "
                                "them back to sRGB: the picture is darker than the image",
                                named(texture.internalFormat)),
                       plainFormat(path, texture.internalFormat));
    });
}

void averagedAsStored(const Case& about, Report& report) {
    forEachShown(about, [&](const Texture& texture, const TextureFacts&, const std::string& path) {
        const bool isGlu = texture.mipmaps == MipPolicy::Glu;
        const bool asStored = isGlu || (takesFilter(texture.mipmaps) && !texture.mipGamma);
        if (!isSrgb(texture.internalFormat) || !asStored || !reference::wantsMipmaps(texture.minFilter))
            return;
        Fix fix{N_("Average light"), {{path + keyOf<&Texture::mipGamma>(), "true"}}};
        if (isGlu)
            fix.assignments.push_back({path + keyOf<&Texture::mipmaps>(), nameOf(MipPolicy::Generated)});
        report.add(path + (isGlu ? keyOf<&Texture::mipmaps>() : keyOf<&Texture::mipGamma>()),
                   Sentence("the levels are averages of stored numbers, not of the amounts of light that "
                            "{0} converts them to: seen from afar the texture is too dark",
                            named(texture.internalFormat)),
                   std::move(fix));
    });
}

/// Section 3.8.13 limits what a unit gives.
void passedOn(const Case& about, Report& report) {
    for (std::size_t p = 0; p < about.scene.passes.size(); ++p) {
        const Pass& pass = about.scene.passes[p];
        bool follows = pass.fog.enabled;
        for (std::size_t u = pass.units.size(); pass.enabled && u-- > 0;) {
            const Unit& unit = pass.units[u];
            if (!about.works(unit))
                continue;
            const Texture& texture = about.scene.textures[static_cast<std::size_t>(unit.texture)];
            if (follows && unit.envMode == EnvMode::Replace && exceedsOne(texture) &&
                about.driver.floatTextures)
                report.add(fmt::format("{}.{}.{}", elementOf<&Scene::passes>(p), elementOf<&Pass::units>(u),
                                       keyOf<&Unit::envMode>()),
                           Sentence("what {0} gives is limited to 0 … 1; Mesa passes a texel of {1} on as it "
                                    "is, and draws another colour after the next step",
                                    named(unit.envMode), named(texture.internalFormat)));
            follows = true;
        }
    }
}

constexpr std::array formatRuleRows{
    Rule{"format-refused", Severity::Error, refused, true},
    Rule{"srgb-not-encoded", Severity::Note, decodedOnly}, // the cause first
    Rule{"srgb-levels", Severity::Note, averagedAsStored},
    Rule{"drivers-choice", Severity::Note, driversChoice},
    Rule{"banding", Severity::Note, banding},
    Rule{"float-passed-on", Severity::Note, passedOn},
};

} // namespace

std::span<const Rule> formatRules() {
    return formatRuleRows;
}

} // namespace texplorer::diagnosis

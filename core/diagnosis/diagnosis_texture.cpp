// What is wrong with textures: not there, incomplete, undefined, or beyond the driver.

#include "texplorer/diagnosis/applied_texture.h"
#include "texplorer/diagnosis/diagnosis_rules.h"
#include "texplorer/reference/sampling/lod.h"
#include "texplorer/scene/animation.h"
#include "texplorer/scene/params/param_text.h"
#include "texplorer/scene/params/scene_at.h"

#include <fmt/core.h>

#include <algorithm>

namespace texplorer::diagnosis {
namespace {

void missingFile(const Case& about, Report& report) {
    forEachTexture(about, [&](const Texture& texture, const TextureFacts& facts, const std::string& path) {
        if (facts.image)
            return;
        report.add(path + keyOf<&Texture::file>(),
                   texture.file.empty() ? N_("the texture needs an image file, but names none")
                                        : Sentence("{0} can't be found or read", ProperName{texture.file}));
    });
}

/// The same of levels that are given one by one, of steps of the preparation and of subimages.
void missingPart(const Case& about, Report& report) {
    forEachTexture(about, [&](const Texture& texture, const TextureFacts& facts, const std::string& path) {
        const auto add = [&](const std::string& part, const std::string& file, std::string_view effect) {
            report.add(fmt::format("{}{}.{}", path, part, keyOf<&Texture::file>()),
                       Sentence("{0}: {1}",
                                file.empty() ? N_("an image file is needed, but none is named")
                                             : Sentence("{0} can't be found or read", ProperName{file}),
                                effect));
        };
        for (std::size_t i = 0; i < texture.levels.size() && texture.mipmaps == MipPolicy::Given; ++i) {
            if (!facts.pictures.level(i))
                add(elementOf<&Texture::levels>(i), texture.levels[i].file, N_("there is no such level"));
        }
        for (std::size_t i = 0; i < texture.preparation.size(); ++i) {
            if (readsOther(texture.preparation[i]) && !facts.pictures.other(i))
                add(elementOf<&Texture::preparation>(i), texture.preparation[i].file,
                    N_("the step is skipped"));
        }
        for (std::size_t i = 0; i < texture.subimages.size(); ++i) {
            if (!facts.pictures.subimage(i))
                add(elementOf<&Texture::subimages>(i), texture.subimages[i].file, N_("nothing is replaced"));
        }
    });
}

/// What a texture could be instead, and how one says so.
struct Cure {
    Fix fix;
    Texture texture;
};

/// The settings that section 3.8.10 makes completeness depend on, each set so that the levels that are there
/// may do: make the others, read no more than these, read none but the base level. `beginsAt0`: after the
/// base level was set to 0.
std::vector<Cure> curesOf(const Texture& texture, int lastLevel, const std::string& path, bool beginsAt0) {
    std::vector<Cure> cures;
    const auto add = [&](Sentence label, const std::string& key, std::string value, auto set) {
        Texture cured = texture;
        set(cured);
        cures.push_back({{std::move(label), {{path + key, std::move(value)}}}, std::move(cured)});
    };
    const auto begin = [&](int level) {
        add(Sentence("Begin at level {0}", level), keyOf<&Texture::baseLevel>(), std::to_string(level),
            [&](Texture& cured) { cured.baseLevel = level; });
    };
    if (texture.baseLevel <= lastLevel && texture.baseLevel > texture.maxLevel)
        begin(texture.maxLevel);
    if (texture.baseLevel > 0)
        begin(0);
    if (texture.mipmaps == MipPolicy::Given) {
        for (std::size_t i = 0; i < texture.levels.size(); ++i) {
            if (texture.levels[i].source == SourceKind::File)
                add(beginsAt0 ? Sentence("Begin at level 0 and put a pattern on level {0}", i + 1)
                              : Sentence("Put a pattern on level {0}", i + 1),
                    fmt::format("{}.{}", elementOf<&Texture::levels>(i), keyOf<&GivenLevel::source>()),
                    nameOf(SourceKind::Pattern),
                    [i](Texture& cured) { cured.levels[i].source = SourceKind::Pattern; });
        }
    }
    if (texture.mipmaps != MipPolicy::Generated)
        add(beginsAt0 ? N_("Begin at level 0 and generate mipmaps") : N_("Generate mipmaps"),
            keyOf<&Texture::mipmaps>(), nameOf(MipPolicy::Generated),
            [](Texture& cured) { cured.mipmaps = MipPolicy::Generated; });
    for (int level = lastLevel; level >= texture.baseLevel; --level)
        add(beginsAt0 ? Sentence("Begin at level 0 and end at level {0}", level)
                      : Sentence("End at level {0}", level),
            keyOf<&Texture::maxLevel>(), std::to_string(level),
            [&](Texture& cured) { cured.maxLevel = level; });
    if (reference::wantsMipmaps(texture.minFilter)) {
        const MinFilter filter =
            reference::isLinear(texture.minFilter) ? MinFilter::Linear : MinFilter::Nearest;
        add(beginsAt0 ? Sentence("Begin at level 0 and set {0}", named(filter))
                      : Sentence("Set {0}", named(filter)),
            keyOf<&Texture::minFilter>(), nameOf(filter), [&](Texture& cured) { cured.minFilter = filter; });
    }
    return cures;
}

/// Those of them that make the texture complete for all of its targets, one for each setting.
std::vector<Fix> fixesOf(const Texture& texture, const TextureFacts& facts, const std::string& path,
                         bool beginsAt0 = false) {
    const auto completes = [&](const Texture& cured) {
        return std::ranges::all_of(facts.targets, [&](const TargetFacts& each) {
            return factsAs(each.target, cured, facts.pictures).completeness.complete();
        });
    };
    int lastLevel = 0;
    for (const TargetFacts& each : facts.targets) {
        if (!each.plan.levels.empty())
            lastLevel = std::max(lastLevel, each.plan.levels.back().number);
    }
    std::vector<Fix> fixes;
    for (Cure& cure : curesOf(texture, lastLevel, path, beginsAt0)) {
        const bool settled = std::ranges::any_of(fixes, [&](const Fix& fix) {
            return fix.assignments.front().path == cure.fix.assignments.front().path;
        });
        if (!settled && completes(cure.texture))
            fixes.push_back(std::move(cure.fix));
    }
    if (!fixes.empty() || texture.baseLevel == 0)
        return fixes;
    Texture whole = texture; // one setting alone does not do
    whole.baseLevel = 0;
    fixes = fixesOf(whole, facts, path, true);
    for (Fix& fix : fixes)
        fix.assignments.push_back({path + keyOf<&Texture::baseLevel>(), "0"});
    return fixes;
}

/// What names the picture of a level that was given with another size than it has to have: "levels[1].file".
std::string wrongLevel(const Texture& texture, const reference::Completeness& completeness) {
    const auto index = static_cast<std::size_t>(completeness.level) - 1; // of the base: beyond all
    if (texture.mipmaps != MipPolicy::Given || index >= texture.levels.size() ||
        completeness.rule != reference::CompletenessRule::LevelSize)
        return {};
    const bool isFile = texture.levels[index].source == SourceKind::File;
    return fmt::format("{}.{}", elementOf<&Texture::levels>(index),
                       isFile ? keyOf<&GivenLevel::file>() : keyOf<&GivenLevel::pattern>());
}

/// OpenGL 2.1, section 3.8.10.
void incomplete(const Case& about, Report& report) {
    using Rule = reference::CompletenessRule;
    forEachTexture(about, [&](const Texture& texture, const TextureFacts& facts, const std::string& path) {
        if (!facts.image || !facts.shown)
            return;
        const auto broken = std::ranges::find_if(facts.targets, [&](const TargetFacts& each) {
            const bool refused = (isDepth(texture.internalFormat) && !takesDepths(each.target)) ||
                                 !each.plan.refusal.empty() ||
                                 (each.plan.upload && !each.plan.upload->refusal.empty());
            return !refused && !each.completeness.complete();
        });
        if (broken == facts.targets.end())
            return;
        const Sentence sentence = Sentence("{0}; drawn as if the unit were off", broken->completeness.reason);
        if (const std::string level = wrongLevel(texture, broken->completeness); !level.empty()) {
            report.add(path + level, sentence, fixesOf(texture, facts, path));
            return;
        }
        Key key = texture.mipmaps == MipPolicy::None ? keyOf<&Texture::minFilter> : keyOf<&Texture::mipmaps>;
        if (broken->completeness.rule == Rule::BaseLevelMissing ||
            broken->completeness.rule == Rule::BaseAboveMaxLevel)
            key = keyOf<&Texture::baseLevel>;
        else if (broken->completeness.rule == Rule::CubeFaces)
            key = imageKey(texture);
        report.add(path + key(), sentence, fixesOf(texture, facts, path));
    });
}

/// Section 3.8.8, equation 3.18: λ is undefined where its limits have changed places.
void lodRange(const Case& about, Report& report) {
    forEachTexture(about, [&](const Texture& texture, const TextureFacts&, const std::string& path) {
        if (texture.minLod <= texture.maxLod)
            return;
        const std::string low = formatNumber(texture.minLod);
        const std::string high = formatNumber(texture.maxLod);
        report.add(path + keyOf<&Texture::minLod>(),
                   Sentence("the min LOD, {0}, exceeds the max LOD, {1}: the picture is undefined in OpenGL",
                            ProperName{low}, ProperName{high}),
                   Fix{N_("Exchange them"),
                       {{path + keyOf<&Texture::minLod>(), high}, {path + keyOf<&Texture::maxLod>(), low}}});
    });
}

void anisotropyLimit(const Case& about, Report& report) {
    const float limit = about.driver.maxAnisotropy;
    forEachTexture(about, [&](const Texture& texture, const TextureFacts&, const std::string& path) {
        if (texture.maxAnisotropy <= limit)
            return;
        const std::string most = formatNumber(limit);
        report.add(path + keyOf<&Texture::maxAnisotropy>(),
                   limit <= 1
                       ? N_("the driver has no anisotropic filtering")
                       : Sentence("an anisotropy of {0} exceeds the driver's {1}, which is used instead",
                                  ProperName{formatNumber(texture.maxAnisotropy)}, ProperName{most}),
                   Fix{Sentence("Set anisotropy to {0}", ProperName{most}),
                       {{path + keyOf<&Texture::maxAnisotropy>(), most}}});
    });
}

/// When a scene is looked at: as it is now, and where it moves, at all of its keys and as long as most go on.
std::vector<double> timesOf(const Scene& scene) {
    if (!isAnimated(scene))
        return {0};
    std::vector<double> times{0, 0.25, 0.5, 1, 2, 4, 8, 16};
    constexpr std::size_t most = 64;
    for (std::size_t i = 0; i < scene.timeline.keys.size() && i < most; ++i)
        times.push_back(scene.timeline.keys[i].time);
    return times;
}

/// Whether some texture is ever filtered anisotropically: no driver lacks anything else.
bool isEverAnisotropic(const Scene& scene) {
    return std::ranges::any_of(scene.textures, [](const Texture& each) { return each.maxAnisotropy > 1; }) ||
           std::ranges::any_of(scene.timeline.keys, [](const KeyFrame& key) {
               return key.path.ends_with(keyOf<&Texture::maxAnisotropy>());
           });
}

/// What a driver isn't given of the textures, at one time or another.
void addHeldBack(const Case& about, std::string_view driver, Report& report) {
    if (!isEverAnisotropic(about.scene))
        return;
    DriverFacts named;
    named.renderer = driver;
    std::vector<std::vector<std::string_view>> sentences(about.textures.size());
    for (const double time : timesOf(about.scene)) {
        const StandingScene scene(about.scene, time);
        for (std::size_t i = 0; i < about.textures.size(); ++i) {
            const TextureFacts& facts = about.textures[i];
            if (!facts.shown || !facts.image)
                continue;
            const Texture& texture = scene->textures[i];
            for (const TargetFacts& each : facts.targets) {
                const TextureUse use{*scene, i, time};
                const AppliedTexture applied = appliedTexture(texture, shapeOf(each, texture.internalFormat),
                                                              each.plan.lastLevel, named, &use);
                for (const std::string_view sentence : applied.heldBack) {
                    if (std::ranges::find(sentences[i], sentence) == sentences[i].end())
                        sentences[i].push_back(sentence);
                }
            }
        }
    }
    for (std::size_t i = 0; i < sentences.size(); ++i) {
        const std::string path =
            fmt::format("{}.{}", elementOf<&Scene::textures>(i), keyOf<&Texture::maxAnisotropy>());
        for (const std::string_view sentence : sentences[i])
            report.add(path, sentence, Fix{N_("Set anisotropy to 1"), {{path, "1"}}});
    }
}

/// What this driver doesn't survive.
void heldBack(const Case& about, Report& report) {
    addHeldBack(about, about.driver.renderer, report);
}

/// Where the driver isn't known: what some don't.
void heldBackElsewhere(const Case& about, Report& report) {
    if (!about.driver.renderer.empty())
        return;
    std::string_view last;
    for (const DriverFlaw& flaw : driverFlaws()) {
        if (flaw.driver != last)
            addHeldBack(about, flaw.driver, report);
        last = flaw.driver;
    }
}

void lacksFormat(const Case& about, Report& report) {
    forEachTexture(about, [&](const Texture& texture, const TextureFacts& facts, const std::string& path) {
        const std::optional<BlockFormat>& blocks = facts.targets.front().plan.blocks;
        if (!blocks && isFloat(texture.internalFormat) && !about.driver.floatTextures)
            report.add(path + keyOf<&Texture::internalFormat>(),
                       Sentence("the driver has no {0}: the texture has 8 bits a component, limited to 0 … 1",
                                named(texture.internalFormat)));
        if (!blocks || (isS3tc(*blocks) ? about.driver.s3tc : about.driver.rgtc))
            return;
        report.add(path + keyOf<&Texture::compression>(),
                   Sentence("the driver has no {0}: the texture is uploaded decompressed", named(*blocks)));
    });
}

void refusedBorder(const Case& about, Report& report) {
    forEachTexture(about, [&](const Texture& texture, const TextureFacts& facts, const std::string& path) {
        if (texture.border > 1 && facts.image && facts.shown)
            report.add(
                path + keyOf<&Texture::border>(),
                Sentence("GL_INVALID_VALUE: OpenGL has borders of 0 and 1 texels, not of {0}; drawn as if "
                         "the unit were off",
                         texture.border),
                {Fix{Sentence("Set {0} to {1}", N_("Border"), 1), {{path + keyOf<&Texture::border>(), "1"}}},
                 Fix{N_("Do without it"), {{path + keyOf<&Texture::border>(), "0"}}}});
    });
}

void lostBorder(const Case& about, Report& report) {
    if (about.driver.textureBorders)
        return;
    forEachTexture(about, [&](const Texture& texture, const TextureFacts&, const std::string& path) {
        if (texture.border != 0)
            report.add(path + keyOf<&Texture::border>(),
                       N_("the driver drops a texture's border and uses the border colour instead; the "
                          "reference renderer shows the border"),
                       Fix{N_("Do without it"), {{path + keyOf<&Texture::border>(), "0"}}});
    });
}

/// Where levels are made of each other, it can't be seen. Mesa 22.3 (lp_bld_sample.c): one derivative for
/// four pixels, and the logarithm of rho^2 from a float's exponent and mantissa, which is up to 0.0861 too
/// small.
void roughLambda(const Case& about, Report& report) {
    if (!about.driver.renderer.starts_with("llvmpipe"))
        return;
    forEachTexture(about, [&](const Texture& texture, const TextureFacts& facts, const std::string& path) {
        if (texture.mipmaps == MipPolicy::Given && reference::wantsMipmaps(texture.minFilter) &&
            facts.targets.front().plan.levels.size() > 1)
            report.add(
                path + keyOf<&Texture::minFilter>(),
                N_("llvmpipe computes lambda once for 2 × 2 pixels, up to 0.1 off: levels change a few "
                   "pixels earlier or later than in the reference renderer"));
    });
}

constexpr std::array textureRuleRows{
    Rule{"missing-file", Severity::Error, missingFile, true},
    Rule{"missing-part", Severity::Error, missingPart, true},
    Rule{"incomplete", Severity::Warning, incomplete},
    Rule{"lod-range", Severity::Warning, lodRange},
    Rule{"anisotropy-limit", Severity::Warning, anisotropyLimit, true},
    Rule{"held-back", Severity::Warning, heldBack, true},
    Rule{"held-back-elsewhere", Severity::Note, heldBackElsewhere},
    Rule{"missing-format", Severity::Warning, lacksFormat, true},
    Rule{"border-refused", Severity::Error, refusedBorder, true},
    Rule{"lost-border", Severity::Warning, lostBorder},
    Rule{"rough-lambda", Severity::Note, roughLambda},
};

} // namespace

Key imageKey(const Texture& texture) {
    switch (texture.source) {
    case SourceKind::Pattern:
        break;
    case SourceKind::File:
        return keyOf<&Texture::file>;
    case SourceKind::LightDepth:
        return keyOf<&Texture::depthSize>;
    case SourceKind::Picture:
        return keyOf<&Texture::picture>;
    }
    return keyOf<&Texture::pattern>;
}

std::span<const Rule> textureRules() {
    return textureRuleRows;
}

} // namespace texplorer::diagnosis

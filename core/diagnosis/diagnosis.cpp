#include "texplorer/diagnosis/diagnosis.h"

#include "texplorer/diagnosis/applied_texture.h"
#include "texplorer/diagnosis/diagnosis_rules.h"
#include "texplorer/scene/params/params.h"

#include <fmt/core.h>

#include <algorithm>

namespace texplorer {

namespace diagnosis {

bool TextureFacts::hasTarget(Target target) const {
    return as(target) != nullptr;
}

const TargetFacts* TextureFacts::as(Target target) const {
    const auto found = std::ranges::find(targets, target, &TargetFacts::target);
    return found == targets.end() ? nullptr : &*found;
}

const TextureFacts* Case::textureOf(const Unit& unit) const {
    const bool exists = unit.texture >= 0 && static_cast<std::size_t>(unit.texture) < textures.size();
    return exists ? &textures[static_cast<std::size_t>(unit.texture)] : nullptr;
}

bool Case::works(const Unit& unit) const {
    const TextureFacts* texture = textureOf(unit);
    if (!unit.enabled || !texture || !texture->image)
        return false;
    const TargetFacts* facts = texture->as(unit.target);
    return facts && facts->completeness.complete();
}

std::string unitPath(std::size_t pass, std::size_t unit) {
    return fmt::format("{}.{}.", elementOf<&Scene::passes>(pass), elementOf<&Pass::units>(unit));
}

std::string noTexCoordPath(std::size_t model, std::size_t unit) {
    return fmt::format("{}.{}", elementOf<&Scene::models>(model),
                       findKey(memberId<&Model::noTexCoord>, unit));
}

TargetFacts factsAs(Target target, const Texture& texture, const TexturePictures& pictures) {
    TargetFacts facts{target, planLevels(texture, pictures, target), {}, baseFormat(texture.internalFormat)};
    if (facts.plan.blocks)
        facts.format = baseFormat(*facts.plan.blocks);
    else if (isDepth(texture.internalFormat))
        facts.format = baseFormat(texture.depthMode);
    facts.completeness =
        appliedTexture(texture, shapeOf(facts, texture.internalFormat), facts.plan.lastLevel, {})
            .completeness;
    return facts;
}

reference::SampledTexture shapeOf(const TargetFacts& facts, InternalFormat format) {
    reference::SampledTexture shape;
    shape.target = facts.target;
    for (const PlannedLevel& each : facts.plan.levels) {
        for (int face = 0; face < facesOf(facts.target); ++face)
            shape.levelToFill(each.number,
                              face) = {each.width, each.height, each.depth, facts.plan.border, {}};
    }
    shape.format = facts.format;
    shape.internalFormat = format;
    return shape;
}

namespace {

std::vector<TextureFacts> factsOf(const Scene& scene, const ImageSource& images, const DriverFacts& driver) {
    std::vector<TextureFacts> all(scene.textures.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Texture& texture = scene.textures[i];
        TextureFacts& facts = all[i];
        facts.pictures = images.picturesOf(texture);
        if (texture.oversize == Oversize::Smaller)
            facts.pictures.limits = TextureLimits::lower(facts.pictures.limits, driver.limits());
        facts.image = facts.pictures.base;
        if (facts.image && (facts.image->surfaces.empty() || byteCount(facts.image->surfaces.front()) == 0))
            facts.image = nullptr;
        const auto binds = [&](const Unit& unit) { return unit.texture == static_cast<int>(i); };
        bool seamless = driver.seamlessCubeMaps;
        forEachUnit(scene, [&](const Unit& unit, const std::string&, std::size_t p) {
            if (!binds(unit) || !unit.enabled)
                return;
            facts.shown = true;
            seamless = seamless && unit.target == Target::CubeMap && scene.passes[p].seamlessCubeMap;
        });
        facts.seamless = facts.shown && seamless;
        forEachUnit(scene, [&](const Unit& unit, const std::string&, std::size_t) {
            if (binds(unit) && unit.enabled == facts.shown && !facts.hasTarget(unit.target))
                facts.targets.push_back(factsAs(unit.target, texture, facts.pictures));
        });
        if (facts.targets.empty())
            facts.targets.push_back(factsAs(Target::Texture2D, texture, facts.pictures));
    }
    return all;
}

} // namespace
} // namespace diagnosis

std::vector<Finding> diagnose(const Scene& scene, const ImageSource& images, const DriverFacts& driver) {
    using namespace diagnosis;
    const Case about{scene, driver, factsOf(scene, images, driver)};
    std::vector<Finding> findings;
    Report report(findings);
    for (const std::span<const Rule> rules :
         {textureRules(), sizeRules(), uploadRules(), formatRules(), unitRules(), matrixRules(), cubeRules(),
          combineRules(), passRules(), pictureRules(), alphaRules(), modelRules(), vertexRules(),
          lightRules(), sideRules(), fogRules(), depthRules(), textureEffectRules()}) {
        for (const Rule& rule : rules) {
            report.begin(rule.name, rule.severity, rule.reportedByRenderer);
            rule.find(about, report);
        }
    }
    std::ranges::stable_sort(findings, {}, &Finding::severity);
    return findings;
}

Result<void> apply(const Fix& fix, Scene& scene) {
    return makeEdits(scene, std::vector<Edit>(fix.assignments.begin(), fix.assignments.end()));
}

bool isPartOf(std::string_view path, std::string_view whole) {
    return path.starts_with(whole) &&
           (path.size() == whole.size() || path[whole.size()] == '.' || path[whole.size()] == '[');
}

const Finding* problemOf(const std::vector<Finding>& findings, std::string_view path) {
    const auto found = std::ranges::find_if(findings, [&](const Finding& each) {
        return each.severity <= Severity::Note && isPartOf(each.path, path);
    });
    return found == findings.end() ? nullptr : &*found;
}

const Finding* idleReasonOf(const std::vector<Finding>& findings, std::string_view path) {
    const auto isMending = [&](const Finding& each) { // what would give the rest an effect has one itself
        return std::ranges::any_of(each.fixes, [&](const Fix& fix) {
            return std::ranges::any_of(fix.assignments,
                                       [&](const edit::Set& set) { return set.path == path; });
        });
    };
    const auto found = std::ranges::find_if(findings, [&](const Finding& each) {
        return each.severity >= Severity::Hint && isPartOf(path, each.path) && !isMending(each);
    });
    return found == findings.end() ? nullptr : &*found;
}

} // namespace texplorer

// Textures that a driver has no room for.

#include "texplorer/diagnosis/diagnosis_rules.h"
#include "texplorer/image/power_of_two.h"
#include "texplorer/scene/params/param_text.h"

#include <fmt/core.h>

#include <algorithm>

namespace texplorer::diagnosis {
namespace {

std::string extentsOf(const PlannedLevel& level) {
    std::string text = fmt::format("{} × {}", level.width, level.height);
    return level.depth > 1 ? fmt::format("{} × {}", text, level.depth) : text;
}

void nonPowerOfTwo(const Case& about, Report& report) {
    if (about.driver.nonPowerOfTwo)
        return;
    forEachTexture(about, [&](const Texture& texture, const TextureFacts& facts, const std::string& path) {
        const LevelPlan& plan = facts.targets.front().plan;
        if (plan.levels.empty() ||
            arePowersOfTwo(plan.levels.front().width, plan.levels.front().height, plan.levels.front().depth))
            return;
        std::vector<Fix> fixes;
        if (texture.mipmaps != MipPolicy::FromFile)
            fixes = {{N_("Scale it"), {{path + keyOf<&Texture::npot>(), nameOf(NpotPolicy::PowerOfTwo)}}}};
        report.add(path + keyOf<&Texture::npot>(),
                   Sentence("{0} texels: the driver supports powers of two only (no "
                            "GL_ARB_texture_non_power_of_two)",
                            ProperName{extentsOf(plan.levels.front())}),
                   std::move(fixes));
    });
}

/// Smaller levels where they are needed, or an image that is halved everywhere until it fits.
std::vector<Fix> smaller(const Texture& texture, const PlannedLevel& base, int limit,
                         const std::string& path) {
    if (isDrawn(texture.source))
        return {};
    std::vector<Fix> fixes{
        {N_("Draw smaller levels"), {{path + keyOf<&Texture::oversize>(), nameOf(Oversize::Smaller)}}}};
    if (texture.preparation.size() >= maxImageSteps)
        return fixes;
    float share = 1;
    for (int extent = std::max({base.width, base.height, base.depth}); extent > limit; extent /= 2)
        share /= 2;
    const std::string step = path + elementOf<&Texture::preparation>(texture.preparation.size());
    fixes.push_back({N_("Scale it down"),
                     {newStep(path, ImageOp::Resize),
                      {fmt::format("{}.{}", step, keyOf<&ImageStep::share>()), formatNumber(share)}}});
    return fixes;
}

void sizeLimit(const Case& about, Report& report) {
    forEachTexture(about, [&](const Texture& texture, const TextureFacts& facts, const std::string& path) {
        for (const TargetFacts& each : facts.targets) {
            const int limit = about.driver.maxTexels(each.target);
            if (each.plan.levels.empty())
                continue;
            const PlannedLevel& base = each.plan.levels.front();
            if (std::max({base.width, base.height, base.depth}) <= limit)
                continue;
            report.add(path + imageKey(texture)(),
                       Sentence("{0} texels exceed the driver's {1} for {2}: drawn without it",
                                ProperName{extentsOf(base)}, limit, named(each.target)),
                       smaller(texture, base, limit, path));
        }
    });
}

void drawnSmaller(const Case& about, Report& report) {
    forEachTexture(about, [&](const Texture&, const TextureFacts& facts, const std::string& path) {
        for (const TargetFacts& each : facts.targets) {
            if (!each.plan.fallback.empty())
                report.add(path + keyOf<&Texture::oversize>(), each.plan.fallback);
        }
    });
}

/// Section 3.8.1: level k may have what is left of the driver's largest texture, halved k times.
void levelSizeLimit(const Case& about, Report& report) {
    forEachTexture(about, [&](const Texture& texture, const TextureFacts& facts, const std::string& path) {
        if (texture.mipmaps != MipPolicy::Given)
            return;
        for (const TargetFacts& each : facts.targets) {
            const int limit = about.driver.maxTexels(each.target);
            for (const PlannedLevel& level : each.plan.levels) {
                const int most = limit >> level.number;
                if (level.number == 0 || std::max({level.width, level.height, level.depth}) <= most)
                    continue;
                report.add(path + elementOf<&Texture::levels>(static_cast<std::size_t>(level.number) - 1),
                           most == 0
                               ? Sentence("the driver has no level {0}: uploaded without it", level.number)
                               : Sentence("{0} texels exceed the driver's {1} for level {2}: uploaded "
                                          "without it",
                                          ProperName{extentsOf(level)}, most, level.number));
            }
        }
    });
}

constexpr std::array sizeRuleRows{
    Rule{"size-limit", Severity::Error, sizeLimit, true},
    Rule{"level-size-limit", Severity::Error, levelSizeLimit},
    Rule{"drawn-smaller", Severity::Note, drawnSmaller, true},
    Rule{"non-power-of-two", Severity::Warning, nonPowerOfTwo},
};

} // namespace

std::span<const Rule> sizeRules() {
    return sizeRuleRows;
}

} // namespace texplorer::diagnosis

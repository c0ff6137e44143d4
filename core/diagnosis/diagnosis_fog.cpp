// Fog: what hides everything or nothing of what is in view, and which of its settings do nothing.

#include "texplorer/diagnosis/diagnosis_rules.h"
#include "texplorer/reference/shading/fog.h"
#include "texplorer/scene/animation.h"
#include "texplorer/scene/drawn_models.h"
#include "texplorer/scene/model_mesh.h"
#include "texplorer/scene/params/param_text.h"

#include <fmt/core.h>
#include <glm/common.hpp>
#include <glm/exponential.hpp>

#include <algorithm>
#include <cmath>

namespace texplorer::diagnosis {
namespace {

/// From this share on one doesn't see it.
constexpr float faint = 0.05F;

/// Of the rows of a fog's start and end.
constexpr float fogLimit = 1000;

template<class Visit> ///< visit(pass, "passes[0].fog."), of passes that are drawn
void forEachFog(const Scene& scene, Visit visit) {
    for (std::size_t p = 0; p < scene.passes.size(); ++p) {
        if (scene.passes[p].enabled)
            visit(scene.passes[p], fmt::format("{}.{}.", elementOf<&Scene::passes>(p), keyOf<&Pass::fog>()));
    }
}

/// Between which distances from the eye's plane models lie.
struct Distances {
    float nearest;
    float farthest;
};

/// Of what a pass draws at the beginning; nothing if all of it is behind the eye.
std::optional<Distances> distancesOf(const Scene& scene, const Pass& pass) {
    float low = INFINITY; // of z in eye coordinates
    float high = -INFINITY;
    for (const std::size_t index : drawnModels(scene, pass)) {
        const Model& model = scene.models[index];
        const glm::mat4 modelView = modelViewMatrix(scene.view, model, 0);
        for (const Vertex& vertex : meshOf(model).vertices) {
            const float z = (modelView * glm::vec4(vertex.position, 1)).z;
            low = std::min(low, z);
            high = std::max(high, z);
        }
    }
    const ClipPlanes planes = clipPlanes(scene.view);
    const auto far = static_cast<float>(planes.far);
    const bool perspective = scene.view.projection == Projection::Perspective;
    low = std::max(low, -far);
    high = std::min(high, perspective ? -static_cast<float>(planes.near) : far);
    if (!(low <= high))
        return std::nullopt;
    const float nearest = low <= 0 && high >= 0 ? 0 : std::min(std::abs(low), std::abs(high));
    return Distances{nearest, std::max(std::abs(low), std::abs(high))};
}

/// Three digits are enough for a fix. A float's power of ten is no float for the smallest of them.
std::string rounded(double value) {
    const double size = std::abs(value);
    const double digits = size > 0 ? std::pow(10.0, 2 - std::floor(std::log10(size))) : 1;
    return formatNumber(static_cast<float>(std::round(value * digits) / digits));
}

/// Fog that is thin where models are nearest, and thick where they are farthest.
Fix fittingFog(const Fog& fog, const std::string& path, Distances distances) {
    const bool isLinear = fog.mode == FogMode::Linear;
    if (isLinear && distances.nearest < fogLimit - 1) {
        const float around = std::max(0.0F, 1 - (distances.farthest - distances.nearest)) / 2;
        const float end = std::min(distances.farthest + around, fogLimit);
        const float start = std::min(distances.nearest - around, end - 1);
        return {Sentence("From {0} to {1}", ProperName{rounded(start)}, ProperName{rounded(end)}),
                {{path + keyOf<&Fog::start>(), rounded(start)}, {path + keyOf<&Fog::end>(), rounded(end)}}};
    }
    // Half of a colour is left in the middle.
    const float middle = std::max((distances.nearest + distances.farthest) / 2, 0.01F);
    const float thickness = std::log(2.0F);
    const float density = (fog.mode == FogMode::Exp2 ? std::sqrt(thickness) : thickness) / middle;
    Fix fix{Sentence("Set {0}", ProperName{rounded(density)}),
            {{path + keyOf<&Fog::density>(), rounded(density)}}};
    if (isLinear) { // which ends before all that there is
        fix.label = Sentence("Make it {0} with {1}", named(FogMode::Exp), ProperName{rounded(density)});
        fix.assignments.push_back({path + keyOf<&Fog::mode>(), nameOf(FogMode::Exp)});
    }
    return fix;
}

bool isRange(const Fog& fog) {
    return fog.mode != FogMode::Linear || fog.start < fog.end;
}

/// The setting that thickens fog most.
std::string decisiveKey(const Fog& fog) {
    return fog.mode == FogMode::Linear ? keyOf<&Fog::end>() : keyOf<&Fog::density>();
}

void fogRange(const Case& about, Report& report) {
    forEachFog(about.scene, [&](const Pass& pass, const std::string& path) {
        const Fog& fog = pass.fog;
        if (!fog.enabled || isRange(fog))
            return;
        const std::string key = path + keyOf<&Fog::end>();
        if (fog.start > fog.end)
            return report.add(
                key,
                Sentence("the fog ends at {0}, before it starts at {1}: near objects are hidden and far "
                         "ones are clear",
                         ProperName{formatNumber(fog.end)}, ProperName{formatNumber(fog.start)}),
                Fix{N_("Exchange them"),
                    {{path + keyOf<&Fog::start>(), formatNumber(fog.end)}, {key, formatNumber(fog.start)}}});
        const auto distances = distancesOf(about.scene, pass);
        report.add(key,
                   Sentence("the fog ends where it starts, at {0}: OpenGL divides by 0, and drivers differ",
                            ProperName{formatNumber(fog.end)}),
                   fittingFog(fog, path, distances.value_or(Distances{fog.start, fog.start + 1})));
    });
}

void fogOfNoUse(const Case& about, Report& report) {
    forEachFog(about.scene, [&](const Pass& pass, const std::string& path) {
        const Fog& fog = pass.fog;
        if (!fog.enabled || !isRange(fog))
            return;
        const auto distances = distancesOf(about.scene, pass);
        if (!distances)
            return;
        const float most = reference::fogFactor(fog, distances->nearest);
        const float least = reference::fogFactor(fog, distances->farthest);
        const std::string where = path + decisiveKey(fog);
        if (most < faint)
            report.add(where,
                       Sentence("the nearest object in view is {0} away, where this fog leaves {1} % of a "
                                "colour: everything is hidden",
                                ProperName{rounded(distances->nearest)}, ProperName{rounded(most * 100)}),
                       fittingFog(fog, path, *distances));
        else if (least > 1 - 0.5F / 255) // which rounding takes away
            report.add(where,
                       Sentence("the farthest object in view is {0} away, where this fog hides nothing yet",
                                ProperName{rounded(distances->farthest)}),
                       fittingFog(fog, path, *distances));
    });
}

/// What ends in fog ends in its colour, and beyond is the background.
void fogColor(const Case& about, Report& report) {
    const glm::vec3 background = glm::clamp(glm::vec3(about.scene.view.background), 0.0F, 1.0F);
    forEachFog(about.scene, [&](const Pass& pass, const std::string& path) {
        const Fog& fog = pass.fog;
        if (!fog.enabled || pass.blend || !isRange(fog))
            return;
        const glm::vec3 away = glm::abs(glm::clamp(glm::vec3(fog.color), 0.0F, 1.0F) - background);
        const auto distances = distancesOf(about.scene, pass);
        if (std::max({away.r, away.g, away.b}) <= 0.1F || !distances ||
            reference::fogFactor(fog, distances->farthest) > faint)
            return;
        const auto number = [&](int i) { return formatNumber(background[i]); };
        report.add(path + keyOf<&Fog::color>(),
                   N_("the fog's colour differs from the background's: faded objects stand out against it"),
                   Fix{N_("Use the background's"),
                       {{path + keyOf<&Fog::color>(), fmt::format("{},{},{},{}", number(0), number(1),
                                                                  number(2), formatNumber(fog.color.a))}}});
    });
}

void otherFog(const Case& about, Report& report) {
    forEachFog(about.scene, [&](const Pass& pass, const std::string& path) {
        const auto idle = [&](std::initializer_list<Key> keys, const Sentence& reason) {
            for (const Key key : keys)
                report.add(path + key(), reason);
        };
        if (!pass.fog.enabled)
            idle({keyOf<&Fog::mode>, keyOf<&Fog::density>, keyOf<&Fog::start>, keyOf<&Fog::end>,
                  keyOf<&Fog::color>},
                 N_("the fog is off"));
        else if (pass.fog.mode == FogMode::Linear)
            idle({keyOf<&Fog::density>}, Sentence("{0} has a start and an end", named(pass.fog.mode)));
        else
            idle({keyOf<&Fog::start>, keyOf<&Fog::end>}, Sentence("{0} has a density", named(pass.fog.mode)));
    });
}

constexpr std::array fogRuleRows{
    Rule{"fog-range", Severity::Warning, fogRange},
    Rule{"fog-of-no-use", Severity::Warning, fogOfNoUse},
    Rule{"fog-color", Severity::Warning, fogColor},
    Rule{"fog", Severity::Hint, otherFog},
};

} // namespace

std::span<const Rule> fogRules() {
    return fogRuleRows;
}

} // namespace texplorer::diagnosis

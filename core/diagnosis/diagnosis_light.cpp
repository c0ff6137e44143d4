// Light and material: which of their settings reach no pixel.

#include "core/diagnosis/color_flow.h"

#include <fmt/core.h>

#include <algorithm>

namespace texplorer::diagnosis {
namespace {

constexpr const char* blocked = "the texture units let nothing of the primary colour through";

bool isBlack(const glm::vec4& color) {
    return color.r == 0 && color.g == 0 && color.b == 0;
}

/// Why there is no highlight, whatever its other settings are; nullptr: there may be one.
const char* whyDull(const Scene& scene) {
    if (isBlack(scene.material.specular))
        return "the material's specular colour is black";
    return isBlack(scene.light.specular) ? "the light's specular colour is black" : nullptr;
}

/// Section 3.9: the colour sum adds the highlight after texturing.
bool addsHighlight(const Scene& scene) {
    return scene.light.colorControl == ColorControl::SeparateSpecular && !whyDull(scene);
}

void addAll(Report& report, std::initializer_list<Key> paths, const char* reason) {
    for (const Key path : paths)
        report.add(path(), reason);
}

void noColor(const Case& about, Report& report) {
    if (std::ranges::none_of(about.scene.passes, [&](const Pass& pass) {
            return pass.enabled && primaryInFragments(about, pass).any();
        }))
        report.add(pathOf<&Scene::material, &Material::color>(), blocked);
}

/// Alpha is the same with lighting and without it (section 2.14.1).
void noLighting(const Case& about, Report& report) {
    for (std::size_t p = 0; p < about.scene.passes.size(); ++p) {
        if (about.scene.passes[p].enabled && !primaryInFragments(about, about.scene.passes[p]).rgb &&
            !addsHighlight(about.scene))
            report.add(fmt::format("{}.{}", elementOf<&Scene::passes>(p), keyOf<&Pass::lighting>()), blocked);
    }
}

void noLight(const Case& about, Report& report) {
    const Scene& scene = about.scene;
    if (std::ranges::none_of(scene.passes, [](const Pass& pass) { return pass.enabled && pass.lighting; })) {
        addAll(report,
               {keyOf<&Scene::light>, pathOf<&Scene::material, &Material::specular>,
                pathOf<&Scene::material, &Material::shininess>},
               "no pass has lighting");
        report.add(pathOf<&Scene::material, &Material::shadeModel>(),
                   "without lighting all vertices have the same colour");
        return;
    }
    const char* dull = whyDull(scene);
    if (dull)
        addAll(report, {pathOf<&Scene::light, &Light::colorControl>}, dull);
    const bool shown = std::ranges::any_of(scene.passes, [&](const Pass& pass) {
        return pass.enabled && pass.lighting && primaryInFragments(about, pass).rgb;
    });
    if (!shown)
        addAll(report,
               {pathOf<&Scene::light, &Light::ambient>, pathOf<&Scene::light, &Light::diffuse>,
                pathOf<&Scene::light, &Light::modelAmbient>},
               blocked);
    if (!shown && !addsHighlight(scene))
        return addAll(
            report,
            {pathOf<&Scene::light, &Light::position>, pathOf<&Scene::light, &Light::specular>,
             pathOf<&Scene::light, &Light::localViewer>, pathOf<&Scene::material, &Material::specular>,
             pathOf<&Scene::material, &Material::shininess>, pathOf<&Scene::material, &Material::shadeModel>},
            blocked);
    if (dull) {
        report.add(isBlack(scene.material.specular) ? pathOf<&Scene::light, &Light::specular>()
                                                    : pathOf<&Scene::material, &Material::specular>(),
                   dull);
        addAll(report,
               {pathOf<&Scene::material, &Material::shininess>, pathOf<&Scene::light, &Light::localViewer>},
               dull);
    }
}

constexpr std::array lightRuleRows{
    Rule{"light", Severity::Hint, noLight},
    Rule{"lighting", Severity::Hint, noLighting},
    Rule{"color", Severity::Hint, noColor},
};

} // namespace

std::span<const Rule> lightRules() {
    return lightRuleRows;
}

} // namespace texplorer::diagnosis

// Light and material: which of their settings reach no pixel.

#include "texplorer/diagnosis/color_flow.h"
#include "texplorer/scene/drawn_models.h"
#include "texplorer/scene/model_mesh.h"

#include <fmt/core.h>

#include <algorithm>

namespace texplorer::diagnosis {
namespace {

constexpr const char* blocked = N_("the texture units replace the primary colour");

bool isBlack(const glm::vec4& color) {
    return color.r == 0 && color.g == 0 && color.b == 0;
}

/// The materials of the models that are drawn, each once; of a scene that draws none, its own.
std::vector<const Material*> materialsOf(const Scene& scene) {
    std::vector<const Material*> found;
    for (const Pass& pass : scene.passes) {
        for (const std::size_t model : drawnModels(scene, pass)) {
            const Material* material = &materialOf(scene, scene.models[model]);
            if (std::ranges::find(found, material) == found.end())
                found.push_back(material);
        }
    }
    if (found.empty())
        found.push_back(&scene.material);
    return found;
}

bool isDull(const Scene& scene) {
    return std::ranges::all_of(materialsOf(scene),
                               [](const Material* each) { return isBlack(each->specular); });
}

/// Why there is no highlight for any other settings; nullptr: there may be one.
const char* whyDull(const Scene& scene) {
    if (isDull(scene))
        return N_("the material's specular colour is black");
    return isBlack(scene.light.specular) ? N_("the light's specular colour is black") : nullptr;
}

/// Section 3.9: the colour sum adds the highlight after texturing.
bool addsHighlight(const Scene& scene) {
    return scene.light.colorControl == ColorControl::SeparateSpecular && !whyDull(scene);
}

/// Whether coordinates follow the light, lit or not.
bool movesCoordinates(const Scene& scene) {
    return usesLightView(scene) || std::ranges::any_of(scene.passes, [&](const Pass& pass) {
               return drawsAnything(scene, pass) && std::ranges::any_of(pass.units, [](const Unit& unit) {
                          return unit.enabled && unit.emboss.enabled;
                      });
           });
}

/// Whether glShadeModel matters without lighting.
bool hasVertexColors(const Scene& scene) {
    return std::ranges::any_of(scene.models, [](const Model& model) {
        return model.shape == Shape::Mesh && !model.mesh.colors.empty();
    });
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
        if (movesCoordinates(scene)) {
            for (const ParamRow& row : lightTable().params) {
                if (row.member != memberId<&Light::position>)
                    report.add(fmt::format("{}.{}", keyOf<&Scene::light>(), row.key),
                               N_("no pass has lighting"));
            }
        } else
            report.add(keyOf<&Scene::light>(), N_("no pass has lighting"));
        addAll(report,
               {pathOf<&Scene::material, &Material::colorMaterial>,
                pathOf<&Scene::material, &Material::ambient>, pathOf<&Scene::material, &Material::diffuse>,
                pathOf<&Scene::material, &Material::specular>, pathOf<&Scene::material, &Material::emission>,
                pathOf<&Scene::material, &Material::shininess>},
               N_("no pass has lighting"));
        if (!hasVertexColors(scene))
            report.add(pathOf<&Scene::material, &Material::shadeModel>(),
                       N_("without lighting all vertices have the same colour"));
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
    if (!shown && !addsHighlight(scene)) {
        if (!movesCoordinates(scene))
            addAll(report, {pathOf<&Scene::light, &Light::position>}, blocked);
        if (!hasVertexColors(scene))
            addAll(report, {pathOf<&Scene::material, &Material::shadeModel>}, blocked);
        return addAll(report,
                      {pathOf<&Scene::light, &Light::specular>, pathOf<&Scene::light, &Light::localViewer>,
                       pathOf<&Scene::light, &Light::twoSide>, pathOf<&Scene::material, &Material::specular>,
                       pathOf<&Scene::material, &Material::shininess>},
                      blocked);
    }
    if (dull) {
        report.add(isDull(scene) ? pathOf<&Scene::light, &Light::specular>()
                                 : pathOf<&Scene::material, &Material::specular>(),
                   dull);
        addAll(report,
               {pathOf<&Scene::material, &Material::shininess>, pathOf<&Scene::light, &Light::localViewer>},
               dull);
    }
}

/// With GL_COLOR_MATERIAL, glColor replaces two reflectances; without, it has no effect.
void otherReflectance(const Case& about, Report& report) {
    const Scene& scene = about.scene;
    const auto lit = [](const Pass& pass) { return pass.enabled && pass.lighting; };
    if (std::ranges::none_of(scene.passes, lit))
        return;
    const bool allLit =
        std::ranges::all_of(scene.passes, [](const Pass& pass) { return !pass.enabled || pass.lighting; });
    const auto check = [&](const Material& material, const std::string& path) {
        if (material.colorMaterial) {
            for (const Key key : {keyOf<&Material::ambient>, keyOf<&Material::diffuse>})
                report.add(fmt::format("{}.{}", path, key()),
                           N_("glColor is used instead (GL_COLOR_MATERIAL)"),
                           Fix{N_("Use it"),
                               {{fmt::format("{}.{}", path, keyOf<&Material::colorMaterial>()), "false"}}});
        } else if (allLit)
            report.add(fmt::format("{}.{}", path, keyOf<&Material::color>()),
                       N_("with lighting and without GL_COLOR_MATERIAL, ambient and diffuse are used"));
    };
    check(scene.material, keyOf<&Scene::material>());
    for (std::size_t m = 0; m < scene.models.size(); ++m) {
        if (scene.models[m].ownMaterial)
            check(scene.models[m].material,
                  fmt::format("{}.{}", elementOf<&Scene::models>(m), keyOf<&Model::material>()));
    }
}

/// Where all models have materials of their own.
void unusedMaterial(const Case& about, Report& report) {
    const Scene& scene = about.scene;
    const std::vector<const Material*> used = materialsOf(scene);
    if (std::ranges::find(used, &scene.material) != used.end())
        return;
    for (const ParamRow& row : modelMaterialTable().params)
        report.add(fmt::format("{}.{}", keyOf<&Scene::material>(), row.key),
                   N_("every visible model has a material of its own"));
}

constexpr std::array lightRuleRows{
    Rule{"unused-material", Severity::Hint, unusedMaterial},
    Rule{"other-reflectance", Severity::Hint, otherReflectance},
    Rule{"light", Severity::Hint, noLight},
    Rule{"lighting", Severity::Hint, noLighting},
    Rule{"color", Severity::Hint, noColor},
};

} // namespace

std::span<const Rule> lightRules() {
    return lightRuleRows;
}

} // namespace texplorer::diagnosis

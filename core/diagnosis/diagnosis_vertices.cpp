// Vertices whose normals or coordinates OpenGL leaves undefined, or that drivers lack the bits for.

#include "texplorer/diagnosis/diagnosis_rules.h"
#include "texplorer/reference/shading/coordinate_reach.h"
#include "texplorer/reference/shading/coordinates.h"
#include "texplorer/reference/shading/tex_gen.h"
#include "texplorer/scene/animation.h"
#include "texplorer/scene/drawn_models.h"
#include "texplorer/scene/model_mesh.h"
#include "texplorer/scene/params/param_text.h"
#include "texplorer/scene/params/params.h"
#include "texplorer/scene/params/scene_at.h"
#include "texplorer/scene/sent_vertices.h"

#include <fmt/core.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace texplorer::diagnosis {
namespace {

/// Whether a unit generates s, t or r in one of these modes.
bool generates(const Unit& unit, std::initializer_list<TexGenMode> modes) {
    return unit.enabled && std::ranges::any_of(std::array{&unit.texGenS, &unit.texGenT, &unit.texGenR},
                                               [&](const TexGen* each) {
                                                   return each->enabled &&
                                                          std::ranges::find(modes, each->mode) != modes.end();
                                               });
}

bool readsNormals(const Pass& pass) {
    return pass.lighting || std::ranges::any_of(pass.units, [](const Unit& unit) {
               return generates(unit,
                                {TexGenMode::SphereMap, TexGenMode::ReflectionMap, TexGenMode::NormalMap});
           });
}

Sentence andMore(const Sentence& sentence, std::size_t others) {
    return others > 0 ? Sentence("{0}; the same is true of {1} more", sentence, others) : sentence;
}

/// With (0, 0, 1) in the place of what has no length, which is what glNormal begins with. A long list makes
/// no fix that one would read.
std::vector<Fix> normalFixes(const Scene& scene, std::size_t model, const std::string& path) {
    constexpr std::size_t longest = 64;
    Scene fixed;
    fixed.models.assign(model + 1, {});
    std::vector<glm::vec3>& normals = fixed.models[model].mesh.normals.edit();
    normals = scene.models[model].mesh.normals;
    if (normals.size() > longest)
        return {};
    std::ranges::replace_if(
        normals, [](glm::vec3 each) { return !(glm::length(each) > 0); }, glm::vec3(0, 0, 1));
    const Result<std::string> value = getParam(fixed, path);
    return value ? std::vector{Fix{N_("Make them 0,0,1"), {{path, *value}}}} : std::vector<Fix>();
}

/// Section 2.11.3 divides by the length; section 2.1.1 leaves the result open.
void zeroNormal(const Case& about, Report& report) {
    std::map<std::size_t, std::vector<std::size_t>> found; // by models
    for (const Pass& pass : about.scene.passes) {
        if (!pass.enabled || !readsNormals(pass))
            continue;
        for (const std::size_t m : drawnModels(about.scene, pass)) {
            const Model& model = about.scene.models[m];
            if (model.shape != Shape::Mesh || found.contains(m))
                continue;
            const reference::EyeSpace eye(modelViewMatrix(about.scene.view, model, 0));
            const Mesh mesh = meshOf(model);
            for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
                if (eye(mesh.vertices[v]).normal == glm::vec3(0))
                    found[m].push_back(v);
            }
        }
    }
    for (const auto& [m, vertices] : found) {
        const std::string path =
            fmt::format("{}.{}", elementOf<&Scene::models>(m), pathOf<&Model::mesh, &MeshData::normals>());
        report.add(
            path,
            andMore(Sentence("the normal of vertex {0} has length 0: lighting and generated coordinates "
                             "are undefined in OpenGL",
                             vertices.front()),
                    vertices.size() - 1),
            normalFixes(about.scene, m, path));
    }
}

/// Section 2.11.4: m is 0 where the reflection points straight away from the eye.
void sphereMapRim(const Case& about, Report& report) {
    forEachUnit(about.scene, [&](const Unit& unit, const std::string& path, std::size_t p) {
        if (!generates(unit, {TexGenMode::SphereMap}))
            return;
        for (const std::size_t m : drawnModels(about.scene, about.scene.passes[p])) {
            const Model& model = about.scene.models[m];
            const reference::EyeSpace eye(modelViewMatrix(about.scene.view, model, 0));
            const Mesh mesh = meshOf(model);
            const auto isOnRim = [&](const Vertex& vertex) {
                const glm::vec3 away = reference::reflectionVector(eye(vertex)) + glm::vec3(0, 0, 1);
                return glm::length(away) < 1e-6F; // of two directions of length 1 no more is certain
            };
            const auto first = std::ranges::find_if(mesh.vertices, isOnRim);
            if (first == mesh.vertices.end())
                continue;
            report.add(
                path + keyOf<&Unit::texGenS>(),
                andMore(Sentence("at vertex {0} of models[{1}] the reflection points straight away from "
                                 "the eye and {2} divides by 0: s and t are undefined there",
                                 first - mesh.vertices.begin(), m, named(TexGenMode::SphereMap)),
                        static_cast<std::size_t>(std::count_if(first + 1, mesh.vertices.end(), isOnRim))));
        }
    });
}

/// Of a float's 24 bits dEQP grants the last four of a coordinate to what computes it.
void farCoordinates(const Case& about, Report& report) {
    forEachUnit(about.scene, [&](const Unit& unit, const std::string& path, std::size_t p) {
        const TextureFacts* texture = about.textureOf(unit);
        const TargetFacts* facts = texture ? texture->as(unit.target) : nullptr;
        if (!about.works(unit) || facts->plan.levels.empty() || unit.target == Target::CubeMap)
            return;
        const Pass& pass = about.scene.passes[p];
        const auto index = static_cast<std::size_t>(&unit - pass.units.data());
        const glm::vec3 reach = reference::coordinateReach(about.scene, p, index, 0);
        const PlannedLevel& base = facts->plan.levels.front();
        const glm::vec3 texels = reach * glm::vec3(base.width, base.height, base.depth);
        float most = 0;
        float farthest = 0;
        for (int axis = 0; axis < axesOf(unit.target); ++axis) {
            farthest = texels[axis] > most ? reach[axis] : farthest;
            most = std::max(most, texels[axis]);
        }
        if (most < 0x1p15F) // 1/32 of a texel
            return;
        report.add(unit.matrix.empty() ? path.substr(0, path.size() - 1) : path + keyOf<&Unit::matrix>(),
                   Sentence("coordinates reach {0}, {1} texels from 0, where a float has few bits left for "
                            "fractions of a texel: renderers may be off by {2} of a texel",
                            ProperName{formatNumber(farthest)}, ProperName{formatNumber(std::round(most))},
                            ProperName{formatNumber(std::ceil(most * 0x1p-20F * 100) / 100)}));
    });
}

/// How long a line is in the window, in halves of its extent; none where an end isn't before the eye.
float lengthInView(const glm::vec4& from, const glm::vec4& to) {
    if (!(from.w > 0 && to.w > 0))
        return 0;
    const glm::vec2 difference = glm::abs(glm::vec2(to) / to.w - glm::vec2(from) / from.w);
    return std::max(difference.x, difference.y);
}

/// What Mesa 22.3 draws of them.
void longLines(const Case& about, Report& report) {
    if (!about.driver.renderer.empty() && !about.driver.renderer.starts_with("llvmpipe"))
        return;
    constexpr float longest = 1e6F; // pixels
    constexpr float extent = 128;   // of the smallest picture that shows it
    const glm::mat4 projection = projectionMatrix(about.scene.view, 1);
    for (std::size_t m = 0; m < about.scene.models.size(); ++m) {
        const Model& model = about.scene.models[m];
        if (partCorners(model) != 2 || !isDrawn(about.scene, m))
            continue;
        const Mesh mesh = meshOf(model);
        const glm::mat4 clip = projection * modelViewMatrix(about.scene.view, model, 0);
        const auto at = [&](std::uint32_t vertex) {
            return clip * glm::vec4(mesh.vertices[vertex].position, 1);
        };
        for (std::size_t i = 0; i + 1 < mesh.lines.size(); i += 2) {
            if (!(lengthInView(at(mesh.lines[i]), at(mesh.lines[i + 1])) * extent / 2 > longest))
                continue;
            report.add(
                fmt::format("{}.{}", elementOf<&Scene::models>(m), keyOf<&Model::mesh>()),
                N_("a line is more than a million pixels long: llvmpipe loses pixels at the ends of such lines"));
            break;
        }
    }
}

/// Whether a unit takes s or t, or another coordinate that its target looks at, from the vertices of a model.
bool takesGiven(const Scene& scene, std::size_t model, std::size_t unit) {
    return std::ranges::any_of(scene.passes, [&](const Pass& pass) {
        const std::vector<std::size_t> drawn = drawnModels(scene, pass);
        const Unit& each = pass.units[unit];
        const std::array replaced{each.texGenS.enabled, each.texGenT.enabled, each.texGenR.enabled};
        return each.enabled && std::ranges::find(drawn, model) != drawn.end() &&
               !std::all_of(replaced.begin(), replaced.begin() + coordinatesOf(each.target),
                            [](bool on) { return on; });
    });
}

/// Section 2.7: glVertex takes the current coordinates. Empty: every vertex has its own, or none is read.
Sentence leftOutSentence(const Scene& scene, std::size_t m, std::size_t u) {
    const Model& model = scene.models[m];
    if (model.noTexCoord[u].empty() || !takesGiven(scene, m, u))
        return {};
    const std::vector<SentVertex> sent = sentVertices(model, meshOf(model));
    const std::optional<SentVertex> first = firstWithoutCall(sent, u);
    if (!first)
        return {};
    const auto hasCoords = [u](const SentVertex& each) { return each.coordsOf[u].has_value(); };
    if (std::ranges::none_of(sent, hasCoords))
        return u == 0 ? Sentence(N_("no vertex has a glTexCoord: all show the colour at (0, 0)"))
                      : Sentence("no vertex has coordinates of unit {0}, and all show the colour at (0, 0): "
                                 "glTexCoord sends those of unit 0, also after glActiveTexture",
                                 u);
    const Sentence sentence =
        first->coordsOf[u]
            ? Sentence("vertex {0} has no glTexCoord: it shows the colour at the coordinates of "
                       "vertex {1}, which is sent before it",
                       first->vertex, *first->coordsOf[u])
            : Sentence("vertex {0} has no glTexCoord, and none is sent before it: it shows the "
                       "colour at (0, 0)",
                       first->vertex);
    return andMore(sentence, model.noTexCoord[u].size() - 1);
}

/// Sends them, or has the unit's texture on unit 0, where that is off.
std::vector<Fix> coordFixes(const Scene& scene, const std::string& path, std::size_t u) {
    Fix moved{N_("Use unit 0"), {}};
    bool isFree = u > 0;
    for (std::size_t p = 0; p < scene.passes.size(); ++p) {
        const Pass& pass = scene.passes[p];
        if (!pass.enabled || !pass.units[u].enabled)
            continue;
        isFree = isFree && !pass.units.front().enabled;
        const std::string first = unitPath(p, 0);
        moved.assignments.push_back({first + keyOf<&Unit::texture>(), std::to_string(pass.units[u].texture)});
        moved.assignments.push_back({first + keyOf<&Unit::enabled>(), "true"});
        moved.assignments.push_back({unitPath(p, u) + keyOf<&Unit::enabled>(), "false"});
    }
    std::vector<Fix> fixes{{u == 0 ? N_("Send glTexCoord") : N_("Send glMultiTexCoord"), {{path, ""}}}};
    if (isFree)
        fixes.push_back(std::move(moved));
    return fixes;
}

/// As of an OBJ file without vt.
void meshWithoutCoords(const Case& about, Report& report) {
    for (std::size_t m = 0; m < about.scene.models.size(); ++m) {
        const Model& model = about.scene.models[m];
        if (model.shape != Shape::Mesh || model.mesh.positions.empty() || !model.mesh.texCoords.empty())
            continue;
        Fix fix{N_("Generate s and t"), {}};
        bool reads = false;
        forEachUnit(about.scene, [&](const Unit& unit, const std::string& path, std::size_t p) {
            const auto u = static_cast<std::size_t>(&unit - about.scene.passes[p].units.data());
            if (!unit.enabled || !model.texCoords[u].empty() || !takesGiven(about.scene, m, u))
                return;
            reads = true;
            for (const std::string& key : {keyOf<&Unit::texGenS>(), keyOf<&Unit::texGenT>()}) {
                const std::string own = path + key;
                fix.assignments.push_back(
                    {fmt::format("{}.{}", own, keyOf<&TexGen::mode>()), nameOf(TexGenMode::ObjectLinear)});
                fix.assignments.push_back({fmt::format("{}.{}", own, keyOf<&TexGen::enabled>()), "true"});
            }
        });
        if (reads)
            report.add(fmt::format("{}.{}", elementOf<&Scene::models>(m),
                                   pathOf<&Model::mesh, &MeshData::texCoords>()),
                       N_("the mesh has no texture coordinates: all its vertices show the colour at (0, 0)"),
                       std::move(fix));
    }
}

/// Where it has key frames, their values are drawn, and no single value is a fix.
void noTexCoord(const Case& about, Report& report) {
    for (std::size_t m = 0; m < about.scene.models.size(); ++m) {
        for (std::size_t u = 0; u < maxUnits; ++u) {
            const std::string path = noTexCoordPath(m, u);
            bool moves = false;
            for (const KeyFrame& key : about.scene.timeline.keys) {
                if (key.path != path)
                    continue;
                moves = true;
                const Sentence sentence = leftOutSentence(*StandingScene(about.scene, key.time), m, u);
                if (sentence.empty())
                    continue;
                report.add(path, Sentence("at {0:g} s: {1}", key.time, sentence));
                break;
            }
            if (const Sentence sentence = moves ? Sentence() : leftOutSentence(about.scene, m, u);
                !sentence.empty())
                report.add(path, sentence, coordFixes(about.scene, path, u));
        }
    }
}

constexpr std::array vertexRuleRows{
    Rule{"zero-normal", Severity::Warning, zeroNormal},
    Rule{"no-tex-coord", Severity::Warning, noTexCoord},
    Rule{"no-mesh-coords", Severity::Warning, meshWithoutCoords},
    Rule{"sphere-map-rim", Severity::Warning, sphereMapRim},
    Rule{"far-coordinates", Severity::Note, farCoordinates},
    Rule{"long-line", Severity::Note, longLines},
};

} // namespace

std::span<const Rule> vertexRules() {
    return vertexRuleRows;
}

} // namespace texplorer::diagnosis

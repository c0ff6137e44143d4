// Depth textures, what the light sees, and images that it projects: OpenGL 2.1, section 3.8.14.

#include "texplorer/diagnosis/diagnosis_rules.h"
#include "texplorer/scene/animation.h"
#include "texplorer/scene/drawn_models.h"
#include "texplorer/scene/model_mesh.h"
#include "texplorer/scene/params/param_text.h"
#include "texplorer/scene/texture_matrix.h"

#include <fmt/core.h>
#include <glm/geometric.hpp>

#include <algorithm>

namespace texplorer::diagnosis {
namespace {

struct EyeCoordinate {
    Key key;
    TexGen Unit::*state;
};
constexpr std::array eyeCoordinates{EyeCoordinate{keyOf<&Unit::texGenS>, &Unit::texGenS},
                                    EyeCoordinate{keyOf<&Unit::texGenT>, &Unit::texGenT},
                                    EyeCoordinate{keyOf<&Unit::texGenR>, &Unit::texGenR},
                                    EyeCoordinate{keyOf<&Unit::texGenQ>, &Unit::texGenQ}};

/// The plane that makes one of the four what it is in eye coordinates.
glm::vec4 identityPlane(std::size_t axis) {
    glm::vec4 plane(0);
    plane[static_cast<int>(axis)] = 1;
    return plane;
}

/// Whether a unit's coordinates are eye coordinates, moved at most.
bool hasEyeCoordinates(const Unit& unit) {
    for (std::size_t axis = 0; axis < eyeCoordinates.size(); ++axis) {
        const TexGen& each = unit.*eyeCoordinates[axis].state;
        glm::vec4 plane = each.eyePlane;
        if (axis < 3)
            plane.w = 0;
        if (!each.enabled || each.mode != TexGenMode::EyeLinear || plane != identityPlane(axis))
            return false;
    }
    return true;
}

/// The point that `hasEyeCoordinates` moves them by.
glm::vec3 eyeOffset(const Unit& unit) {
    return {unit.texGenS.eyePlane.w, unit.texGenT.eyePlane.w, unit.texGenR.eyePlane.w};
}

std::string planeText(glm::vec4 plane) {
    std::string text = formatNumber(plane[0]);
    for (int i = 1; i < 4; ++i)
        text += "," + formatNumber(plane[i]);
    return text;
}

/// All four from eye coordinates.
Fix generateEyeCoordinates(const std::string& unit) {
    Fix fix{N_("Generate s, t, r and q in eye coordinates"), {}};
    for (std::size_t axis = 0; axis < eyeCoordinates.size(); ++axis) {
        const std::string own = fmt::format("{}{}.", unit, eyeCoordinates[axis].key());
        fix.assignments.push_back({own + keyOf<&TexGen::mode>(), nameOf(TexGenMode::EyeLinear)});
        fix.assignments.push_back({own + keyOf<&TexGen::eyePlane>(), planeText(identityPlane(axis))});
        fix.assignments.push_back({own + keyOf<&TexGen::enabled>(), "true"});
    }
    return fix;
}

/// The projector step, which comes first to the coordinates.
const MatrixStep* projectorOf(const Unit& unit) {
    return !unit.matrix.empty() && unit.matrix.back().op == MatrixOp::Projector ? &unit.matrix.back()
                                                                                : nullptr;
}

/// The texture of a unit that is on, where it is one of depths.
const Texture* depthTextureOf(const Case& about, const Unit& unit) {
    if (!unit.enabled || !about.textureOf(unit))
        return nullptr;
    const Texture& texture = about.scene.textures[static_cast<std::size_t>(unit.texture)];
    return isDepth(texture.internalFormat) ? &texture : nullptr;
}

std::string texturePath(const Unit& unit) {
    return elementOf<&Scene::textures>(static_cast<std::size_t>(unit.texture)) + ".";
}

void depthTarget(const Case& about, Report& report) {
    forEachUnit(about.scene, [&](const Unit& unit, const std::string& path, std::size_t) {
        if (!depthTextureOf(about, unit) || takesDepths(unit.target))
            return;
        report.add(path + keyOf<&Unit::target>(),
                   Sentence("OpenGL has no depth textures for {0}: drawn without it", named(unit.target)),
                   std::vector{Fix{Sentence("Make it {0}", named(Target::Texture2D)),
                                   {{path + keyOf<&Unit::target>(), nameOf(Target::Texture2D)}}},
                               Fix{Sentence("Make the texture {0}", named(InternalFormat::Luminance)),
                                   {{texturePath(unit) + keyOf<&Texture::internalFormat>(),
                                     nameOf(InternalFormat::Luminance)}}}});
    });
}

void coloredDepths(const Case& about, Report& report) {
    for (std::size_t i = 0; i < about.textures.size(); ++i) {
        const Texture& texture = about.scene.textures[i];
        if (texture.source != SourceKind::LightDepth || isDepth(texture.internalFormat))
            continue;
        const std::string format =
            fmt::format("{}.{}", elementOf<&Scene::textures>(i), keyOf<&Texture::internalFormat>());
        report.add(format,
                   Sentence("{0} keeps depths as greys of 8 bits and cannot compare them",
                            named(texture.internalFormat)),
                   Fix{Sentence("Make it {0}", named(InternalFormat::DepthComponent24)),
                       {{format, nameOf(InternalFormat::DepthComponent24)}}});
    }
}

void depthsAsTheyAre(const Case& about, Report& report) {
    for (std::size_t i = 0; i < about.textures.size(); ++i) {
        const Texture& texture = about.scene.textures[i];
        if (texture.source != SourceKind::LightDepth || !isDepth(texture.internalFormat) ||
            texture.compareMode != CompareMode::None || !about.textures[i].shown)
            continue;
        const std::string mode =
            fmt::format("{}.{}", elementOf<&Scene::textures>(i), keyOf<&Texture::compareMode>());
        report.add(mode, N_("the depths themselves are shown; compare them with r for shadows"),
                   Fix{N_("Compare"), {{mode, nameOf(CompareMode::RToTexture)}}});
    }
}

bool isProjector(const PlacedStep& placed) {
    return placed.step->op == MatrixOp::Projector;
}

/// Whether r comes from the models: those of the meshes are 0.
bool isGivenR(const Scene& scene, std::size_t pass, const Unit& unit) {
    const auto has = [](const glm::vec4& coord) { return coord.p != 0; };
    const auto index = static_cast<std::size_t>(&unit - scene.passes[pass].units.data());
    return unit.texGenR.enabled || hasMatrix(scene, pass, index) ||
           std::ranges::any_of(scene.models, [&](const Model& model) {
               return std::ranges::any_of(
                   model.texCoords, [&](const TexCoords& list) { return std::ranges::any_of(list, has); });
           });
}

void comparesNothing(const Case& about, Report& report) {
    forEachUnit(about.scene, [&](const Unit& unit, const std::string& path, std::size_t p) {
        const Texture* texture = depthTextureOf(about, unit);
        if (!texture || texture->compareMode == CompareMode::None || isGivenR(about.scene, p, unit))
            return;
        report.add(fmt::format("{}{}.{}", path, keyOf<&Unit::texGenR>(), keyOf<&TexGen::enabled>()),
                   N_("r is compared with the texture's depths, but r is 0 everywhere"),
                   generateEyeCoordinates(path));
    });
}

void projectsNothing(const Case& about, Report& report) {
    forEachUnit(about.scene, [&](const Unit& unit, const std::string& path, std::size_t) {
        if (!unit.enabled || !projectorOf(unit) || hasEyeCoordinates(unit))
            return;
        report.add(fmt::format("{}{}.{}", path, elementOf<&Unit::matrix>(unit.matrix.size() - 1),
                               keyOf<&MatrixStep::op>()),
                   Sentence("this step needs eye coordinates: generate s, t, r and q with {0} and the planes "
                            "1,0,0,0 to 0,0,0,1",
                            named(TexGenMode::EyeLinear)),
                   generateEyeCoordinates(path));
    });
}

/// Whether a step before the projector, which comes after it to the coordinates, takes something off r.
bool lowersR(const Unit& unit) {
    return std::ranges::any_of(unit.matrix, [](const MatrixStep& step) {
        return step.op == MatrixOp::Translate && step.amount.z < 0;
    });
}

/// Rounding alone decides whether a surface lies behind itself.
void shadowAcne(const Case& about, Report& report) {
    forEachUnit(about.scene, [&](const Unit& unit, const std::string& path, std::size_t) {
        const Texture* texture = depthTextureOf(about, unit);
        const bool compares = texture && texture->source == SourceKind::LightDepth &&
                              texture->compareMode == CompareMode::RToTexture;
        const bool lessPasses = compares && (texture->compareFunc == CompareFunc::Less ||
                                             texture->compareFunc == CompareFunc::LessEqual);
        if (!lessPasses || !projectorOf(unit) || !hasEyeCoordinates(unit) || lowersR(unit))
            return;
        // The light looks along its own -z: towards it is the view's third row.
        const glm::dmat4 view = lightView(about.scene.light).view;
        const glm::vec3 towards(view[0].z, view[1].z, view[2].z);
        if (glm::dot(eyeOffset(unit), towards) > 0)
            return;
        const Projector& projector = about.scene.light.projector;
        const float by = 0.005F * std::max(projector.nearest, projector.farthest);
        Fix fix{N_("Move the coordinates towards the light"), {}};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            glm::vec4 plane = identityPlane(axis);
            plane.w = by * towards[static_cast<int>(axis)];
            fix.assignments.push_back(
                {fmt::format("{}{}.{}", path, eyeCoordinates[axis].key(), keyOf<&TexGen::eyePlane>()),
                 planeText(plane)});
        }
        const auto translate = std::ranges::find(unit.matrix, MatrixOp::Translate, &MatrixStep::op);
        if (translate != unit.matrix.end())
            fix = {N_("Subtract 0.005 from r"),
                   {{fmt::format(
                         "{}{}.{}", path,
                         elementOf<&Unit::matrix>(static_cast<std::size_t>(translate - unit.matrix.begin())),
                         keyOf<&MatrixStep::amount>()),
                     fmt::format("{},{},-0.005", formatNumber(translate->amount.x),
                                 formatNumber(translate->amount.y))}}};
        report.add(
            fmt::format("{}{}.{}", path, elementOf<&Unit::matrix>(unit.matrix.size() - 1),
                        keyOf<&MatrixStep::op>()),
            N_("surfaces are compared with their own depths, so rounding makes stripes (\"shadow acne\") "
               "unless an earlier step translates r by about -0.005"),
            std::move(fix));
    });
}

template<class Visit> ///< visit(unit, path, pass), of units that are on and have a projector
void forEachProjection(const Case& about, Visit visit) {
    forEachUnit(about.scene, [&](const Unit& unit, const std::string& path, std::size_t pass) {
        const bool has = std::ranges::any_of(
            unit.matrix, [](const MatrixStep& step) { return step.op == MatrixOp::Projector; });
        if (about.works(unit) && has)
            visit(unit, path, about.scene.passes[pass]);
    });
}

/// Where q is below 0, s / q and t / q are what they are on the other side of the light.
void behindTheLight(const Case& about, Report& report) {
    if (about.scene.light.position.w == 0)
        return;
    const LightView light = lightView(about.scene.light);
    forEachProjection(about, [&](const Unit& unit, const std::string& path, const Pass& pass) {
        if (!hasEyeCoordinates(unit))
            return;
        const bool reached = std::ranges::any_of(drawnModels(about.scene, pass), [&](std::size_t m) {
            const Model& model = about.scene.models[m];
            const glm::dmat4 clip =
                light.projection * light.view * glm::dmat4(modelViewMatrix(about.scene.view, model, 0));
            return std::ranges::any_of(meshOf(model).vertices, [&](const Vertex& vertex) {
                const glm::dvec4 at = clip * glm::dvec4(vertex.position, 1);
                return at.w < 0 && std::abs(at.x) < -at.w && std::abs(at.y) < -at.w;
            });
        });
        if (reached)
            report.add(fmt::format("{}{}", path, elementOf<&Unit::matrix>(unit.matrix.size() - 1)),
                       N_("the image also shows behind the light, upside down, where q is below 0"));
    });
}

void lightInItsTarget(const Case& about, Report& report) {
    if (!usesLightView(about.scene))
        return;
    const Light& light = about.scene.light;
    const glm::vec3 place(light.position);
    const bool parallel = light.position.w == 0;
    const glm::vec3 towards = parallel ? place : place / light.position.w - light.projector.target;
    if (glm::length(towards) > 0)
        return;
    const std::string& position = pathOf<&Scene::light, &Light::position>();
    const std::string& target = pathOf<&Scene::light, &Light::projector>();
    if (parallel)
        return report.add(position, N_("a direction of length 0: the projector looks along -z"),
                          Fix{N_("Shine along -z"), {{position, "0,0,1,0"}}});
    glm::vec3 ahead = place / light.position.w;
    ahead.z += ahead.z > -900 ? -5.0F : 5.0F; // within what a parameter may be
    report.add(fmt::format("{}.{}", target, keyOf<&Projector::target>()),
               N_("the light is at its own target: the projector looks along -z"),
               Fix{N_("Look along z"),
                   {{fmt::format("{}.{}", target, keyOf<&Projector::target>()),
                     fmt::format("{},{},{}", formatNumber(ahead.x), formatNumber(ahead.y),
                                 formatNumber(ahead.z))}}});
}

void emptyRange(const Case& about, Report& report) {
    const Projector& projector = about.scene.light.projector;
    if (!usesLightView(about.scene) || projector.nearest < projector.farthest)
        return;
    const std::string path = pathOf<&Scene::light, &Light::projector>() + ".";
    const std::string far = path + keyOf<&Projector::farthest>();
    Fix fix{N_("Make it ten times as far"), {{far, formatNumber(10 * projector.nearest)}}};
    if (projector.farthest < projector.nearest)
        fix = {N_("Exchange them"),
               {{far, formatNumber(projector.nearest)},
                {path + keyOf<&Projector::nearest>(), formatNumber(projector.farthest)}}};
    report.add(far,
               Sentence("the farthest distance, {0}, must be greater than the nearest, {1}: the projector "
                        "ends right behind the nearest",
                        ProperName{formatNumber(projector.farthest)},
                        ProperName{formatNumber(projector.nearest)}),
               std::move(fix));
}

void unusedProjector(const Case& about, Report& report) {
    if (!usesLightView(about.scene))
        report.add(pathOf<&Scene::light, &Light::projector>(),
                   N_("no texture matrix has a projector step, and no texture is a shadow map"));
}

constexpr std::array depthRuleRows{
    Rule{"depth-target", Severity::Error, depthTarget, true},
    Rule{"colored-depths", Severity::Warning, coloredDepths},
    Rule{"compares-nothing", Severity::Warning, comparesNothing},
    Rule{"projects-nothing", Severity::Warning, projectsNothing},
    Rule{"shadow-acne", Severity::Warning, shadowAcne},
    Rule{"light-in-target", Severity::Warning, lightInItsTarget},
    Rule{"light-range", Severity::Warning, emptyRange},
    Rule{"behind-the-light", Severity::Note, behindTheLight},
    Rule{"depths-as-they-are", Severity::Note, depthsAsTheyAre},
    Rule{"projector", Severity::Hint, unusedProjector},
};

} // namespace

bool usesLightView(const Scene& scene) {
    const auto sees = [&](const Unit& unit) {
        const auto texture = static_cast<std::size_t>(unit.texture); // of a negative one: beyond all
        return texture < scene.textures.size() && scene.textures[texture].source == SourceKind::LightDepth;
    };
    for (std::size_t p = 0; p < scene.passes.size(); ++p) {
        for (const std::size_t model : drawnModels(scene, scene.passes[p])) {
            for (std::size_t u = 0; u < maxUnits; ++u) {
                const Unit& unit = scene.passes[p].units[u];
                if (unit.enabled &&
                    (sees(unit) || std::ranges::any_of(textureSteps(scene, p, u, model), isProjector)))
                    return true;
            }
        }
    }
    return false;
}

std::span<const Rule> depthRules() {
    return depthRuleRows;
}

} // namespace texplorer::diagnosis

// GL_LIGHT_MODEL_TWO_SIDE: where it would help, and where there is no back to be seen.

#include "texplorer/diagnosis/color_flow.h"
#include "texplorer/scene/animation.h"
#include "texplorer/scene/drawn_models.h"
#include "texplorer/scene/model_mesh.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>

namespace texplorer::diagnosis {
namespace {

/// Whether light decides the colours of a pass.
bool showsLight(const Case& about, const Pass& pass) {
    return pass.enabled && pass.lighting && primaryInFragments(about, pass).rgb;
}

/// A triangle in eye coordinates, as the camera and the light see it.
struct SeenTriangle {
    bool away;   ///< clockwise in the window
    bool dark;   ///< its normals look away from the light
    bool behind; ///< a corner lies behind the near plane
};

std::vector<SeenTriangle> trianglesOf(const Scene& scene, const Model& model) {
    const glm::mat4 modelView = modelViewMatrix(scene.view, model, 0);
    const glm::mat3 normals = glm::transpose(glm::inverse(glm::mat3(modelView)));
    const bool perspective = scene.view.projection == Projection::Perspective;
    const auto near = static_cast<float>(clipPlanes(scene.view).near);
    const glm::vec4& light = scene.light.position;
    const Mesh mesh = meshOf(model);
    std::vector<SeenTriangle> seen;
    for (std::size_t i = 0; i + 2 < mesh.triangles.size(); i += 3) {
        std::array<glm::vec3, 3> corners;
        glm::vec3 normal(0);
        for (std::size_t c = 0; c < 3; ++c) {
            const Vertex& vertex = mesh.vertices[mesh.triangles[i + c]];
            corners[c] = glm::vec3(modelView * glm::vec4(vertex.position, 1));
            normal += normals * vertex.normal;
        }
        const glm::vec3 middle = (corners[0] + corners[1] + corners[2]) / 3.0F;
        const glm::vec3 across = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
        if (across == glm::vec3(0)) // at the pole of a sphere
            continue;
        const glm::vec3 toEye = perspective ? -middle : glm::vec3(0, 0, 1);
        const glm::vec3 toLight = light.w == 0 ? glm::vec3(light) : glm::vec3(light) / light.w - middle;
        seen.push_back({glm::dot(across, toEye) < 0, glm::dot(normal, toLight) < 0,
                        perspective && std::ranges::any_of(corners, [near](const glm::vec3& corner) {
                            return corner.z > -near;
                        })});
    }
    return seen;
}

/// Whether one looks into a cylinder, which has no lids.
bool isOpenTowardsTheEye(const Scene& scene, const Model& model) {
    const glm::mat4 fromEye = glm::inverse(modelViewMatrix(scene.view, model, 0));
    return scene.view.projection == Projection::Perspective ? std::abs(fromEye[3].y) > 1 : fromEye[2].y != 0;
}

/// Whether the camera sees a dark back of an open shape that light falls on. Of a mesh one can't tell what
/// hides what: there all of it has to be seen from behind.
bool showsDarkBack(const Scene& scene, const Model& model) {
    if (isClosed(model) || partCorners(model) != 3 || glm::determinant(modelMatrix(model, 0)) == 0)
        return false;
    if (model.shape == Shape::Cylinder && !isOpenTowardsTheEye(scene, model))
        return false;
    const std::vector<SeenTriangle> triangles = trianglesOf(scene, model);
    const auto isDarkBack = [](const SeenTriangle& each) { return each.away && each.dark && !each.behind; };
    const auto isAway = [](const SeenTriangle& each) { return each.away; };
    return std::ranges::any_of(triangles, isDarkBack) &&
           (model.shape == Shape::Cylinder || std::ranges::all_of(triangles, isAway));
}

void darkBack(const Case& about, Report& report) {
    const Scene& scene = about.scene;
    if (scene.light.twoSide)
        return;
    for (const Pass& pass : scene.passes) {
        if (!showsLight(about, pass))
            continue;
        for (const std::size_t model : drawnModels(scene, pass)) {
            if (!showsDarkBack(scene, scene.models[model]))
                continue;
            const std::string& path = pathOf<&Scene::light, &Light::twoSide>();
            return report.add(
                path,
                Sentence("the back of {0} is in view but lit with the normals of its front, which look "
                         "away from the light: it stays dark",
                         ProperName{elementOf<&Scene::models>(model)}),
                Fix{N_("Light both sides"), {{path, "true"}}});
        }
    }
}

/// Whether the depth test leaves of closed shapes their fronts alone.
bool hidesBacks(const Pass& pass) {
    return pass.depthTest && !pass.blend && !pass.alphaTest &&
           (pass.depthFunc == CompareFunc::Less || pass.depthFunc == CompareFunc::LessEqual);
}

/// Whether the near plane leaves a closed shape whole.
bool isBeforeTheEye(const Scene& scene, const Model& model) {
    if (scene.view.projection != Projection::Perspective)
        return true;
    const glm::mat4 modelView = modelViewMatrix(scene.view, model, 0);
    const auto near = static_cast<float>(clipPlanes(scene.view).near);
    const float reach = model.shape == Shape::Torus ? 1 + model.tubeRadius : 1; // along each axis at most
    bool boxIsBefore = true;
    for (int corner = 0; corner < 8; ++corner) {
        const auto side = [&](int axis) { return (corner >> axis & 1) != 0 ? reach : -reach; };
        boxIsBefore &= (modelView * glm::vec4(side(0), side(1), side(2), 1)).z <= -near;
    }
    return boxIsBefore || std::ranges::none_of(trianglesOf(scene, model),
                                               [](const SeenTriangle& each) { return each.behind; });
}

/// Whether a model has no back that one could see. A teapot has a spout, into which one looks.
bool hasNoBack(const Scene& scene, const Pass& pass, const Model& model) {
    if (partCorners(model) != 3)
        return true;
    if (!isClosed(model) || model.shape == Shape::Teapot || !hidesBacks(pass) ||
        !(glm::determinant(modelMatrix(model, 0)) > 0))
        return false;
    return isBeforeTheEye(scene, model);
}

void noBack(const Case& about, Report& report) {
    const Scene& scene = about.scene;
    bool lit = false;
    for (const Pass& pass : scene.passes) {
        for (const std::size_t model : drawnModels(scene, pass)) {
            lit |= pass.lighting;
            if (pass.lighting && !hasNoBack(scene, pass, scene.models[model]))
                return;
        }
    }
    if (lit)
        report.add(pathOf<&Scene::light, &Light::twoSide>(),
                   N_("all lit models are closed and seen from outside, or have no sides"));
}

constexpr std::array sideRuleRows{
    Rule{"dark-back", Severity::Warning, darkBack},
    Rule{"two-sides", Severity::Hint, noBack},
};

} // namespace

std::span<const Rule> sideRules() {
    return sideRuleRows;
}

} // namespace texplorer::diagnosis

#include "app/ui/state/camera.h"

#include "texplorer/scene/animation.h"
#include "texplorer/scene/drawn_models.h"
#include "texplorer/scene/model_mesh.h"
#include "texplorer/scene/params/keys.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>

namespace texplorer::ui {
namespace {

constexpr float degreesPerPixel = 0.4F;
constexpr float nearest = 0.2F;
constexpr float farthest = 500;
constexpr float margin = 0.93F; // the share of the view that a fitted scene takes

float halfHeight(const View& view) {
    return std::tan(glm::radians(std::clamp(view.fieldOfView, 1.0F, 170.0F)) / 2);
}

bool counts(const Model& model) {
    return model.shape != Shape::Floor && model.attachment == Attachment::World;
}

template<class Visit>
void forEachCorner(const Scene& scene, double time, Visit visit) {
    for (std::size_t i = 0; i < scene.models.size(); ++i) {
        if (!counts(scene.models[i]) || !isInWindow(scene, i))
            continue;
        Model model = scene.models[i];
        const glm::mat4 matrix = modelMatrix(model, time);
        model.slices = 24; // coarse is enough: a sphere of 24 x 12 touches its bounds closely
        model.stacks = 12;
        const Mesh mesh = meshOf(model);
        for (const Vertex& vertex : mesh.vertices)
            visit(glm::vec3(matrix * glm::vec4(vertex.position, 1)));
    }
}

} // namespace

void orbit(View& view, float dx, float dy) {
    // Beyond a pole the camera hangs upside down: what goes around the axis goes the other way in the
    // picture.
    const float sideways = std::abs(view.elevation) > 90 ? -dx : dx;
    view.azimuth = std::remainder(view.azimuth - sideways * degreesPerPixel, 360.0F);
    view.elevation = std::remainder(view.elevation + dy * degreesPerPixel, 360.0F);
}

void pan(View& view, float dx, float dy, float viewHeight) {
    const float unitsPerPixel = 2 * view.distance * halfHeight(view) / std::max(1.0F, viewHeight);
    const glm::mat3 toWorld = glm::transpose(glm::mat3(viewMatrix(view)));
    const glm::vec3 moved = view.target + toWorld * glm::vec3(-dx, dy, 0) * unitsPerPixel;
    view.target = glm::clamp(moved, -farthest, farthest);
}

void zoom(View& view, float steps) {
    view.distance = std::clamp(view.distance * std::pow(0.9F, steps), nearest, farthest);
}

void frameModels(Scene& scene, double time, float aspect) {
    glm::vec3 low(1e30F);
    glm::vec3 high(-1e30F);
    forEachCorner(scene, time, [&](glm::vec3 corner) {
        low = glm::min(low, corner);
        high = glm::max(high, corner);
    });
    const Range& range = findParam(viewTable(), keyOf<&View::target>())->range;
    if (low.x <= high.x)
        scene.view.target = glm::clamp(low / 2.0F + high / 2.0F, range.min, range.max);
    fitDistance(scene, time, aspect);
}

void fitDistance(Scene& scene, double time, float aspect) {
    View& view = scene.view;
    const glm::mat3 turn(viewMatrix(view));
    const float up = halfHeight(view) * margin;
    const float side = up * std::max(aspect, 0.05F);
    float distance = 0;
    forEachCorner(scene, time, [&](glm::vec3 corner) {
        const glm::vec3 eye = turn * (corner - view.target); // z towards the viewer
        const float nearer = view.projection == Projection::Perspective ? eye.z : 0;
        distance = std::max({distance, std::abs(eye.x) / side + nearer, std::abs(eye.y) / up + nearer});
    });
    if (distance > 0)
        view.distance = std::clamp(distance, nearest, farthest);
}

} // namespace texplorer::ui

#include "texplorer/scene/animation.h"

#include "texplorer/scene/drawn_models.h"
#include "texplorer/scene/texture_matrix.h"

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace texplorer {
namespace {

// Everything is computed in double and rounded once, so that a long time costs no precision.

constexpr glm::dvec3 axisX{1, 0, 0};
constexpr glm::dvec3 axisY{0, 1, 0};
constexpr glm::dvec3 axisZ{0, 0, 1};

/// A right angle must give exact zeros and ones, which glm::rotate misses by the rounding of pi.
glm::dmat4 rotation(double degrees, glm::dvec3 axis) {
    const double turn = std::remainder(degrees, 360.0);
    double sine = std::sin(glm::radians(turn));
    double cosine = std::cos(glm::radians(turn));
    if (std::remainder(turn, 90.0) == 0) {
        sine = std::round(sine);
        cosine = std::round(cosine);
    }
    const double length = glm::length(axis);
    if (length == 0)
        return glm::dmat4(1); // glRotate leaves it undefined; no axis, no rotation
    const glm::dvec3 a = axis / length;
    const glm::dvec3 b = (1 - cosine) * a;
    // glRotate's matrix (OpenGL 2.1, section 2.11.2), column by column.
    return {{b.x * a.x + cosine, b.x * a.y + sine * a.z, b.x * a.z - sine * a.y, 0},
            {b.y * a.x - sine * a.z, b.y * a.y + cosine, b.y * a.z + sine * a.x, 0},
            {b.z * a.x + sine * a.y, b.z * a.y - sine * a.x, b.z * a.z + cosine, 0},
            {0, 0, 0, 1}};
}

glm::dmat4 aboutPivot(const glm::dmat4& matrix, glm::dvec3 pivot) {
    if (pivot == glm::dvec3(0))
        return matrix;
    return glm::translate(glm::dmat4(1), pivot) * matrix * glm::translate(glm::dmat4(1), -pivot);
}

/// From clip coordinates to 0 to 1 times w: what glViewport and glDepthRange do to a picture.
constexpr glm::dmat4 toPicture{{0.5, 0, 0, 0}, {0, 0.5, 0, 0}, {0, 0, 0.5, 0}, {0.5, 0.5, 0.5, 1}};

glm::dmat4 stepMatrix(const MatrixStep& step, double time, const Light& light) {
    const glm::dvec3 amount = glm::dvec3(step.amount) + glm::dvec3(step.rate) * time;
    switch (step.op) {
    case MatrixOp::Translate:
        return glm::translate(glm::dmat4(1), amount);
    case MatrixOp::Rotate:
        return aboutPivot(rotation(double{step.angle} + double{step.angleRate} * time, amount), step.pivot);
    case MatrixOp::Scale:
        return aboutPivot(glm::scale(glm::dmat4(1), amount), step.pivot);
    case MatrixOp::Multiply:
    case MatrixOp::Load:
        return glm::dmat4(step.matrix);
    case MatrixOp::Projector: {
        const LightView seen = lightView(light);
        return toPicture * seen.projection * seen.view;
    }
    }
    return glm::dmat4(1);
}

/// Whether the matrix of a unit that is on does while a pass draws a model.
bool isMatrixMoving(const Scene& scene, const Pass& pass, std::size_t model) {
    const auto index = static_cast<std::size_t>(&pass - scene.passes.data());
    for (std::size_t u = 0; u < maxUnits; ++u) {
        if (pass.units[u].enabled &&
            std::ranges::any_of(textureSteps(scene, index, u, model),
                                [](const PlacedStep& placed) { return isMoving(*placed.step); }))
            return true;
    }
    return false;
}

} // namespace

std::array<int, 3> rotationAxes(RotationOrder order) {
    switch (order) {
    case RotationOrder::Zyx:
        return {2, 1, 0};
    case RotationOrder::Zxy:
        return {2, 0, 1};
    case RotationOrder::Yzx:
        return {1, 2, 0};
    case RotationOrder::Yxz:
        return {1, 0, 2};
    case RotationOrder::Xzy:
        return {0, 2, 1};
    case RotationOrder::Xyz:
        return {0, 1, 2};
    }
    return {2, 1, 0};
}

glm::mat4 textureMatrix(std::span<const MatrixStep> steps, double time, const Light& light) {
    glm::dmat4 product(1);
    for (const MatrixStep& step : steps) {
        const glm::dmat4 matrix = stepMatrix(step, time, light);
        product = step.op == MatrixOp::Load ? matrix : product * matrix;
    }
    return product;
}

bool isMoving(const MatrixStep& step) {
    if (step.op == MatrixOp::Multiply || step.op == MatrixOp::Load || step.op == MatrixOp::Projector)
        return false;
    return step.rate != glm::vec3(0) || (step.op == MatrixOp::Rotate && step.angleRate != 0);
}

LightView lightView(const Light& light) {
    const Projector& projector = light.projector;
    const glm::dvec3 target(projector.target);
    const double nearest = projector.nearest;
    const double farthest = std::max(double{projector.farthest}, nearest * 1.001);
    const double middle = (nearest + farthest) / 2;
    const double slope = std::tan(glm::radians(double{projector.fieldOfView}) / 2);
    const glm::dvec3 place(light.position);
    const bool parallel = light.position.w == 0;

    glm::dvec3 backwards = parallel ? place : place / double{light.position.w} - target;
    const double length = glm::length(backwards);
    backwards = length > 0 ? backwards / length : axisZ;
    const glm::dvec3 eye = target + backwards * (parallel ? middle : length);
    // Upwards is upwards for the eye, too, but for a light above or below its target.
    const bool vertical = std::abs(backwards.y) > 0.999;
    const glm::dvec3 right = glm::normalize(glm::cross(vertical ? -axisZ : axisY, backwards));
    const glm::dvec3 up = glm::cross(backwards, right);

    const glm::dmat4 turn = glm::transpose(glm::dmat4{{right, 0}, {up, 0}, {backwards, 0}, {0, 0, 0, 1}});
    const double extent = slope * (parallel ? middle : nearest);
    return {glm::translate(turn, -eye),
            parallel ? glm::ortho(-extent, extent, -extent, extent, nearest, farthest)
                     : glm::frustum(-extent, extent, -extent, extent, nearest, farthest),
            extent, nearest, farthest};
}

glm::mat4 modelMatrix(const Model& model, double time) {
    constexpr std::array directions{axisX, axisY, axisZ};
    const glm::dvec3 angles = glm::dvec3(model.rotation) + glm::dvec3(model.spin) * time;
    glm::dmat4 matrix = glm::translate(glm::dmat4(1), glm::dvec3(model.position));
    for (const int axis : rotationAxes(model.rotationOrder))
        matrix *= rotation(angles[axis], directions[static_cast<std::size_t>(axis)]);
    return glm::scale(matrix, glm::dvec3(model.scale) * double{model.size});
}

glm::mat4 viewMatrix(const View& view) {
    return glm::translate(glm::dmat4(1), {0, 0, -double{view.distance}}) *
           rotation(double{view.roll}, axisZ) * rotation(double{view.elevation}, axisX) *
           rotation(-double{view.azimuth}, axisY) * glm::translate(glm::dmat4(1), -glm::dvec3(view.target));
}

glm::mat4 modelViewMatrix(const View& view, const Model& model, double time) {
    const glm::mat4 placed = modelMatrix(model, time);
    return model.attachment == Attachment::Eye ? placed : viewMatrix(view) * placed;
}

ClipPlanes clipPlanes(const View& view) {
    const double distance = double{view.distance};
    return {distance / 50, 4 * distance + 400}; // the far end of a floor stays in sight when one zooms in
}

double halfHeightAtTarget(const View& view) {
    return double{view.distance} * std::tan(glm::radians(double{view.fieldOfView}) / 2);
}

glm::mat4 projectionMatrix(const View& view, float aspect) {
    const auto [near, far] = clipPlanes(view);
    if (view.projection == Projection::Perspective) {
        const double height = near * std::tan(glm::radians(double{view.fieldOfView}) / 2);
        const double width = height * double{aspect};
        return glm::frustum(-width, width, -height, height, near, far);
    }
    // What is behind the camera is in sight too: in a parallel projection the camera has no place.
    const double height = halfHeightAtTarget(view);
    const double width = height * double{aspect};
    return glm::ortho(-width, width, -height, height, -far, far);
}

bool isAnimated(const Scene& scene) {
    if (isMoving(scene.timeline))
        return true;
    return std::ranges::any_of(scene.passes, [&](const Pass& pass) {
        return std::ranges::any_of(drawnModels(scene, pass), [&](std::size_t model) {
            return scene.models[model].spin != glm::vec3(0) || isMatrixMoving(scene, pass, model);
        });
    });
}

} // namespace texplorer

#pragma once

#include "core/scene/scene.h"

#include <glm/mat4x4.hpp>

#include <array>
#include <span>

namespace texplorer {

// What depends on the scene time, in seconds, but for what has key frames: these functions are given the
// scene as it stands then (sceneAt). The same inputs give the same matrices in every renderer.

/// GL_TEXTURE matrix: the product of the steps in order, each at amount + rate * time (OpenGL 2.1,
/// section 2.11.2). A step that loads a matrix makes those before it void.
/// `light` gives what MatrixOp::Projector multiplies by.
[[nodiscard]] glm::mat4 textureMatrix(std::span<const MatrixStep> steps, double time, const Light& light);

/// What the light sees: its modelview matrix, which starts from eye coordinates, and its projection, whose
/// picture is square. Both are finite whatever the light is: one in its target looks along -z.
struct LightView {
    glm::dmat4 view;
    glm::dmat4 projection;
    double extent; ///< from the middle of its picture to a side: what glOrtho and glFrustum take
    double nearest;
    double farthest;
};
[[nodiscard]] LightView lightView(const Light& light);

/// translate(position) * the three rotations in the model's order * scale(size * scale), angles at
/// rotation + spin * time.
[[nodiscard]] glm::mat4 modelMatrix(const Model& model, double time);

/// The axes of its rotations, 0 to 2 for x to z, as glRotate is called: the last one turns the model first.
[[nodiscard]] std::array<int, 3> rotationAxes(RotationOrder order);

[[nodiscard]] glm::mat4 viewMatrix(const View& view);

/// GL_MODELVIEW of a model: view * model, or the model's alone where it is attached to the eye.
[[nodiscard]] glm::mat4 modelViewMatrix(const View& view, const Model& model, double time);

/// How far away the near and the far plane are: they follow the distance. An orthographic view reaches from
/// -far to far.
struct ClipPlanes {
    double near;
    double far;
};
[[nodiscard]] ClipPlanes clipPlanes(const View& view);

/// Half of what a view shows of the plane through its target, from the middle to the top.
[[nodiscard]] double halfHeightAtTarget(const View& view);

/// `aspect` is width / height of the viewport.
[[nodiscard]] glm::mat4 projectionMatrix(const View& view, float aspect);

/// Whether anything in the scene changes with time, key frames among them.
[[nodiscard]] bool isAnimated(const Scene& scene);

} // namespace texplorer

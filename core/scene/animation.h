#pragma once

#include "texplorer/scene/scene.h"

#include <glm/mat4x4.hpp>

#include <array>
#include <span>

namespace texplorer {

// Functions of the scene time, in seconds, except for key frames: the scene must already be evaluated at that
// time (sceneAt). Equal inputs give equal matrices in every renderer.

/// The product of steps of a texture matrix in order, each at amount + rate * time (OpenGL 2.1,
/// section 2.11.2). A step that loads a matrix discards those before it. `light` defines the matrix of
/// MatrixOp::Projector.
[[nodiscard]] glm::mat4 textureMatrix(std::span<const MatrixStep> steps, double time, const Light& light);

/// Whether the matrix of a step changes with time.
[[nodiscard]] bool isMoving(const MatrixStep& step);

/// The light's view: its modelview matrix, which starts from eye coordinates, and its projection, whose
/// picture is square. Both are finite for any light: one at its target looks along -z.
struct LightView {
    glm::dmat4 view;
    glm::dmat4 projection;
    double extent; ///< from the centre of its picture to a side, as for glOrtho and glFrustum
    double nearest;
    double farthest;
};
[[nodiscard]] LightView lightView(const Light& light);

/// translate(position) * the three rotations in the model's order * scale(size * scale), angles at
/// rotation + spin * time.
[[nodiscard]] glm::mat4 modelMatrix(const Model& model, double time);

/// The axes of its rotations, 0 to 2 for x to z, in the order of the glRotate calls: the last one is applied
/// first.
[[nodiscard]] std::array<int, 3> rotationAxes(RotationOrder order);

[[nodiscard]] glm::mat4 viewMatrix(const View& view);

/// The GL_MODELVIEW matrix of a model: view * model, or the model's alone if it is attached to the eye.
[[nodiscard]] glm::mat4 modelViewMatrix(const View& view, const Model& model, double time);

/// The distances of the near and the far plane, which depend on the camera's distance. An orthographic view
/// ranges from -far to far.
struct ClipPlanes {
    double near;
    double far;
};
[[nodiscard]] ClipPlanes clipPlanes(const View& view);

/// Half the visible height in the plane through the view's target.
[[nodiscard]] double halfHeightAtTarget(const View& view);

/// `aspect` is width / height of the viewport.
[[nodiscard]] glm::mat4 projectionMatrix(const View& view, float aspect);

/// Whether anything in the scene changes with time, including key frames.
[[nodiscard]] bool isAnimated(const Scene& scene);

} // namespace texplorer

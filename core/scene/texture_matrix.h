#pragma once

// The texture matrix stacks: which steps make up the matrix that a unit has when a model is drawn. OpenGL has
// one stack for each unit (OpenGL 2.1, section 2.11.2); in a frame all of them begin with the identity.

#include "texplorer/scene/scene.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace texplorer {

/// A step on a unit's stack, and whose it is.
struct PlacedStep {
    const MatrixStep* step;           ///< in the scene
    std::size_t pass;                 ///< that put it there
    std::optional<std::size_t> model; ///< nullopt: a step of the pass itself
    std::size_t index;                ///< in its list

    bool operator==(const PlacedStep&) const = default;
};
using PlacedSteps = std::vector<PlacedStep>;

/// The steps that multiply a unit's coordinates when a pass draws a model, in the order of the calls: what
/// earlier passes left, the pass's, what earlier models of the pass left, the model's. Those before a Load
/// are not among them, and units that are off leave their stack alone. `model` must be one that the pass
/// draws. The result refers to the scene.
[[nodiscard]] PlacedSteps textureSteps(const Scene& scene, std::size_t pass, std::size_t unit,
                                       std::size_t model);

/// Those that earlier passes of the same picture left on the stack of a unit.
[[nodiscard]] PlacedSteps leftSteps(const Scene& scene, std::size_t pass, std::size_t unit);

/// The same, if the pass goes on from there: none for MatrixStart::Identity.
[[nodiscard]] PlacedSteps inheritedSteps(const Scene& scene, std::size_t pass, std::size_t unit);

/// Adds the steps of a pass, or of a model if there is one, to those on a stack.
void pushSteps(const Scene& scene, std::size_t pass, std::size_t unit, std::optional<std::size_t> model,
               PlacedSteps& stack);

/// The GL_TEXTURE matrix of textureSteps at a time, for which the scene must already be evaluated.
[[nodiscard]] glm::mat4 textureMatrix(const Scene& scene, std::size_t pass, std::size_t unit,
                                      std::size_t model, double time);

/// Whether a model has steps for a unit that the pass has on.
[[nodiscard]] bool hasOwnSteps(const Pass& pass, const Model& model);

/// Whether any model that a pass draws has them.
[[nodiscard]] bool modelsHaveSteps(const Scene& scene, std::size_t pass);

} // namespace texplorer

#pragma once

#include "texplorer/scene/scene.h"

#include <vector>

namespace texplorer {

/// The indices of the models that a pass draws, in its order: those that it names, or all, without invisible
/// ones. Empty if the pass is off.
[[nodiscard]] std::vector<std::size_t> drawnModels(const Scene& scene, const Pass& pass);

/// The name of a model: its own, or its shape's.
[[nodiscard]] std::string nameOf(const Model& model);

/// Whether any pass draws a model.
[[nodiscard]] bool isDrawn(const Scene& scene, std::size_t model);

/// Whether any pass draws a model in the window.
[[nodiscard]] bool isInWindow(const Scene& scene, std::size_t model);

/// Whether a pass draws anything.
[[nodiscard]] bool drawsAnything(const Scene& scene, const Pass& pass);

/// Adds a model to the passes that name their models.
void drawEverywhere(Scene& scene, std::size_t model);

} // namespace texplorer

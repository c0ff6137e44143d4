#pragma once

#include "core/scene/scene.h"

#include <vector>

namespace texplorer {

/// The models that a pass draws, as indices and in its order: those that it names or else all, without the
/// invisible ones. None where the pass is off.
[[nodiscard]] std::vector<std::size_t> drawnModels(const Scene& scene, const Pass& pass);

/// What a model is called: its own name, or its shape's.
[[nodiscard]] std::string nameOf(const Model& model);

/// Whether any pass draws a model.
[[nodiscard]] bool isDrawn(const Scene& scene, std::size_t model);

/// Whether a pass draws anything.
[[nodiscard]] bool drawsAnything(const Scene& scene, const Pass& pass);

/// A model has been removed from the scene, or one with this index will be put in: passes go on naming the
/// same ones. A pass that named the removed one alone is switched off, for naming none it would draw all.
void modelRemoved(Scene& scene, std::size_t index);
void modelInserted(Scene& scene, std::size_t index);
/// Passes that name their models draw this one, too.
void drawEverywhere(Scene& scene, std::size_t model);
/// Two have changed places.
void modelsSwapped(Scene& scene, std::size_t one, std::size_t other);

} // namespace texplorer

#include "texplorer/scene/texture_matrix.h"

#include "texplorer/scene/animation.h"
#include "texplorer/scene/drawn_models.h"

#include <algorithm>

namespace texplorer {
namespace {

/// Adds those of the models that a pass draws before `end` and that leave their steps; nullopt: of all.
void pushLeftSteps(const Scene& scene, std::size_t pass, std::size_t unit, std::optional<std::size_t> end,
                   PlacedSteps& stack) {
    for (const std::size_t model : drawnModels(scene, scene.passes[pass])) {
        if (model == end)
            return;
        if (!scene.models[model].pushMatrix)
            pushSteps(scene, pass, unit, model, stack);
    }
}

} // namespace

void pushSteps(const Scene& scene, std::size_t pass, std::size_t unit, std::optional<std::size_t> model,
               PlacedSteps& stack) {
    const std::vector<MatrixStep>& steps =
        model ? scene.models[*model].units[unit].matrix : scene.passes[pass].units[unit].matrix;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        if (steps[i].op == MatrixOp::Load)
            stack.clear();
        stack.push_back({&steps[i], pass, model, i});
    }
}

PlacedSteps leftSteps(const Scene& scene, std::size_t pass, std::size_t unit) {
    PlacedSteps stack;
    for (std::size_t p = 0; p < pass; ++p) {
        const Unit& state = scene.passes[p].units[unit];
        const bool isOfPicture = scene.passes[p].picture == scene.passes[pass].picture;
        if (!scene.passes[p].enabled || !isOfPicture || !state.enabled ||
            state.matrixStart == MatrixStart::Push)
            continue; // what was pushed is popped; each picture begins with the identity
        if (state.matrixStart == MatrixStart::Identity)
            stack.clear();
        pushSteps(scene, p, unit, std::nullopt, stack);
        pushLeftSteps(scene, p, unit, std::nullopt, stack);
    }
    return stack;
}

PlacedSteps inheritedSteps(const Scene& scene, std::size_t pass, std::size_t unit) {
    return scene.passes[pass].units[unit].matrixStart == MatrixStart::Identity ? PlacedSteps()
                                                                               : leftSteps(scene, pass, unit);
}

PlacedSteps textureSteps(const Scene& scene, std::size_t pass, std::size_t unit, std::size_t model) {
    PlacedSteps stack = inheritedSteps(scene, pass, unit);
    pushSteps(scene, pass, unit, std::nullopt, stack);
    pushLeftSteps(scene, pass, unit, model, stack);
    pushSteps(scene, pass, unit, model, stack);
    return stack;
}

glm::mat4 textureMatrix(const Scene& scene, std::size_t pass, std::size_t unit, std::size_t model,
                        double time) {
    std::vector<MatrixStep> steps;
    for (const PlacedStep& placed : textureSteps(scene, pass, unit, model))
        steps.push_back(*placed.step);
    return textureMatrix(steps, time, scene.light);
}

bool hasOwnSteps(const Pass& pass, const Model& model) {
    for (std::size_t u = 0; u < maxUnits; ++u) {
        if (pass.units[u].enabled && !model.units[u].matrix.empty())
            return true;
    }
    return false;
}

bool modelsHaveSteps(const Scene& scene, std::size_t pass) {
    return std::ranges::any_of(drawnModels(scene, scene.passes[pass]), [&](std::size_t model) {
        return hasOwnSteps(scene.passes[pass], scene.models[model]);
    });
}

} // namespace texplorer

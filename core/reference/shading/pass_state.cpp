#include "texplorer/reference/shading/pass_state.h"

#include "texplorer/reference/shading/coordinates.h"

#include <glm/common.hpp>

namespace texplorer::reference {

namespace {

UnitState unitState(const Scene& scene, std::size_t passIndex, std::size_t unitIndex,
                    const StoredTexture& stored, double time, const SampleOptions& sampling) {
    const Pass& pass = scene.passes[passIndex];
    const Unit& unit = pass.units[unitIndex];
    UnitState state;
    state.texture = stored.complete ? &stored.sampled : nullptr;
    state.unit = &unit;
    state.envColor = glm::clamp(unit.envColor, 0.0F, 1.0F);
    state.sampling = sampling;
    state.sampling.unitBias = unit.lodBias;
    state.sampling.seamlessCubeMap = pass.seamlessCubeMap;
    if (state.texture)
        state.sampler = FastSampler(*state.texture, state.sampling);
    state.matrices = coordinateMatrices(scene, passIndex, unitIndex, stored.lateFlip, time);
    state.flip = stored.lateFlip;
    return state;
}

} // namespace

std::vector<PassState> passStates(const Scene& scene, const ImageSource& images, double time,
                                  const LevelWork& work, const SampleOptions& sampling, TextureStore& store,
                                  std::vector<Sentence>& problems) {
    std::vector<PassState> states;
    for (std::size_t i = 0; i < scene.passes.size(); ++i) {
        const Pass& pass = scene.passes[i];
        PassState& state = states.emplace_back();
        state.pass = &pass;
        if (!pass.enabled)
            continue;
        state.perspective = scene.view.perspectiveHint != HintMode::Fastest;
        state.flat = scene.material.shadeModel == ShadeModel::Flat;
        state.separateSpecular = pass.lighting && scene.light.colorControl == ColorControl::SeparateSpecular;
        state.fog = pass.fog.enabled ? &pass.fog : nullptr;
        state.twoSided = pass.lighting && scene.light.twoSide;
        for (std::size_t u = 0; u < pass.units.size(); ++u) {
            const Unit& unit = pass.units[u];
            if (!unit.enabled)
                continue;
            if (unit.texture < 0 || static_cast<std::size_t>(unit.texture) >= scene.textures.size()) {
                problems.push_back(Sentence(
                    "passes[{0}].units[{1}]: there is no texture {2}, the scene has {3}; drawn without it", i,
                    u, unit.texture, scene.textures.size()));
                continue;
            }
            const StoredTexture* stored = store.prepare(scene, static_cast<std::size_t>(unit.texture),
                                                        unit.target, images, work, problems);
            if (!stored)
                continue;
            state.units[u] = unitState(scene, i, u, *stored, time, sampling);
            const SampledTexture* texture = state.units[u].texture;
            if (!texture)
                continue;
            state.unitsUsed = static_cast<int>(u) + 1;
            state.steps[state.stepCount++] = {u, environmentCell(unit.envMode, texture->format),
                                              unit.envMode == EnvMode::Combine};
        }
    }
    return states;
}

} // namespace texplorer::reference

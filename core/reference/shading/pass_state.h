#pragma once

// The state of a pass for the reference: evaluated once from a Scene.

#include "texplorer/reference/sampling/fast_sampler.h"
#include "texplorer/reference/sampling/lod.h"
#include "texplorer/reference/sampling/texture_store.h"
#include "texplorer/reference/shading/environment.h"

#include <glm/mat4x4.hpp>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace texplorer::reference {

/// A unit that is used. Its coordinates are matrices[model] * coordinate.
struct UnitState {
    const SampledTexture* texture = nullptr; ///< nullptr: the unit is off, or its texture is incomplete
    const Unit* unit = nullptr;              ///< the unit in the scene
    glm::vec4 envColor{0};                   ///< clamped
    SampleOptions sampling{};
    FastSampler sampler{};             ///< of `texture`, with `sampling`
    std::vector<glm::mat4> matrices{}; ///< for each model of the scene
    LateFlip flip = LateFlip::None;    ///< for Coordinates, t becomes q - t before generation
};

/// What a unit with a texture does to the colour.
struct TextureStep {
    std::size_t unit = 0;
    EnvCell cell{}; ///< undefined for COMBINE
    bool combines = false;
};

struct PassState {
    const Pass* pass = nullptr;
    std::array<UnitState, maxUnits> units{};
    int unitsUsed = 0; ///< one more than the last unit that is used
    std::array<TextureStep, maxUnits> steps{};
    std::size_t stepCount = 0;
    bool flat = false;
    bool perspective = true;       ///< false: GL_PERSPECTIVE_CORRECTION_HINT is GL_FASTEST
    bool separateSpecular = false; ///< the secondary colour is added after texturing (section 3.9)
    const Fog* fog = nullptr;      ///< nullptr: none
    bool twoSided = false;         ///< back faces have colours of their own (section 2.14.1)
};

/// Every pass of the scene; `sampling` has the options common to all units. Sentences about what could not be
/// drawn are added to `problems`.
[[nodiscard]] std::vector<PassState> passStates(const Scene& scene, const ImageSource& images, double time,
                                                const LevelWork& work, const SampleOptions& sampling,
                                                TextureStore& store, std::vector<Sentence>& problems);

} // namespace texplorer::reference

#pragma once

// What is swept: a row for each feature, with the scenes that show it and the rules it is held to.

#include "core/conform/dice.h"
#include "core/conform/rule.h"
#include "core/scene/scene.h"

#include <span>
#include <string_view>

namespace texplorer::conform {

/// Every picture is a square of so many pixels. Flat quads rely on it: see surfaces.h.
inline constexpr int extent = 64;

/// How many scenes share a state. A driver compiles each state that it has not met yet, which takes it far
/// longer than the drawing: so all scenes of a state differ in numbers alone, and follow one another.
inline constexpr int scenesPerState = 4;

/// Of all features together.
inline constexpr int defaultScenes = 3052;

struct Feature {
    std::string_view name;
    std::string_view sweeps;  ///< what its scenes are made of
    std::string_view section; ///< of the OpenGL 2.1 specification
    int scenes;               ///< of defaultScenes
    /// The scene of a state: everything that is an enumerant comes from its number and from `state`,
    /// everything that is a number from `values`.
    Scene (*scene)(int number, Dice& state, Dice& values);
    const Rule& reference; ///< the reference against one of OpenGL's renderers
    const Rule& shader;    ///< OpenGL's two renderers against each other
};

/// In the order in which they are drawn and reported.
[[nodiscard]] std::span<const Feature> features();

/// nullptr: there is none of this name.
[[nodiscard]] const Feature* findFeature(std::string_view name);

} // namespace texplorer::conform

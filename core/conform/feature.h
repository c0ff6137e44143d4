#pragma once

// The features that are swept: a row for each, with its scenes and the rules that apply.

#include "texplorer/conform/dice.h"
#include "texplorer/conform/rule.h"
#include "texplorer/scene/scene.h"

#include <span>
#include <string_view>

namespace texplorer::conform {

/// Every picture is a square of so many pixels. Flat quads rely on it: see surfaces.h.
inline constexpr int extent = 64;

/// The number of scenes that share a state. A driver compiles each new state, which takes far longer than
/// drawing; so all scenes of a state differ in numbers only and are drawn one after the other.
inline constexpr int scenesPerState = 4;

/// Of all features together.
inline constexpr int defaultScenes = 3508;

struct Feature {
    std::string_view name;
    std::string_view sweeps;  ///< how its scenes vary
    std::string_view section; ///< of the OpenGL 2.1 specification
    int scenes;               ///< its part of defaultScenes
    /// Makes the scene of a state: enumerants depend on `number` and `state`, numbers on `values`.
    Scene (*scene)(int number, Dice& state, Dice& values);
    const Rule& reference; ///< for the reference against one of OpenGL's renderers
    const Rule& shader;    ///< for OpenGL's two renderers against each other
};

/// In the order in which they are drawn and reported.
[[nodiscard]] std::span<const Feature> features();

/// Returns nullptr for an unknown name.
[[nodiscard]] const Feature* findFeature(std::string_view name);

} // namespace texplorer::conform

#pragma once

// A scene that nobody would make: a number's throw of the dice for every row of the parameter tables.

#include "core/scene/scene.h"

#include <cstdint>
#include <span>
#include <string>

namespace texplorer::random {

/// How far a scene's numbers go.
enum class Temper : std::uint8_t {
    Comparable, ///< ordinary, and without what the rows of core/conform/skip.h and random_skip.h name
    Ordinary,   ///< about a hundred steps of their row away from where they start
    Mixed,      ///< one of eight as in a wild scene
    Wild, ///< one of two: a limit of its row or next to it, 0, -0, a denormal, anything between the limits
};

struct RandomScene {
    Temper temper = Temper::Ordinary;
    /// Can be kept in a file: every value is within its row, lists of what each vertex has fit their meshes,
    /// and whatever is enabled or named exists. Its textures name some of the files that it was given.
    Scene scene;
};

/// The same for the same seed, number and files, on every machine. Without files all textures are patterns.
[[nodiscard]] RandomScene randomScene(unsigned seed, int number, std::span<const std::string> files);

} // namespace texplorer::random

#pragma once

// A random scene: a pseudo-random value for every row of the parameter tables.

#include "texplorer/scene/scene.h"

#include <cstdint>
#include <span>
#include <string>

namespace texplorer::random {

/// The range of a scene's numbers.
enum class Temper : std::uint8_t {
    Comparable, ///< ordinary, without the features in the rows of core/conform/skip.h and random_skip.h
    Ordinary,   ///< about a hundred steps of their row away from their default
    Mixed,      ///< one value in eight as in a wild scene
    Wild, ///< one value in two: a limit of its row or next to it, 0, -0, a denormal, anything between the
          ///< limits
};

struct RandomScene {
    Temper temper = Temper::Ordinary;
    /// Can be written to a file: every value is within its row, lists of vertex values fit their meshes, and
    /// everything that is enabled or named exists. Its textures name some of the given files.
    Scene scene;
};

/// The result depends only on seed, number and files, on every machine. Without files all textures are
/// patterns.
[[nodiscard]] RandomScene randomScene(unsigned seed, int number, std::span<const std::string> files);

/// Gives each matrix of texture coordinates the last row 0, 0, 0, 1, and no projector: where q runs through
/// 0, the last bits of a number decide which texel is read.
void leaveQ(Scene& scene);

} // namespace texplorer::random

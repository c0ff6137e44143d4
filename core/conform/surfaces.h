#pragma once

// What the scenes of a sweep are put together from.

#include "core/conform/dice.h"
#include "core/scene/scene.h"

#include <array>

namespace texplorer::conform {

/// A texture with few texels: a level of a built-in pattern, so that a scene needs no file.
struct Source {
    Pattern pattern;
    int level; ///< GL_TEXTURE_BASE_LEVEL
    int width; ///< of that level
    int height;
};

/// Colours whose components differ, and alpha between 0 and 1.
inline constexpr std::array coloredSources{
    Source{Pattern::Tree, 4, 16, 16},
    Source{Pattern::Tree, 3, 32, 32},
    Source{Pattern::Marble, 0, 32, 32},
    Source{Pattern::Brick, 4, 16, 16},
};

/// A square seen straight on that covers the picture exactly, without perspective, lighting and texture: the
/// centre of pixel (x, y) is at (x + 0.5) / 32 - 1 and (y + 0.5) / 32 - 1.
[[nodiscard]] Scene flatQuad(Dice& values);

/// The same with unit 0 on: GL_REPLACE with GL_NEAREST, and coordinates from placeTexels().
[[nodiscard]] Scene texturedQuad(const Source& source, Dice& values);

/// Makes textures[index] this source, with GL_NEAREST.
void setSource(Texture& texture, const Source& source);

/// Coordinates of a flat quad such that the centre of every pixel is at least 1/32 of a texel away from the
/// edges of its texel, magnified or minified, inside of the image and outside. Exact in a float.
void placeTexels(Model& quad, std::size_t unit, const Source& source, Dice& values);

/// One of the shapes in perspective, with its texture in unit 0 (GL_REPLACE), whose mip chain is complete.
/// What is seen of it runs from magnified to strongly minified.
[[nodiscard]] Scene surface(Shape shape, Dice& values);

/// Scales, shears and moves s and t: for a step of the texture matrix that is given as 16 numbers.
[[nodiscard]] glm::mat4 planeMatrix(Dice& values);

/// Has a light and a material that shine; the pass is lit.
void setLight(Scene& scene, Dice& values);

/// The number-th combination of two or three choices, all in turn.
template<Enumerated E>
[[nodiscard]] E pick(int& number) {
    const std::span<const EnumRow> rows = EnumTable<E>::rows;
    const int count = static_cast<int>(rows.size());
    const auto chosen = static_cast<E>(rows[static_cast<std::size_t>(number % count)].value);
    number /= count;
    return chosen;
}

} // namespace texplorer::conform

#pragma once

// Building blocks of the sweep's scenes.

#include "texplorer/conform/dice.h"
#include "texplorer/scene/scene.h"

#include <array>

namespace texplorer::conform {

/// A texture with few texels: a level of a built-in pattern, so that scenes need no file.
struct Source {
    Pattern pattern;
    int level; ///< GL_TEXTURE_BASE_LEVEL
    int width; ///< of that level
    int height;
};

/// Colours with different components, and alpha between 0 and 1.
inline constexpr std::array coloredSources{
    Source{Pattern::Tree, 4, 16, 16},
    Source{Pattern::Tree, 3, 32, 32},
    Source{Pattern::Marble, 0, 32, 32},
    Source{Pattern::Brick, 4, 16, 16},
};

/// A square that covers the picture exactly, without perspective, lighting and texture: the centre of pixel
/// (x, y) is at (x + 0.5) / 32 - 1 and (y + 0.5) / 32 - 1.
[[nodiscard]] Scene flatQuad(Dice& values);

/// The same with unit 0 enabled: GL_REPLACE with GL_NEAREST, and coordinates from placeTexels().
[[nodiscard]] Scene texturedQuad(const Source& source, Dice& values);

/// Sets the texture to this source, with GL_NEAREST.
void setSource(Texture& texture, const Source& source);

/// Sets coordinates of a flat quad for which the centre of every pixel is at least 1/32 of a texel away from
/// the edges of its texel; magnified or minified, inside and outside of the image. Exact in floats.
void placeTexels(Model& quad, std::size_t unit, const Source& source, Dice& values);

/// One of the shapes in perspective, with a texture in unit 0 (GL_REPLACE) that has a complete mip chain. Its
/// visible part ranges from magnified to strongly minified.
[[nodiscard]] Scene surface(Shape shape, Dice& values);

/// Scales, shears and translates s and t: for a step of the texture matrix given as 16 numbers.
[[nodiscard]] glm::mat4 planeMatrix(Dice& values);

/// Adds a light and a material with highlights, and enables lighting.
void setLight(Scene& scene, Dice& values);

/// The number-th combination of two or three choices; all combinations in turn.
template<Enumerated E>
[[nodiscard]] E pick(int& number) {
    const std::span<const EnumRow> choices = EnumTable<E>::rows;
    const int count = static_cast<int>(choices.size());
    const auto chosen = static_cast<E>(choices[static_cast<std::size_t>(number % count)].value);
    number /= count;
    return chosen;
}

} // namespace texplorer::conform

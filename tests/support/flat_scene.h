#pragma once

// Scenes in which every pixel can be worked out by hand: a square that covers a square viewport exactly, seen
// straight on, without perspective.

#include "texplorer/image/image.h"
#include "texplorer/scene/scene.h"

#include <array>
#include <initializer_list>

namespace texplorer::test {

/// One quad, no lighting, black transparent background, GL's initial values otherwise. Its textures[0] is
/// the file "image" with filter GL_NEAREST, and passes[0].units[0] would use it, but is not enabled.
[[nodiscard]] Scene flatScene();

/// flatScene() with unit 0 on and in mode GL_REPLACE: shows the texture as it is.
[[nodiscard]] Scene texturedScene();

/// The quad's coordinates for one unit: `lowerLeft` and `upperRight` at these corners, s and t straight in
/// between. The same value twice makes every pixel sample at exactly that place.
[[nodiscard]] TexCoords quadCoords(glm::vec4 lowerLeft, glm::vec4 upperRight);
[[nodiscard]] inline TexCoords quadCoords(glm::vec4 everywhere) {
    return quadCoords(everywhere, everywhere);
}

using Texel = std::array<int, 4>; ///< red, green, blue, alpha, 0 to 255

/// An Rgba8 image from its texels, bottom row first.
[[nodiscard]] Image rgbaImage(int width, int height, int depth, std::initializer_list<Texel> texels);

/// One colour.
[[nodiscard]] Image plainImage(int width, int height, Texel texel);

} // namespace texplorer::test

#pragma once

// What OpenGL says that it stores of a texture: glGetTexLevelParameter, glGetTexParameter and proxy textures
// (OpenGL 2.1, sections 3.8.11, 3.8.12 and 6.1.3).

#include "texplorer/base/sentence.h"

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace texplorer::view {

/// The components whose bits OpenGL counts.
inline constexpr std::array<std::string_view, 7> storedComponents{"red",       "green",     "blue", "alpha",
                                                                  "luminance", "intensity", "depth"};

struct StoredLevel {
    int number = 0;
    int width = 0; ///< with the border, like the other extents
    int height = 1;
    int depth = 1;
    int border = 0;
    std::string internalFormat; ///< its name, or its number if Texplorer has no name for it: "0x8C70"
    std::array<int, storedComponents.size()> bits{};
    std::size_t bytes = 0; ///< of a compressed level; of others OpenGL does not say it
};

struct StoredTexture {
    std::vector<StoredLevel> levels; ///< ascending; of a cube map those of the first face
    bool resident = false;           ///< GL_TEXTURE_RESIDENT
    float priority = 1;              ///< GL_TEXTURE_PRIORITY
    /// The longest side, a power of two, of a line, square or cube that fits by the proxy texture of the
    /// target in the base level's internal format.
    int largest = 0;
};

/// "R8 G8 B8 A8": the components that have bits.
[[nodiscard]] std::string bitsText(const StoredLevel& level);

/// "GL_RGBA8, R8 G8 B8 A8"; of a compressed level its bytes.
[[nodiscard]] Sentence storedText(const StoredLevel& level);

} // namespace texplorer::view

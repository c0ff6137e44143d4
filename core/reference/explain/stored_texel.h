#pragma once

#include "core/gl/internal_format.h"

#include <glm/vec4.hpp>

#include <array>
#include <optional>
#include <string>

namespace texplorer::reference {

/// What a texel is in the texture's memory, where its numbers aren't 255ths of what the filter gets.
struct StoredTexel {
    std::array<int, 4> numbers{}; ///< of red, green, blue and alpha
    std::array<int, 4> largest{}; ///< what each of them is of; 0: the format doesn't keep the component
};

/// What was stored for a texture source colour; nothing for formats whose numbers are 255ths, and for depths.
[[nodiscard]] std::optional<StoredTexel> storedTexel(InternalFormat format, glm::vec4 color);

/// What became of the numbers before the filter, as a sentence; empty where storedTexel gives nothing.
[[nodiscard]] std::string storedSentence(InternalFormat format);

} // namespace texplorer::reference

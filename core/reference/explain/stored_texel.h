#pragma once

#include "texplorer/base/sentence.h"
#include "texplorer/gl/internal_format.h"

#include <glm/vec4.hpp>

#include <array>
#include <optional>
#include <string>

namespace texplorer::reference {

/// A texel as stored, for formats whose numbers are not 255ths.
struct StoredTexel {
    std::array<int, 4> numbers{}; ///< of red, green, blue and alpha
    std::array<int, 4> max{};     ///< the largest number of each; 0: the format lacks the component
};

/// Returns what was stored for a texture source colour; empty for formats whose numbers are 255ths, and for
/// depths.
[[nodiscard]] std::optional<StoredTexel> storedTexel(InternalFormat format, glm::vec4 color);

/// How the stored numbers are converted before filtering, as a sentence; empty where storedTexel is.
[[nodiscard]] Sentence storedSentence(InternalFormat format);

} // namespace texplorer::reference

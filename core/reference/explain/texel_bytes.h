#pragma once

#include "texplorer/base/sentence.h"
#include "texplorer/reference/sampling/sample_record.h"
#include "texplorer/texture/texture_levels.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace texplorer::reference {

/// The bytes of a program's memory that OpenGL reads as a texel.
struct TexelBytes {
    ByteRange range;
    std::vector<std::uint8_t> values{}; ///< those in the memory; the others, beyond its end, count as 0
    std::string holds{};                ///< their components, "bgr"; '-': between rows; 'p': a packed pixel
    std::string readAs{};               ///< "rgb"
};

/// Empty for texels that were not read from memory: of the border colour, or of levels that the driver or GLU
/// made.
[[nodiscard]] std::optional<TexelBytes> texelBytes(const TextureLevels& levels, Target target,
                                                   const Tap& tap);

/// "memory at byte 33–35: 10 80 150, b g r, read as r g b"
[[nodiscard]] Sentence sentenceOf(const TexelBytes& bytes);

} // namespace texplorer::reference

#pragma once

#include "core/reference/sampling/sampled_texture.h"

#include <string>

namespace texplorer::reference {

enum class CompletenessRule : std::uint8_t {
    Complete,
    BaseLevelMissing,  ///< the level that GL_TEXTURE_BASE_LEVEL names does not exist
    BaseAboveMaxLevel, ///< GL_TEXTURE_BASE_LEVEL exceeds GL_TEXTURE_MAX_LEVEL
    LevelMissing,      ///< the minification filter uses mipmaps, and one is not there
    LevelSize,         ///< a level has not half the extents of the one before
    LevelBorder,       ///< a level has another border than the base level
    CubeFaces,         ///< the six faces of a cube map are not squares of one size, or one is missing
};

/// Whether a texture is complete, or which rule it breaks at which level. A texture that is not complete is
/// drawn as if texturing were switched off for its unit.
struct Completeness {
    CompletenessRule rule = CompletenessRule::Complete;
    int level = 0;        ///< where it breaks
    std::string reason{}; ///< a sentence, with what would mend it; empty where it is complete

    [[nodiscard]] bool complete() const { return rule == CompletenessRule::Complete; }
};

/// OpenGL 2.1, section 3.8.10.
[[nodiscard]] Completeness checkCompleteness(const SampledTexture& texture);

} // namespace texplorer::reference

#pragma once

#include "texplorer/base/sentence.h"
#include "texplorer/reference/sampling/sampled_texture.h"

#include <string>

namespace texplorer::reference {

enum class CompletenessRule : std::uint8_t {
    Complete,
    BaseLevelMissing,  ///< the level GL_TEXTURE_BASE_LEVEL does not exist
    BaseAboveMaxLevel, ///< GL_TEXTURE_BASE_LEVEL exceeds GL_TEXTURE_MAX_LEVEL
    LevelMissing,      ///< the minification filter uses mipmaps, and a level is missing
    LevelSize,         ///< the extents of a level are not half of those of the level before
    LevelBorder,       ///< a level's border differs from the base level's
    CubeFaces,         ///< the six faces of a cube map are not squares of one size, or one is missing
};

/// Whether a texture is complete, or which rule it violates at which level. A unit with an incomplete texture
/// is drawn as if texturing were disabled.
struct Completeness {
    CompletenessRule rule = CompletenessRule::Complete;
    int level = 0;     ///< the level of the violation
    Sentence reason{}; ///< a sentence with a way to fix it; empty for a complete texture

    [[nodiscard]] bool complete() const { return rule == CompletenessRule::Complete; }
};

/// OpenGL 2.1, section 3.8.10.
[[nodiscard]] Completeness checkCompleteness(const SampledTexture& texture);

} // namespace texplorer::reference

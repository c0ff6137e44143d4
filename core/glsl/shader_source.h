#pragma once

// What a pass does, written as GLSL 3.30: only what its state uses, and exactly what the shader renderer
// runs. No GL call.

#include "core/base/result.h"
#include "core/glsl/shader_pieces.h"
#include "core/glsl/stage_source.h"
#include "core/scene/scene.h"
#include "core/texture/texture_levels.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace texplorer::glsl {

/// What a shader must know of the texture that a unit samples.
struct SampledUnit {
    BaseFormat format = BaseFormat::Rgba;
    LateFlip lateFlip = LateFlip::None;
    bool hasNegative = false; ///< its format is signed
    bool hasDepths = false;   ///< and no colours: `format` is what they become
    bool compares = false;    ///< r with its depths
    /// Which of s, t and r end at the edge: GL_CLAMP, where OpenGL has no word for it. Of colours alone.
    std::array<bool, 3> ends{};
};

/// None where a unit takes no part: it is off, or its texture is missing or incomplete (section 3.8.10).
using SampledUnits = std::array<std::optional<SampledUnit>, maxUnits>;

/// The two stages of a pass, which must be one of the scene's. Refused: a piece is missing, as it may be
/// while somebody edits the files.
[[nodiscard]] Result<ShaderSource> shaderSource(const Scene& scene, std::size_t pass,
                                                const SampledUnits& units,
                                                const ShaderPieces& pieces = ShaderPieces::embedded());

/// Whether a unit's coordinates go through a texture matrix.
[[nodiscard]] bool hasTextureMatrix(const Unit& unit, const SampledUnit& sampled);

} // namespace texplorer::glsl

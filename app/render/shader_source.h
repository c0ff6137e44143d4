#pragma once

// What a pass does, written as GLSL 3.30: only what its state uses, and exactly what the shader renderer
// runs. No GL call.

#include "app/render/shader_pieces.h"
#include "app/view/pass_shader.h"
#include "core/base/result.h"
#include "core/scene/scene.h"
#include "core/texture/texture_levels.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace texplorer::render {

/// What a shader must know of the texture that a unit samples.
struct SampledUnit {
    BaseFormat format = BaseFormat::Rgba;
    LateFlip lateFlip = LateFlip::None;
    bool hasNegative = false; ///< its format is signed
    bool hasDepths = false;   ///< and no colours: `format` is what they become
    bool compares = false;    ///< r with its depths
};

/// None where a unit takes no part: it is off, or its texture is missing or incomplete (section 3.8.10).
using SampledUnits = std::array<std::optional<SampledUnit>, maxUnits>;

/// The two stages of a pass, which must be one of the scene's. Refused: a piece is missing, as it may be
/// while somebody edits the files.
[[nodiscard]] Result<view::ShaderSource> shaderSource(const Scene& scene, std::size_t pass,
                                                      const SampledUnits& units,
                                                      const ShaderPieces& pieces = ShaderPieces::embedded());

/// Whether a unit's coordinates go through a texture matrix.
[[nodiscard]] bool hasTextureMatrix(const Unit& unit, const SampledUnit& sampled);

} // namespace texplorer::render

#pragma once

// Writes a pass as GLSL 3.30, or as GLSL ES 3.00 for browsers: only what its state uses, and exactly what the
// shader renderer runs. Makes no GL calls.

#include "texplorer/base/result.h"
#include "texplorer/glsl/shader_pieces.h"
#include "texplorer/glsl/stage_source.h"
#include "texplorer/scene/scene.h"
#include "texplorer/texture/texture_levels.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace texplorer::glsl {

enum class Dialect : std::uint8_t {
    Glsl330, ///< OpenGL 3.3
    Es300,   ///< OpenGL ES 3.0 and WebGL 2; each unit needs SampledUnit::sampler
};

/// A sampler that the shader itself is: shaders/sampling.glsl.
struct WrittenSampler {
    std::array<Wrap, 3> wrap{}; ///< of s, t and r
    MagFilter mag = MagFilter::Nearest;
    MinFilter min = MinFilter::Nearest;
    bool isAnisotropic = false;
    bool hasBorder = false;   ///< texels around each level, not a border colour
    bool isSeamless = false;  ///< a cube map
    CompareFunc compare = {}; ///< if the unit compares

    bool operator==(const WrittenSampler&) const = default;
};

/// The texels of a written sampler: in a row of their list, and of how many levels it knows the place.
inline constexpr int texelsPerRow = 4096;
inline constexpr int maxListedLevels = 16;

/// What a shader must know about a unit's texture.
struct SampledUnit {
    BaseFormat format = BaseFormat::Rgba;
    LateFlip lateFlip = LateFlip::None;
    bool isUnclamped = false; ///< its texels may lie outside 0 … 1
    bool hasDepths = false;   ///< instead of colours; `format` is what they become
    bool compares = false;    ///< compares r with its depths
    /// Which of s, t and r are clamped by GL_CLAMP, which core OpenGL lacks. For colours only.
    std::array<bool, 3> ends{};
    std::optional<WrittenSampler> sampler{}; ///< nothing: OpenGL's

    bool operator==(const SampledUnit&) const = default;
};

/// Empty for a unit that does nothing: it is off, or its texture is missing or incomplete (section 3.8.10).
using SampledUnits = std::array<std::optional<SampledUnit>, maxUnits>;

/// The two stages of a pass, which must be one of the scene's. Error: a piece is missing, which can happen
/// while the files are edited.
[[nodiscard]] Result<ShaderSource> shaderSource(const Scene& scene, std::size_t pass,
                                                const SampledUnits& units,
                                                const ShaderPieces& pieces = ShaderPieces::embedded(),
                                                Dialect dialect = Dialect::Glsl330);

/// Whether a unit's coordinates are transformed by a texture matrix, whichever model the pass draws.
[[nodiscard]] bool hasTextureMatrix(const Scene& scene, std::size_t pass, std::size_t unit,
                                    const SampledUnit& sampled);

} // namespace texplorer::glsl

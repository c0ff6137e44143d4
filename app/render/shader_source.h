#pragma once

// What a pass does, written as GLSL 3.30: only what its state uses, and exactly what the shader renderer
// runs. No GL call.

#include "app/render/shader_pieces.h"
#include "core/base/result.h"
#include "core/scene/scene.h"
#include "core/scene/texture_levels.h"

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
};

/// None where a unit takes no part: it is off, or its texture is missing or incomplete (section 3.8.10).
using SampledUnits = std::array<std::optional<SampledUnit>, maxUnits>;

/// Where a line of a source was written.
struct SourceLine {
    std::string file; ///< "lighting.glsl"
    int line = 0;     ///< counted from 1
};

struct StageSource {
    std::string text;
    std::vector<SourceLine> lines; ///< one for each line of the text
};

struct ShaderSource {
    StageSource vertex;
    StageSource fragment;
};

/// The two stages of a pass, which must be one of the scene's. Refused: a piece is missing, as it may be
/// while somebody edits the files.
[[nodiscard]] Result<ShaderSource> shaderSource(const Scene& scene, std::size_t pass,
                                                const SampledUnits& units,
                                                const ShaderPieces& pieces = ShaderPieces::embedded());

/// Whether a unit's coordinates go through a texture matrix.
[[nodiscard]] bool hasTextureMatrix(const Unit& unit, const SampledUnit& sampled);

enum class ShaderStage { Vertex, Fragment };

/// What the driver's compiler, or whoever put the source together, has against it.
struct ShaderMessage {
    std::optional<ShaderStage> stage; ///< none: both, or the files
    int line = 0;                     ///< of the stage's source, counted from 1; 0: none is named
    std::string sentence;             ///< with the place in the files: "lighting.glsl:12: …"

    bool operator==(const ShaderMessage&) const = default;
};

/// A driver's compile log with the files' names and lines in the place of the source's: "lighting.glsl:12:
/// 'eyeNorml' undeclared". A line that names no place stays as it is.
[[nodiscard]] std::vector<ShaderMessage> translateLog(std::string_view log, const StageSource& source,
                                                      std::optional<ShaderStage> stage = std::nullopt);

/// The shaders of a pass as the shader renderer has them.
struct PassShader {
    ShaderSource source;
    /// Empty: the source is what runs. Else it is the newest one, and what ran before it still does.
    std::vector<ShaderMessage> log;
};

} // namespace texplorer::render

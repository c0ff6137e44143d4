#pragma once

#include "texplorer/emit/emission.h"
#include "texplorer/glsl/shader_source.h"

#include <array>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace texplorer::emit {

/// A pass that draws something, with its shaders.
struct GlslPass {
    std::size_t index;
    std::string program;  ///< the variable
    std::string variable; ///< what others begin with; nothing where there is only one
    glsl::SampledUnits units;
    glsl::ShaderSource source;
    std::set<std::string, std::less<>> uniforms; ///< that the shaders declare
};

/// What a unit's coordinates are, where they come from the vertices.
enum class CoordForm : std::uint8_t { Off, AsGiven, Flipped, Embossed };

/// A vertex array object: a model with the coordinates that a pass asks for.
struct VertexArray {
    std::size_t model;
    std::array<CoordForm, maxUnits> coords{};
    std::string name; ///< the variable
};

struct GlslEmission {
    Emission& emission;
    std::vector<GlslPass> passes;
    std::vector<VertexArray> arrays;
    bool hasModelMatrix = false; ///< the variable is declared

    /// Which of the arrays a pass draws a model with.
    [[nodiscard]] const VertexArray& arrayOf(const GlslPass& pass, std::size_t model) const;
    /// Whether any shader declares it.
    [[nodiscard]] bool hasUniform(std::string_view name) const;
};

/// What a pass asks for.
[[nodiscard]] std::array<CoordForm, maxUnits> coordFormsOf(const Emission& emission, const GlslPass& pass);
/// Fills in the uniforms that its shaders declare.
void findUniforms(GlslPass& pass);

/// Vertices, indices and names of the vertex arrays of a model.
void writeGlslModelData(GlslEmission& glsl, std::size_t model);
/// Puts them into buffers, once.
void writeGlslModelSetup(GlslEmission& glsl, std::size_t model);
/// Places it, and draws it.
void writeGlslModel(GlslEmission& glsl, const GlslPass& pass, std::size_t model);

/// The shaders as C strings.
void writeShaders(GlslEmission& glsl, const GlslPass& pass);
/// Compiles them, and sets what no frame changes.
void writeGlslPassSetup(GlslEmission& glsl, const GlslPass& pass);
/// Light, materials, fog and units, as far as they are the same for all models.
void writeGlslUniforms(GlslEmission& glsl, const GlslPass& pass);
/// Depth test, blending, textures: what is the same for all models.
void writeGlslPassState(GlslEmission& glsl, const GlslPass& pass);
/// When shaders are given a texture matrix: with what no frame changes, in every frame, or for each model.
enum class MatrixTime : std::uint8_t { Once, Frame, Model };
/// The matrix of a unit, if it is given then. `model`: for which, of those that have another than others.
void writeGlslMatrix(GlslEmission& glsl, const GlslPass& pass, std::size_t unit, MatrixTime time,
                     std::size_t model = 0);
/// The material of a model where others have another; the colour of its vertices.
void writeGlslMaterial(GlslEmission& glsl, const GlslPass& pass, std::size_t model);

/// A shader as a C string: a literal for each of its lines.
void writeStage(CodeWriter& writer, const std::string& name, const std::string& text);

/// Of textures that show what the light sees: shaders, the function that draws it, its call in a frame.
[[nodiscard]] bool hasShadowMaps(const GlslEmission& glsl);
void writeGlslShadowShaders(GlslEmission& glsl);
void writeGlslShadowSetup(GlslEmission& glsl);
void writeGlslShadowMaps(GlslEmission& glsl);
void writeGlslShadowCalls(GlslEmission& glsl);
/// The surface of a model alone, for the light.
void writeGlslShape(GlslEmission& glsl, std::size_t model);

} // namespace texplorer::emit

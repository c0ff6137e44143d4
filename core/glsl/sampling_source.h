#pragma once

#include "texplorer/glsl/shader_source.h"
#include "texplorer/glsl/source_writer.h"

namespace texplorer::glsl {

/// Writes the samplers of all units that have a written one: uniforms and functions, by
/// shaders/sampling.glsl.
void writeSampling(SourceWriter& stage, const Pass& pass, const SampledUnits& units,
                   const ShaderPieces& pieces);

/// Whether a sampler reads different texels for different lambda.
[[nodiscard]] bool needsLevelOfDetail(const WrittenSampler& sampler);

/// The name of an enumerator, by which its piece is found.
template<Enumerated E>
[[nodiscard]] std::string nameOf(E value) {
    return std::string(rowOf(value).name);
}

} // namespace texplorer::glsl

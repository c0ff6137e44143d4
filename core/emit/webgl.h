#pragma once

#include "texplorer/emit/glsl_emission.h"

namespace texplorer::emit {

/// A base64 text as JavaScript has it.
[[nodiscard]] std::string base64Text(ByteView bytes);

void writeWebTexels(Emission& emission, const Holder& holder, std::size_t object);

/// Vertices and indices of a model as typed arrays; their buffers; what a frame does with coordinates that
/// follow the light.
void writeWebModelData(GlslEmission& glsl, std::size_t model);
void writeWebModelSetup(GlslEmission& glsl, std::size_t model);
void writeWebEmboss(GlslEmission& glsl, const GlslPass& pass, std::size_t model,
                    const std::string& modelView);

/// Every `word` of a text.
void replaceAll(std::string& text, std::string_view word, std::string_view with);
/// A line of C as JavaScript: names, numbers, types.
[[nodiscard]] Line asJavaScript(Line line);

/// Whether WebGL 2 can say the scene. Unsupported: what it can't, in one sentence.
[[nodiscard]] Result<void> sayableInWebGl(const GlslEmission& glsl);

/// Whether texels beyond the edge have the border's colour on any axis that a picture has.
[[nodiscard]] bool hasBorder(const Texture& texture, Target target);
/// Whether a shader of a page makes up for WebGL's lack of a border. Unsupported: where not, and that it is
/// so.
[[nodiscard]] Result<void> checkBorder(const Texture& texture, const glsl::SampledUnit& sampled, Wrap wrap,
                                       const std::string& path, const std::string& key);
/// Lookups of a pass that mix the border in.
void writeBorders(const GlslEmission& glsl, GlslPass& pass);

/// GLSL 3.30 as GLSL ES 3.00: a line is a picture of one row, and the shader says how large points are.
void toEs(GlslEmission& glsl);

/// What was written, as a page.
[[nodiscard]] std::vector<Line> webPage(Emission&& emission);

} // namespace texplorer::emit

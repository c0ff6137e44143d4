#pragma once

// The shaders of a pass, for those who show them.

#include "texplorer/base/sentence.h"
#include "texplorer/glsl/stage_source.h"

#include <optional>
#include <string>
#include <vector>

namespace texplorer::view {

enum class ShaderStage { Vertex, Fragment };

/// What the driver's compiler, or the step that put the source together, has against it.
struct ShaderMessage {
    std::optional<ShaderStage> stage; ///< none: both, or the files
    int line = 0;                     ///< of the stage's source, counted from 1; 0: none is named
    Sentence sentence;                ///< with the place in the files: "lighting.glsl:12: …"

    bool operator==(const ShaderMessage&) const = default;
};

/// The shaders of a pass as the shader renderer has them.
struct PassShader {
    glsl::ShaderSource source;
    /// Empty: the source is what runs. Else it is the newest one, and what ran before it still does.
    std::vector<ShaderMessage> log;
};

} // namespace texplorer::view

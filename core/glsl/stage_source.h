#pragma once

#include <string>
#include <vector>

namespace texplorer::glsl {

/// The origin of a line of source.
struct SourceLine {
    std::string file; ///< "lighting.glsl"
    int line = 0;     ///< counted from 1
};

struct StageSource {
    std::string text;
    std::vector<SourceLine> lines; ///< one for each line of the text
};

/// The two stages of a pass.
struct ShaderSource {
    StageSource vertex;
    StageSource fragment;
};

} // namespace texplorer::glsl

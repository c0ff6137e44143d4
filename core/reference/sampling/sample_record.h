#pragma once

#include "core/reference/sampling/cube.h"

#include <optional>
#include <vector>

namespace texplorer::reference {

/// One texel that was read.
struct Tap {
    int level = 0;
    glm::ivec3 index{0}; ///< i, j, k; outside of the level in the border. Of a cube map k is the face
    float weight = 0;    ///< of this reading in the filtered colour
    glm::vec4 color{0};
    bool border = false;
    float depth = 0; ///< of a depth texture: what it holds, whatever became of it
};

/// One coordinate at one level: s, t or r as it came, and where among the level's texels it fell.
struct WrappedCoordinate {
    int level = 0;
    int axis = 0;
    float given = 0;
    float texels = 0;         ///< u, v or w
    Wrap wrap = Wrap::Repeat; ///< the mode that counted: a seamless cube map has its own
};

struct LevelShare {
    int level = 0;
    float weight = 0;
};

/// Everything that led to a sample. The weights of the taps add up to 1 (one texel can be read more than
/// once).
struct SampleRecord {
    Lod lod;
    std::optional<CubePlace> cube; ///< what the direction hits, where the texture is a cube map
    bool seamless = false; ///< the texels beyond the edges of its faces are those of the faces next to them
    std::vector<LevelShare> levels;
    std::vector<glm::vec3> probes; ///< the coordinates of an anisotropic filter's samples; else the one place
    std::vector<WrappedCoordinate> wrapped;
    std::vector<Tap> taps;
    glm::vec4 color{0};
};

} // namespace texplorer::reference

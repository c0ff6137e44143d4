#pragma once

#include "texplorer/reference/sampling/cube.h"

#include <optional>
#include <vector>

namespace texplorer::reference {

/// One texel that was read.
struct Tap {
    int level = 0;
    glm::ivec3 index{0}; ///< i, j, k; outside of the level: border. For a cube map, k is the face
    float weight = 0;    ///< in the filtered colour
    glm::vec4 color{0};
    bool border = false;
    float depth = 0; ///< for a depth texture: the stored depth before comparison
};

/// A coordinate at one level: s, t or r as given, and its position among the level's texels.
struct WrappedCoordinate {
    int level = 0;
    int axis = 0;
    float given = 0;
    float texels = 0;         ///< u, v or w
    Wrap wrap = Wrap::Repeat; ///< the mode that was used: a seamless cube map has its own
};

struct LevelShare {
    int level = 0;
    float weight = 0;
};

/// Everything that was used for a sample. The weights of the taps add up to 1 (a texel can be read more than
/// once).
struct SampleRecord {
    Lod lod;
    std::optional<CubePlace> cube; ///< what the direction hits, for a cube map
    bool seamless = false;         ///< texels beyond the edges of a face are those of adjacent faces
    std::vector<LevelShare> levels;
    std::vector<glm::vec3> probes; ///< the positions of an anisotropic filter's samples; else a single one
    std::vector<WrappedCoordinate> wrapped;
    std::vector<Tap> taps;
    glm::vec4 color{0};
};

} // namespace texplorer::reference

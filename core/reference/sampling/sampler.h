#pragma once

// Texture filtering as written in OpenGL 2.1 (sections 3.8.7 to 3.8.9), for reading; raster/kernel.h does the
// same fast.

#include "texplorer/reference/sampling/sample_record.h"

namespace texplorer::reference {

/// Returns the filtered colour (a texture source colour, table 3.20) at `coords` = (s, t, r), already divided
/// by q. For a cube map they are a direction; filtering stays on the face that it hits, as in OpenGL 2.1,
/// unless the options make it seamless (ARB_seamless_cube_map). An incomplete texture gives opaque black, as
/// in GLSL: see completeness.h.
[[nodiscard]] glm::vec4 sample(const SampledTexture& texture, glm::vec3 coords,
                               const Derivatives& derivatives, const SampleOptions& options = {});

/// The same, with all intermediate values.
[[nodiscard]] SampleRecord explainSample(const SampledTexture& texture, glm::vec3 coords,
                                         const Derivatives& derivatives, const SampleOptions& options = {});

/// A texel of a texture; outside of the level, its border. For a cube map, k is the face.
struct TexelPlace {
    int level = 0;
    glm::ivec3 index{0};

    bool operator==(const TexelPlace&) const = default;
};

/// The weight of one texel in that sample; 0 if it is not read.
[[nodiscard]] float texelWeight(const SampledTexture& texture, glm::vec3 coords,
                                const Derivatives& derivatives, const SampleOptions& options,
                                const TexelPlace& texel);

} // namespace texplorer::reference

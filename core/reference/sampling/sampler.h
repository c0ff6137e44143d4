#pragma once

// The literal text of OpenGL 2.1's texture filtering (sections 3.8.7 to 3.8.9), written to be read;
// raster/kernel.h does the same for a whole picture.

#include "core/reference/sampling/sample_record.h"

namespace texplorer::reference {

/// The filtered colour (a texture source colour, table 3.20) at `coords` = (s, t, r), already divided by q.
/// Of a cube map they are a direction; filtering stays on the face that it hits, as OpenGL 2.1 says, unless
/// the options make it seamless (ARB_seamless_cube_map).
/// A texture without the levels that are needed, an incomplete one, gives opaque black, as in GLSL: see
/// completeness.h.
[[nodiscard]] glm::vec4 sample(const SampledTexture& texture, glm::vec3 coords,
                               const Derivatives& derivatives, const SampleOptions& options = {});

/// The same, with everything that it was made of.
[[nodiscard]] SampleRecord explainSample(const SampledTexture& texture, glm::vec3 coords,
                                         const Derivatives& derivatives, const SampleOptions& options = {});

/// A texel of a texture; outside of the level it stands for the border there. Of a cube map k is the face.
struct TexelPlace {
    int level = 0;
    glm::ivec3 index{0};

    bool operator==(const TexelPlace&) const = default;
};

/// The share that one texel has in the same sample: 0 where it isn't read.
[[nodiscard]] float texelWeight(const SampledTexture& texture, glm::vec3 coords,
                                const Derivatives& derivatives, const SampleOptions& options,
                                const TexelPlace& texel);

} // namespace texplorer::reference

#pragma once

#include "texplorer/gl/depth_texture.h"
#include "texplorer/gl/fragment.h"
#include "texplorer/gl/sampling.h"

#include <glm/vec4.hpp>

namespace texplorer {

/// How a texture object is sampled: the parameters of glTexParameter for filters, wrap modes and comparison
/// (OpenGL 2.1, section 3.8.4, with GL_TEXTURE_MAX_ANISOTROPY_EXT). The initial values are GL's.
struct SamplerState {
    MagFilter magFilter = MagFilter::Linear;
    MinFilter minFilter = MinFilter::NearestMipmapLinear;
    Wrap wrapS = Wrap::Repeat;
    Wrap wrapT = Wrap::Repeat;
    Wrap wrapR = Wrap::Repeat;
    glm::vec4 borderColor{0, 0, 0, 0};
    int baseLevel = 0;
    int maxLevel = 1000;
    float minLod = -1000;
    float maxLod = 1000;
    float lodBias = 0; ///< added to that of the unit
    float maxAnisotropy = 1;
    CompareMode compareMode = CompareMode::None; ///< for depth textures, like the next two
    CompareFunc compareFunc = CompareFunc::LessEqual;
    DepthMode depthMode = DepthMode::Luminance;

    /// For s, t and r: 0 to 2.
    [[nodiscard]] constexpr Wrap wrap(int axis) const {
        return axis == 0 ? wrapS : axis == 1 ? wrapT : wrapR;
    }

    bool operator==(const SamplerState&) const = default;
};

} // namespace texplorer

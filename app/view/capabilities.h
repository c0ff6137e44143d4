#pragma once

#include <string>

namespace texplorer::view {

/// What a driver can do. Asked once; everyone else reads this value.
struct Capabilities {
    std::string vendor;
    std::string renderer; ///< "llvmpipe (LLVM 15.0.6, 256 bits)"
    std::string version;
    int maxTextureSize = 0; ///< texels along one axis
    int max3DTextureSize = 0;
    int maxCubeMapSize = 0;
    int textureUnits = 0;          ///< of the fixed-function pipeline
    float maxAnisotropy = 1;       ///< 1 where GL_EXT_texture_filter_anisotropic is missing
    bool s3tc = false;             ///< DXT1, DXT3, DXT5
    bool rgtc = false;             ///< BC4, BC5
    bool floatTextures = false;    ///< GL_ARB_texture_float
    bool seamlessCubeMaps = false; ///< GL_TEXTURE_CUBE_MAP_SEAMLESS
    bool nonPowerOfTwo = true;     ///< in every OpenGL that Texplorer accepts: since 2.0
    bool shaders = false;          ///< GLSL 3.30, which the shader renderer is written in
    bool textureBorders = false;   ///< a border of texels stays; Mesa takes it away
    std::string pretending{};      ///< what --pretend has taken away: "no-s3tc, units=2"; empty: nothing
};

} // namespace texplorer::view

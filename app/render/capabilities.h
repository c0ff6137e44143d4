#pragma once

#include "core/base/result.h"

#include <string>

namespace texplorer::render {

/// What the current context can do. Asked once; everyone else reads this value.
struct Capabilities {
    std::string vendor;
    std::string renderer; ///< "llvmpipe (LLVM 15.0.6, 256 bits)"
    std::string version;
    int maxTextureSize = 0; ///< texels along one axis
    int max3DTextureSize = 0;
    int maxCubeMapSize = 0;
    int textureUnits = 0;        ///< of the fixed-function pipeline
    float maxAnisotropy = 1;     ///< 1 where GL_EXT_texture_filter_anisotropic is missing
    bool s3tc = false;           ///< DXT1, DXT3, DXT5
    bool rgtc = false;           ///< BC4, BC5
    bool textureBorders = false; ///< a border of texels stays; Mesa takes it away
};

/// Loads the GL entry points of the current context and asks it. An error names what Texplorer needs
/// (OpenGL 2.1 with fixed functions and GL_ARB_framebuffer_object) and what the driver offers.
[[nodiscard]] Result<Capabilities> loadCapabilities();

} // namespace texplorer::render

#pragma once

#include "app/view/capabilities.h"
#include "texplorer/diagnosis/diagnosis.h"

namespace texplorer::view {

/// What the diagnosis wants to know of a driver.
[[nodiscard]] inline DriverFacts driverFacts(const Capabilities& capabilities) {
    DriverFacts facts;
    facts.renderer = capabilities.renderer;
    facts.version = capabilities.version;
    facts.textureUnits = capabilities.textureUnits;
    facts.maxTextureSize = capabilities.maxTextureSize;
    if (capabilities.max3DTextureSize > 0)
        facts.max3DTextureSize = capabilities.max3DTextureSize;
    if (capabilities.maxCubeMapSize > 0)
        facts.maxCubeMapSize = capabilities.maxCubeMapSize;
    facts.maxAnisotropy = capabilities.maxAnisotropy;
    facts.nonPowerOfTwo = capabilities.nonPowerOfTwo;
    facts.s3tc = capabilities.s3tc;
    facts.rgtc = capabilities.rgtc;
    facts.floatTextures = capabilities.floatTextures;
    facts.seamlessCubeMaps = capabilities.seamlessCubeMaps;
    facts.textureBorders = capabilities.textureBorders;
    return facts;
}

} // namespace texplorer::view

#pragma once

#include "texplorer/reference/sampling/lod.h"
#include "texplorer/scene/scene.h"
#include "texplorer/texture/image_source.h"

namespace texplorer::reference {

/// A frame to draw. DrawOptions has the options of the computation.
struct DrawRequest {
    Scene scene;
    ImageSource images{};
    double time = 0; ///< seconds; key frames are evaluated at this time
    int width = 1;   ///< pixels
    int height = 1;
    AnisotropyMethod anisotropy = AnisotropyMethod::Probes;
    RhoMethod rho = RhoMethod::Ideal;
    /// GL_SUBPIXEL_BITS of a driver that computes everything from snapped corners; 0: interpolation is exact,
    /// and edges have 8 bits.
    int cornerBits = 0;
    bool zeroSwitchOver = false; ///< see SampleOptions

    [[nodiscard]] SampleOptions sampling() const {
        return {.anisotropy = anisotropy, .rho = rho, .zeroSwitchOver = zeroSwitchOver};
    }

    bool operator==(const DrawRequest&) const = default;
};

/// Whether both requests can use the same texture levels: the images and the settings that change texels
/// (imageSettings) are equal. Sampling parameters may differ.
[[nodiscard]] bool sameLevels(const DrawRequest& a, const DrawRequest& b);

} // namespace texplorer::reference

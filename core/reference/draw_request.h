#pragma once

#include "core/reference/sampling/lod.h"
#include "core/scene/scene.h"
#include "core/texture/image_source.h"

namespace texplorer::reference {

/// A frame that somebody wants to see. How it is come by is in DrawOptions.
struct DrawRequest {
    Scene scene;
    ImageSource images{};
    double time = 0; ///< seconds; what of the scene has key frames is drawn as it stands then
    int width = 1;   ///< pixels
    int height = 1;
    AnisotropyMethod anisotropy = AnisotropyMethod::Probes;
    RhoMethod rho = RhoMethod::Ideal;
    /// GL_SUBPIXEL_BITS of a driver that computes everything from corners that it has snapped to as many; 0:
    /// what is interpolated is exact, and edges have 8.
    int cornerBits = 0;
    bool zeroSwitchOver = false; ///< see SampleOptions

    [[nodiscard]] SampleOptions sampling() const {
        return {.anisotropy = anisotropy, .rho = rho, .zeroSwitchOver = zeroSwitchOver};
    }

    bool operator==(const DrawRequest&) const = default;
};

/// Whether the levels of one's textures serve the other: the images are the same, and what is made of them
/// (imageSettings). How they are sampled may differ.
[[nodiscard]] bool sameLevels(const DrawRequest& a, const DrawRequest& b);

} // namespace texplorer::reference

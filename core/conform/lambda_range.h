#pragma once

#include "texplorer/conform/renderer.h"
#include "texplorer/reference/draw.h"

#include <array>
#include <vector>

namespace texplorer::conform {

/// The error of lambda that a driver may have if it computes rho by one of the given methods and works like
/// llvmpipe (src/gallium/auxiliary/gallivm of Mesa 22.3). That takes the derivatives of 2 x 2 pixels from
/// three of their corners (softpipe from another three), and log2(rho) as half the log2 of rho^2,
/// approximated from a float's bits as exponent + mantissa - 1, which is at most 0.0861 too small. Both ends
/// are extended by the 6 bits that dEQP allows for lambda (lodBits = 6).
struct LambdaRange {
    float low;  ///< at most 0
    float high; ///< at least 0
};

/// The range of a unit in the fragment that `pixel` explains; `baseSize` is the size of the base level in
/// texels.
[[nodiscard]] LambdaRange lambdaRange(const reference::Explanation& pixel,
                                      const reference::FragmentExplanation& fragment,
                                      const reference::UnitExplanation& unit, glm::vec3 baseSize,
                                      RhoMethods methods);

/// Returns the colours of one pixel at both ends of that range and in between, as the reference draws them.
/// If earlier fragments show through, each fragment has an error of its own; only the last of many fragments
/// are varied, and only some of many colours are returned. The request must use one of the methods. Errors:
/// those of the probe.
[[nodiscard]] Result<std::vector<reference::PixelBytes>>
colorsOverLambda(reference::ReferenceRenderer& renderer, const reference::DrawRequest& request,
                 reference::PixelPlace pixel, RhoMethods methods, const reference::DrawOptions& options);

/// The texels of the base level along s, t and r; (1, 1, 1) without a base level.
[[nodiscard]] glm::vec3 baseSizeOf(const Texture& texture, Target target, const ImageSource& images);

} // namespace texplorer::conform

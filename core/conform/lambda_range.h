#pragma once

#include "core/conform/renderer.h"
#include "core/reference/draw.h"

#include <array>
#include <vector>

namespace texplorer::conform {

/// How far a driver may be off lambda where it computes rho by one of some methods and does what llvmpipe
/// does (src/gallium/auxiliary/gallivm of Mesa 22.3): it takes the derivatives of 2 x 2 pixels from three of
/// their corners (softpipe from another three), and log2(rho) as half the log2 of rho^2, which it reads off a
/// float as exponent + mantissa - 1, at most 0.0861 too little. To both ends are added the 6 bits that dEQP
/// grants lambda (lodBits = 6).
struct LambdaRange {
    float low;  ///< at most 0
    float high; ///< at least 0
};

/// Of a unit in the fragment that a probe has explained; `baseSize` are the texels of the base level.
[[nodiscard]] LambdaRange lambdaRange(const reference::Explanation& pixel,
                                      const reference::FragmentExplanation& fragment,
                                      const reference::UnitExplanation& unit, glm::vec3 baseSize,
                                      RhoMethods methods);

/// The colours of one pixel at both ends of that range and in between, as the reference draws them. Where
/// what was drawn before shows through, each fragment is off by an amount of its own; of many fragments the
/// last ones count, and of many colours some are left out. The
/// request has one of the methods. Errors: those of the probe.
[[nodiscard]] Result<std::vector<reference::PixelBytes>>
colorsOverLambda(reference::ReferenceRenderer& renderer, const reference::DrawRequest& request,
                 reference::PixelPlace pixel, RhoMethods methods, const reference::DrawOptions& options);

/// Texels of the base level along s, t and r; (1, 1, 1) where there is none.
[[nodiscard]] glm::vec3 baseSizeOf(const Texture& texture, Target target, const ImageSource& images);

} // namespace texplorer::conform

#pragma once

// Mip levels for an alpha test: averaging draws alpha towards its mean, so that fewer and fewer texels of
// small shapes pass the test.

#include "texplorer/image/image.h"

namespace texplorer {

/// Returns the share of a picture in which alpha is above a reference, both from 0 to 1: of 4 x 4 points in
/// each texel, interpolated as by GL_LINEAR, with clamped edges. A share of texels would be another one where
/// they are seen enlarged. Of a volume, the slices are looked at one by one. 1 without alpha, if the
/// reference is below 1.
[[nodiscard]] double alphaCoverage(const Image& image, float reference);

/// Scales alpha, clamped and rounded, so that the coverage is as near as possible to `coverage`; found by
/// bisection. Without alpha, the image is unchanged.
[[nodiscard]] Image withCoverage(Image image, float reference, double coverage);

} // namespace texplorer

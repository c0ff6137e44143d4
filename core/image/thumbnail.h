#pragma once

#include "core/image/image.h"

namespace texplorer {

/// A small picture of an image: its first slice, Rgba8, the longer side at most `longest` pixels and none
/// less than 1; an image that is small enough keeps its size. Every texel counts by the area that it covers,
/// colours by their alpha. ALPHA images show as white that fades. An empty image stays empty.
[[nodiscard]] Image thumbnailOf(const Image& image, int longest);

} // namespace texplorer

#pragma once

#include "texplorer/image/image.h"

namespace texplorer {

/// Returns a small copy of an image: its first slice, Rgba8, with the longer side at most `maxExtent` pixels
/// and the shorter at least 1; smaller images keep their size. Texels are weighted by area, colours also by
/// alpha. Alpha images show as transparent white. An empty image stays empty.
[[nodiscard]] Image thumbnailOf(const Image& image, int maxExtent);

} // namespace texplorer

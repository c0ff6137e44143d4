#pragma once

// Texture borders: a ring of one texel around an image, part of the image in OpenGL 2.1 (glTexImage's
// `border`, section 3.8.1). `axes` is the number of axes with a border: 1 for a line, 2 for a picture, 3 for
// a volume. An empty image stays empty.

#include "texplorer/image/mipmaps.h"

namespace texplorer {

/// Whether the extents include a border: each of the axes has 2^k + 2 texels, and not all of them are powers
/// of two.
[[nodiscard]] bool hasBorderExtents(int width, int height, int depth, int axes);
[[nodiscard]] inline bool hasBorderExtents(const Image& image, int axes) {
    return hasBorderExtents(image.width, image.height, image.depth, axes);
}

/// Returns the image with its outermost texels repeated around it.
[[nodiscard]] Image repeatEdges(const Image& image, int axes);

/// Returns the image without its outermost texels.
[[nodiscard]] Image withoutBorder(const Image& image, int axes);

/// Like applyMipPolicy, with a border around every level. If the extents include the border, the outermost
/// texels are the border, and the borders of smaller levels are computed from them alone; else the edges of
/// the image are repeated.
[[nodiscard]] MipChain applyMipPolicyWithBorder(MipPolicy policy, Image base, int axes,
                                                const MipOptions& options = {});

} // namespace texplorer

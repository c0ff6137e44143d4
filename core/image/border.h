#pragma once

// Texture borders: a ring of one texel around an image, which OpenGL 2.1 takes with it (glTexImage's
// `border`, section 3.8.1). `axes` says around how many axes: 1 for a line, 2 for a picture, 3 for a volume.
// An empty image stays empty.

#include "core/image/mipmaps.h"

namespace texplorer {

/// Whether an image can only have been made with its border: each of the axes has 2^k + 2 texels, and not
/// all of them a power of two.
[[nodiscard]] bool hasBorderExtents(int width, int height, int depth, int axes);
[[nodiscard]] inline bool hasBorderExtents(const Image& image, int axes) {
    return hasBorderExtents(image.width, image.height, image.depth, axes);
}

/// The image with its outermost texels once more around it.
[[nodiscard]] Image repeatEdges(const Image& image, int axes);

/// What applyMipPolicy makes of an image, with a border around every level. Where the extents say that the
/// outermost texels are the border they are taken for it, and those of smaller levels are made of them alone;
/// else the image is taken whole and its edges are repeated.
[[nodiscard]] MipChain applyMipPolicyWithBorder(MipPolicy policy, Image base, int axes,
                                                const MipOptions& options = {});

} // namespace texplorer

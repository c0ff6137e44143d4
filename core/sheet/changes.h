#pragma once

#include "texplorer/base/result.h"
#include "texplorer/image/image.h"

#include <cstddef>

namespace texplorer::sheet {

/// The difference of a picture to another one.
struct PictureChanges {
    Image map; ///< each pixel's difference as a colour of texplorer/compare/heat_map.h: black is equal
    std::size_t pixels = 0; ///< number of different pixels

    [[nodiscard]] bool any() const { return pixels > 0; }
};

/// Compares two Rgba8 pictures of one size as they are seen, without alpha. Errors: those of compare().
[[nodiscard]] Result<PictureChanges> changesAgainst(const Image& first, const Image& picture);

} // namespace texplorer::sheet

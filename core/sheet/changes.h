#pragma once

#include "core/base/result.h"
#include "core/image/image.h"

#include <cstddef>

namespace texplorer::sheet {

/// What a picture has that another one hasn't.
struct PictureChanges {
    Image map; ///< each pixel's difference as a colour of core/compare/heat_map.h: black is equal
    std::size_t pixels = 0; ///< that differ

    [[nodiscard]] bool any() const { return pixels > 0; }
};

/// Of two Rgba8 pictures of one size, as one sees them: without alpha. Errors: as of compare().
[[nodiscard]] Result<PictureChanges> changesAgainst(const Image& first, const Image& picture);

} // namespace texplorer::sheet

#pragma once

#include "core/animation/opaque_frame.h"
#include "core/animation/palette.h"

namespace texplorer::animation {

/// A rectangle of a picture by the numbers of its colours, row by row from the top.
struct IndexedPicture {
    FrameRect rect;
    Palette palette;                     ///< at most 256 with the one that stands for nothing
    std::optional<std::uint8_t> nothing; ///< its number: what was there before stays
    std::vector<std::uint8_t> indices;

    [[nodiscard]] const std::uint8_t* row(int y) const {
        return indices.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(rect.width);
    }
};

/// A picture in 256 colours of its own. `before`: the one that is shown then, whose pixels stay where the new
/// ones are the same; nullptr: none is. What is lost of a pixel goes on to its neighbours, to right and left
/// by turns (Floyd and Steinberg, 1976), but not all of it: what has gone far is noise. A picture of no more
/// than 256 colours stays what it is.
[[nodiscard]] IndexedPicture indexed(const OpaqueFrame& now, const OpaqueFrame* before);

} // namespace texplorer::animation

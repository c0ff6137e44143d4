#pragma once

#include "texplorer/animation/opaque_frame.h"
#include "texplorer/animation/palette.h"

namespace texplorer::animation {

/// A rectangle of a picture as palette indices, row by row from the top.
struct IndexedPicture {
    FrameRect rect;
    Palette palette;                     ///< at most 256 colours, including the transparent one
    std::optional<std::uint8_t> nothing; ///< the transparent index: the previous pixel stays
    std::vector<std::uint8_t> indices;

    [[nodiscard]] const std::uint8_t* row(int y) const {
        return indices.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(rect.width);
    }
};

/// Converts a picture to a palette of at most 256 colours, which is made for this picture. `before` is the
/// picture shown until then, or nullptr; pixels that are equal to it become transparent. The error of a pixel
/// is spread to its neighbours, with alternating direction per row (Floyd and Steinberg, 1976), but only in
/// part: error that travels far shows as noise. A picture of at most 256 colours is kept exactly.
[[nodiscard]] IndexedPicture indexed(const OpaqueFrame& now, const OpaqueFrame* before);

} // namespace texplorer::animation

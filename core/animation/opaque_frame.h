#pragma once

#include "core/image/image.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace texplorer::animation {

/// A picture as animations have it: without alpha, its top row first.
struct OpaqueFrame {
    int width = 0;
    int height = 0;
    std::vector<std::uint32_t> pixels; ///< 0xFFRRGGBB

    bool operator==(const OpaqueFrame&) const = default;

    [[nodiscard]] const std::uint32_t* row(int y) const {
        return pixels.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
    }
};

/// Of an Rgba8 or Rgb8 image, whose alpha is passed over.
[[nodiscard]] OpaqueFrame opaqueFrame(const Image& image);

/// Pixels from the top left.
struct FrameRect {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;

    bool operator==(const FrameRect&) const = default;
};

/// The smallest rectangle that holds every pixel in which two pictures of the same size differ; nothing:
/// there is none.
[[nodiscard]] std::optional<FrameRect> changedRect(const OpaqueFrame& before, const OpaqueFrame& now);

} // namespace texplorer::animation

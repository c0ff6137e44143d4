#pragma once

#include "texplorer/image/image.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace texplorer::animation {

/// A picture of an animation: no alpha, top row first.
struct OpaqueFrame {
    int width = 0;
    int height = 0;
    std::vector<std::uint32_t> pixels; ///< 0xFFRRGGBB

    bool operator==(const OpaqueFrame&) const = default;

    [[nodiscard]] const std::uint32_t* row(int y) const {
        return pixels.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
    }
};

/// Converts an Rgba8 or Rgb8 image; alpha is ignored.
[[nodiscard]] OpaqueFrame opaqueFrame(const Image& image);

/// A rectangle of pixels, from the top left.
struct FrameRect {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;

    bool operator==(const FrameRect&) const = default;
};

/// Returns the smallest rectangle that holds every pixel that differs between two pictures of the same size.
/// Empty where they are equal.
[[nodiscard]] std::optional<FrameRect> changedRect(const OpaqueFrame& before, const OpaqueFrame& now);

} // namespace texplorer::animation

#include "texplorer/animation/opaque_frame.h"

#include <algorithm>

namespace texplorer::animation {

OpaqueFrame opaqueFrame(const Image& image) {
    OpaqueFrame frame{image.width, image.height, {}};
    frame.pixels.resize(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
    const auto step = static_cast<std::size_t>(bytesPerPixel(image.format));
    const auto width = static_cast<std::size_t>(image.width);
    std::uint32_t* to = frame.pixels.data();
    for (int y = image.height; y-- > 0; to += width) {
        const auto* from = reinterpret_cast<const std::uint8_t*>(image.at(0, y).data());
        for (std::size_t x = 0; x < width; ++x) {
            const std::uint8_t* pixel = from + x * step;
            to[x] = 0xFF000000U | (std::uint32_t{pixel[0]} << 16U) | (std::uint32_t{pixel[1]} << 8U) |
                    std::uint32_t{pixel[2]};
        }
    }
    return frame;
}

std::optional<FrameRect> changedRect(const OpaqueFrame& before, const OpaqueFrame& now) {
    int left = now.width;
    int right = -1;
    int top = now.height;
    int bottom = -1;
    for (int y = 0; y < now.height; ++y) {
        const std::uint32_t* a = before.row(y);
        const std::uint32_t* b = now.row(y);
        const auto [firstA, firstB] = std::mismatch(a, a + now.width, b);
        if (firstA == a + now.width)
            continue;
        int last = now.width - 1;
        while (a[last] == b[last])
            --last;
        left = std::min(left, static_cast<int>(firstA - a));
        right = std::max(right, last);
        top = std::min(top, y);
        bottom = y;
    }
    if (right < 0)
        return std::nullopt;
    return FrameRect{left, top, right - left + 1, bottom - top + 1};
}

} // namespace texplorer::animation

#pragma once

#include "texplorer/image/image.h"

#include <initializer_list>

namespace texplorer {

/// Rgba8 from grey pixels, bottom row first; their alpha is 255.
[[nodiscard]] inline Image greyPicture(int width, int height, std::initializer_list<int> values) {
    Image image{PixelFormat::Rgba8, width, height, 1, {}};
    for (const int value : values) {
        for (int c = 0; c < 3; ++c)
            image.pixels.push_back(static_cast<std::byte>(value));
        image.pixels.push_back(std::byte{255});
    }
    return image;
}

} // namespace texplorer

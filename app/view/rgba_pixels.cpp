#include "app/view/rgba_pixels.h"

#include "texplorer/reference/sampling/sampled_texture.h"

#include <algorithm>
#include <cmath>

namespace texplorer::view {

Image asRgba8(const Image& image, BaseFormat format) {
    Image pixels = Image::uninitialised(PixelFormat::Rgba8, image.width, image.height);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const glm::vec4 color =
                reference::sourceColor(format, reference::pixelColor(image.format, image.at(x, y).data()));
            for (int i = 0; i < 4; ++i)
                pixels.at(x, y)[static_cast<std::size_t>(i)] =
                    static_cast<std::byte>(std::lround(std::clamp(color[i], 0.0F, 1.0F) * 255));
        }
    }
    return pixels;
}

} // namespace texplorer::view

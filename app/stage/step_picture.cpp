#include "app/stage/step_picture.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace texplorer::stage {
namespace {

constexpr int looks = 4; // samples along each side of a pixel of the small picture

/// The middle of the n-th of `count` equal parts.
int middleOf(int part, int count, int length) {
    return static_cast<int>((2LL * part + 1) * length / (2LL * count));
}

} // namespace

Image stepPicture(const Image& picture) {
    if (picture.empty() || picture.format != PixelFormat::Rgba8)
        return {};
    const float scale =
        std::min({1.0F, static_cast<float>(stepPictureSize.width) / static_cast<float>(picture.width),
                  static_cast<float>(stepPictureSize.height) / static_cast<float>(picture.height)});
    const auto shorter = [scale](int length) {
        return std::max(1, static_cast<int>(std::lround(static_cast<float>(length) * scale)));
    };
    Image small = Image::uninitialised(PixelFormat::Rgba8, shorter(picture.width), shorter(picture.height));
    for (int y = 0; y < small.height; ++y) {
        for (int x = 0; x < small.width; ++x) {
            std::array<int, 3> sum{};
            for (int look = 0; look < looks * looks; ++look) {
                const ByteView from =
                    picture.at(middleOf(x * looks + look % looks, small.width * looks, picture.width),
                               middleOf(y * looks + look / looks, small.height * looks, picture.height));
                for (std::size_t i = 0; i < sum.size(); ++i)
                    sum[i] += std::to_integer<int>(from[i]);
            }
            const auto to = small.at(x, y);
            for (std::size_t i = 0; i < sum.size(); ++i)
                to[i] = static_cast<std::byte>((sum[i] + looks * looks / 2) / (looks * looks));
            to[3] = std::byte{255};
        }
    }
    return small;
}

} // namespace texplorer::stage

#include "texplorer/image/thumbnail.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace texplorer::thumbnail_test {
namespace {

Image plain(PixelFormat format, int width, int height, const std::vector<int>& pixel) {
    Image image = Image::uninitialised(format, width, height);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        image.pixels[i] = static_cast<std::byte>(pixel[i % pixel.size()]);
    return image;
}

std::array<int, 4> colorAt(const Image& image, int x, int y) {
    const ByteView pixel = image.at(x, y);
    return {std::to_integer<int>(pixel[0]), std::to_integer<int>(pixel[1]), std::to_integer<int>(pixel[2]),
            std::to_integer<int>(pixel[3])};
}

struct Extent {
    const char* name;
    int width, height;
    int smallWidth, smallHeight;
};

class ThumbnailExtent : public testing::TestWithParam<Extent> {};

TEST_P(ThumbnailExtent, KeepsTheShape) {
    const Extent& extent = GetParam();
    const Image small = thumbnailOf(plain(PixelFormat::Rgb8, extent.width, extent.height, {10, 20, 30}), 64);
    EXPECT_EQ(small.width, extent.smallWidth);
    EXPECT_EQ(small.height, extent.smallHeight);
    EXPECT_EQ(small.format, PixelFormat::Rgba8);
    for (const auto& [x, y] : {std::pair(0, 0), std::pair(small.width - 1, small.height - 1)})
        EXPECT_EQ(colorAt(small, x, y), (std::array{10, 20, 30, 255}));
}

INSTANTIATE_TEST_SUITE_P(All, ThumbnailExtent,
                         testing::Values(Extent{"Large", 640, 320, 64, 32}, Extent{"Odd", 101, 67, 64, 42},
                                         Extent{"Small", 5, 3, 5, 3}, Extent{"One", 1, 1, 1, 1},
                                         Extent{"Line", 1000, 1, 64, 1}, Extent{"Tall", 2, 4096, 1, 64}),
                         [](const auto& test) { return test.param.name; });

struct Converted {
    const char* name;
    PixelFormat format;
    std::vector<int> pixel;
    std::array<int, 4> color;
};

class ThumbnailColor : public testing::TestWithParam<Converted> {};

TEST_P(ThumbnailColor, IsThatOfTheFormat) {
    EXPECT_EQ(colorAt(thumbnailOf(plain(GetParam().format, 100, 100, GetParam().pixel), 8), 3, 4),
              GetParam().color);
}

INSTANTIATE_TEST_SUITE_P(
    All, ThumbnailColor,
    testing::Values(Converted{"Alpha", PixelFormat::Alpha8, {77}, {255, 255, 255, 77}},
                    Converted{"Luminance", PixelFormat::Luminance8, {90}, {90, 90, 90, 255}},
                    Converted{"LuminanceAlpha", PixelFormat::LuminanceAlpha8, {90, 128}, {90, 90, 90, 128}},
                    Converted{"Rgb", PixelFormat::Rgb8, {1, 2, 3}, {1, 2, 3, 255}},
                    Converted{"Rgba", PixelFormat::Rgba8, {200, 100, 50, 40}, {200, 100, 50, 40}},
                    Converted{"Nothing", PixelFormat::Rgba8, {200, 100, 50, 0}, {0, 0, 0, 0}}),
    [](const auto& test) { return test.param.name; });

TEST(Thumbnail, WeighsByAreaAndAlpha) {
    // Three columns into two: the left pixel is 2/3 of the first and 1/3 of the second.
    Image image = Image::uninitialised(PixelFormat::Rgba8, 3, 1);
    const std::array<std::array<int, 4>, 3> texels{{{255, 0, 0, 255}, {0, 0, 0, 255}, {0, 255, 0, 0}}};
    for (int x = 0; x < 3; ++x) {
        for (std::size_t i = 0; i < 4; ++i)
            image.at(x, 0)[i] = static_cast<std::byte>(texels[static_cast<std::size_t>(x)][i]);
    }
    const Image small = thumbnailOf(image, 2);
    EXPECT_EQ(colorAt(small, 0, 0), (std::array{170, 0, 0, 255}));
    EXPECT_EQ(colorAt(small, 1, 0), (std::array{0, 0, 0, 85})) << "what is not seen has no colour";
}

TEST(Thumbnail, OfNothingIsNothing) {
    EXPECT_TRUE(thumbnailOf(Image{}, 64).empty());
}

} // namespace
} // namespace texplorer::thumbnail_test

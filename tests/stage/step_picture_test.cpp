#include "app/stage/step_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

namespace texplorer::stage::step_picture_test {
namespace {

Image filled(int width, int height, std::byte value) {
    Image image = Image::uninitialised(PixelFormat::Rgba8, width, height);
    std::ranges::fill(image.pixels, value);
    return image;
}

TEST(StepPicture, KeepsTheShapeAndFits) {
    const auto sizeOf = [](int width, int height) {
        const Image small = stepPicture(filled(width, height, std::byte{7}));
        return std::pair(small.width, small.height);
    };
    EXPECT_EQ(sizeOf(960, 600), std::pair(96, 60));
    EXPECT_EQ(sizeOf(600, 600), std::pair(60, 60));
    EXPECT_EQ(sizeOf(1920, 600), std::pair(96, 30));
    EXPECT_EQ(sizeOf(10000, 2), std::pair(96, 1)) << "never nothing";
    EXPECT_EQ(sizeOf(40, 30), std::pair(40, 30)) << "what is small stays as it is";
}

TEST(StepPicture, IsOpaqueAndHasTheColours) {
    Image image = filled(192, 120, std::byte{0});
    for (int y = 0; y < 60; ++y) {
        for (int x = 96; x < 192; ++x) {
            image.at(x, y)[0] = std::byte{200};
            image.at(x, y)[2] = std::byte{100};
        }
    }
    const Image small = stepPicture(image);
    ASSERT_EQ(small.width, 96);
    const auto isColor = [&](int x, int y, int red, int blue) {
        const ByteView pixel = ByteView(small.at(x, y));
        return std::to_integer<int>(pixel[0]) == red && std::to_integer<int>(pixel[1]) == 0 &&
               std::to_integer<int>(pixel[2]) == blue && std::to_integer<int>(pixel[3]) == 255;
    };
    EXPECT_TRUE(isColor(10, 10, 0, 0));
    EXPECT_TRUE(isColor(90, 10, 200, 100)) << "its first row is the bottom one, as of the picture";
    EXPECT_TRUE(isColor(90, 50, 0, 0));
}

TEST(StepPicture, OfNothingIsNothing) {
    EXPECT_TRUE(stepPicture({}).empty());
    EXPECT_TRUE(stepPicture(Image::uninitialised(PixelFormat::Rgb8, 4, 4)).empty());
}

} // namespace
} // namespace texplorer::stage::step_picture_test

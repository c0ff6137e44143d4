#include "texplorer/image/convert.h"
#include "texplorer/image/depth_pixels.h"
#include "texplorer/image/thumbnail.h"

#include <gtest/gtest.h>

namespace texplorer::depth_pixels_test {
namespace {

TEST(DepthPixels, WidenedTheyComeBackByRoundingAndByCutting) {
    for (const int bits : {8, 16, 24}) {
        const std::uint32_t most = (1U << bits) - 1;
        EXPECT_EQ(widenedDepth(0, bits), 0U);
        EXPECT_EQ(widenedDepth(most, bits), farthestDepth32);
        for (std::uint64_t i = 0; i <= 1000; ++i) {
            const auto depth = static_cast<std::uint32_t>(i * most / 1000);
            const std::uint32_t wide = widenedDepth(depth, bits);
            EXPECT_EQ(wide >> (32 - bits), depth) << bits;
            EXPECT_EQ((wide * std::uint64_t{most} + farthestDepth32 / 2) / farthestDepth32, depth) << bits;
        }
    }
}

Image pixel(PixelFormat format, std::initializer_list<int> bytes) {
    Image image = Image::uninitialised(format, 1, 1);
    std::size_t i = 0;
    for (const int byte : bytes)
        image.pixels[i++] = static_cast<std::byte>(byte);
    return image;
}

TEST(DepthPixels, AreTheRedOfAnImage) {
    const std::uint32_t expected = widenedDepth(51, 8); // 0.2: exact in 16 and in 24 bits
    EXPECT_EQ(expected, farthestDepth32 / 5);
    for (const int bits : {16, 24}) {
        EXPECT_EQ(depthAt(depthsOf(pixel(PixelFormat::Rgba8, {51, 1, 2, 3}), bits).pixels.data()), expected);
        EXPECT_EQ(depthAt(depthsOf(pixel(PixelFormat::Rgb8, {51, 1, 2}), bits).pixels.data()), expected);
        EXPECT_EQ(depthAt(depthsOf(pixel(PixelFormat::Luminance8, {51}), bits).pixels.data()), expected);
        EXPECT_EQ(depthAt(depthsOf(pixel(PixelFormat::Alpha8, {51}), bits).pixels.data()), 0U)
            << "has no red";
    }
}

TEST(DepthPixels, AreRoundedToTheBitsOfTheTexture) {
    Image image = Image::uninitialised(PixelFormat::Depth32, 1, 1);
    // 0x1234 and 0x1235 of 65535 are these twice; the middle between them is 0x12349234.8.
    storeDepth(0x12349235U, image.pixels.data());
    EXPECT_EQ(depthAt(depthsOf(image, 16).pixels.data()), 0x12351235U);
    storeDepth(0x12349234U, image.pixels.data());
    EXPECT_EQ(depthAt(depthsOf(image, 16).pixels.data()), 0x12341234U);
    const Image once = depthsOf(image, 24);
    EXPECT_EQ(depthsOf(once, 24), once);
}

TEST(DepthPixels, AreGreysToLookAt) {
    Image image = Image::uninitialised(PixelFormat::Depth32, 3, 1);
    storeDepth(0, image.at(0, 0).data());
    storeDepth(farthestDepth32 / 5, image.at(1, 0).data());
    storeDepth(farthestDepth32, image.at(2, 0).data());
    const Image greys = greysOf(image);
    EXPECT_EQ(greys.format, PixelFormat::Luminance8);
    EXPECT_EQ(greys.pixels, (Bytes{std::byte{0}, std::byte{51}, std::byte{255}}));
    const Image small = thumbnailOf(image, 3);
    EXPECT_EQ(rgbaOf(small.format, small.at(1, 0).data()), (std::array<std::uint8_t, 4>{51, 51, 51, 255}));
    EXPECT_EQ(greysOf(greys), greys);
}

} // namespace
} // namespace texplorer::depth_pixels_test

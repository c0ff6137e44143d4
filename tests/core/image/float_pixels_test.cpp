#include "texplorer/image/convert.h"
#include "texplorer/image/float_pixels.h"
#include "texplorer/image/mipmaps.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

namespace texplorer::float_pixels_test {
namespace {

using testing::ElementsAre;

// IEEE 754's binary16: a sign, 5 bits of exponent, 10 of the fraction after a leading 1.
TEST(RoundedToHalf, IsTheNearestOfSixteenBits) {
    const float step = std::ldexp(1.0F, -10); // of the numbers from 1 to 2
    EXPECT_EQ(roundedToHalf(0.1F), 1638 * std::ldexp(1.0F, -14));
    EXPECT_EQ(roundedToHalf(0.3F), 1229 * std::ldexp(1.0F, -12));
    EXPECT_EQ(roundedToHalf(-0.3F), -1229 * std::ldexp(1.0F, -12));
    EXPECT_EQ(roundedToHalf(1 + step / 2), 1);
    EXPECT_EQ(roundedToHalf(1 + 3 * step / 2), 1 + 2 * step);
    EXPECT_EQ(roundedToHalf(2049), 2048);
    EXPECT_EQ(roundedToHalf(2051), 2052);
    EXPECT_EQ(roundedToHalf(65504), 65504);
    EXPECT_EQ(roundedToHalf(1e6F), 65504);
    EXPECT_EQ(roundedToHalf(-1e6F), -65504);
}

TEST(RoundedToHalf, HasStepsOfOneSizeBelowTheLeastNormalNumber) {
    const float least = std::ldexp(1.0F, -24);
    EXPECT_EQ(roundedToHalf(least), least);
    EXPECT_EQ(roundedToHalf(least / 2), 0);
    EXPECT_EQ(roundedToHalf(0.75F * least), least);
    EXPECT_EQ(roundedToHalf(1023.4F * least), 1023 * least);
    EXPECT_EQ(roundedToHalf(0), 0);
}

TEST(RoundedToHalf, KeepsWhatIsNoNumber) {
    const float infinity = std::numeric_limits<float>::infinity();
    EXPECT_EQ(roundedToHalf(infinity), infinity);
    EXPECT_EQ(roundedToHalf(-infinity), -infinity);
    EXPECT_TRUE(std::isnan(roundedToHalf(std::numeric_limits<float>::quiet_NaN())));
}

Image texel(const FloatTexel& numbers) {
    Image image = Image::uninitialised(PixelFormat::RgbaFloat, 1, 1);
    storeFloats(numbers, image.pixels.data());
    return image;
}

TEST(FloatPixels, AreLimitedAsBytes) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THAT(rgbaOf(PixelFormat::RgbaFloat, texel({2, -1, 0.5F, nan}).pixels.data()),
                ElementsAre(255, 0, 128, 0));
}

TEST(FloatPixels, AreMadeOfBytes) {
    Image grey = Image::uninitialised(PixelFormat::LuminanceAlpha8, 1, 1);
    grey.pixels = {std::byte{51}, std::byte{255}};
    const Image floats = floatsOf(grey, 32);
    EXPECT_THAT(floatsAt(floats.pixels.data()), ElementsAre(0.2F, 0.2F, 0.2F, 1));
    EXPECT_THAT(floatsAt(floatsOf(grey, 16).pixels.data()),
                ElementsAre(1638 * std::ldexp(1.0F, -13), testing::_, testing::_, 1));
    EXPECT_EQ(floatsOf(floats, 32), floats);
}

// Of an odd size, each texel counts as far as it is covered: (2 a + 2 b + c) / 5.
TEST(FloatPixels, HaveMeansThatAreNotLimited) {
    Image line = Image::uninitialised(PixelFormat::RgbaFloat, 5, 1);
    for (int x = 0; x < 5; ++x)
        storeFloats({static_cast<float>(x), -1, 100, 0.5F}, line.at(x, 0).data());
    const MipChain chain = buildMipChain(line);
    ASSERT_EQ(chain.size(), 3U);
    EXPECT_THAT(floatsAt(chain[1].at(0, 0).data()), ElementsAre(0.8F, -1, 100, 0.5F));
    EXPECT_THAT(floatsAt(chain[1].at(1, 0).data()), ElementsAre(3.2F, -1, 100, 0.5F));
    EXPECT_THAT(floatsAt(chain[2].at(0, 0).data()), ElementsAre(2, -1, 100, 0.5F));
}

} // namespace
} // namespace texplorer::float_pixels_test

#include "tests/core/compare/peer_maps.h"
#include "tests/support/temp_dir.h"
#include "texplorer/compare/comparison.h"

#include <gmock/gmock.h>

namespace texplorer::ssim_test {
namespace {

using test::even;
using test::setPixel;
using test::valuesOf;
using testing::Each;

const Criterion ssim = criterionOf(Metric::Ssim);

TEST(Ssim, IsWhatTheFormulaAndScikitImageSay) {
    const test::TempDir folder;
    int checked = 0;
    test::writeMaps(folder.path(), ssim, "ssim", checked);
    EXPECT_EQ(checked, 18);
    EXPECT_TRUE(test::runPython("fixtures/check_ssim.py", folder.path()));
}

// Of even pictures a and b the variances are 0 and what remains is (2ab + C1) / (a² + b² + C1).
TEST(Ssim, OfEvenPicturesIsThatOfTheirBrightness) {
    for (const auto& [a, b] : {std::pair{0, 255}, {100, 110}, {250, 255}, {0, 1}, {17, 17}}) {
        const auto shade = [](int grey) {
            const auto value = static_cast<std::uint8_t>(grey);
            return even(20, 14, {value, value, value, 255});
        };
        const double c1 = 2.55 * 2.55;
        const double expected = (2.0 * a * b + c1) / (a * a + b * b + c1);
        for (const float value : valuesOf(shade(a), shade(b), ssim))
            EXPECT_NEAR(1 - static_cast<double>(value), expected, 1e-4) << a << " and " << b;
        EXPECT_NEAR(comparePictures(shade(a), shade(b), ssim)->score, expected, 1e-4);
    }
}

// A channel that differs counts a third, or a quarter where alpha counts too.
TEST(Ssim, IsTheMeanOfTheChannels) {
    const double c1 = 2.55 * 2.55;
    const double ofRed = (2.0 * 10 * 200 + c1) / (10.0 * 10 + 200 * 200 + c1);
    const Image a = even(8, 8, {10, 50, 60, 255});
    const Image b = even(8, 8, {200, 50, 60, 255});
    EXPECT_NEAR(comparePictures(a, b, ssim)->score, (ofRed + 2) / 3, 1e-4);
    const Image clearA = even(8, 8, {10, 50, 60, 77});
    const Image clearB = even(8, 8, {200, 50, 60, 77});
    EXPECT_NEAR(comparePictures(clearA, clearB, ssim)->score, (ofRed + 3) / 4, 1e-4);
    Criterion rgb = ssim;
    rgb.compared = Compared::Rgb;
    EXPECT_NEAR(comparePictures(clearA, clearB, rgb)->score, (ofRed + 2) / 3, 1e-4);
}

// The number is what ImageMagick 7.1.1-27 says (-metric SSIM). Debian 12 has ImageMagick 6, which has no
// SSIM.
TEST(Ssim, IsWhatImageMagickSays) {
    Image a = Image::uninitialised(PixelFormat::Rgba8, 48, 32);
    Image b = a;
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 48; ++x) {
            const auto at = [&](int value) { return static_cast<std::uint8_t>(value & 255); };
            setPixel(a, x, y, {at(x * 5), at(y * 7), at(x * y), 255});
            setPixel(b, x, y, {at(x * 5 + (x % 3) * 4), at(y * 7), at(x * y + 9), 255});
        }
    EXPECT_NEAR(comparePictures(a, b, ssim)->score, 0.9201257254754259, 1e-5);
}

TEST(Ssim, OfEqualPicturesIsExactlyOne) {
    Image a = even(30, 20, {3, 200, 90, 255});
    setPixel(a, 5, 5, {255, 0, 7, 255});
    Image b = a;
    setPixel(b, 25, 15, {0, 0, 0, 255}); // far from the upper left
    const std::vector<float> values = valuesOf(a, b, ssim);
    EXPECT_EQ(values[0], 0);
    EXPECT_EQ(values[5 * 30 + 5], 0);
    EXPECT_GT(values[15 * 30 + 25], 0.5F);
    EXPECT_THAT(valuesOf(a, a, ssim), Each(0.0F));
    EXPECT_EQ(comparePictures(a, a, ssim)->score, 1);
    EXPECT_EQ(valuesOf(a, b, ssim), valuesOf(b, a, ssim));
}

TEST(Ssim, DoesNotSeeThroughTheMask) {
    Image a = even(30, 20, {3, 200, 90, 255});
    Image b = a;
    Image mask = even(30, 20, {255, 255, 255, 255});
    for (int y = 4; y < 9; ++y)
        for (int x = 6; x < 20; ++x) {
            setPixel(b, x, y, {255, 255, 255, 255});
            setPixel(mask, x, y, {0, 0, 0, 255});
        }
    EXPECT_THAT(valuesOf(a, b, ssim, &mask), Each(0.0F));
    EXPECT_LT(comparePictures(a, b, ssim)->score, 1);
    EXPECT_EQ(comparePictures(a, b, ssim, &mask)->score, 1);
}

} // namespace
} // namespace texplorer::ssim_test

#include "tests/core/compare/peer_maps.h"
#include "tests/support/temp_dir.h"
#include "texplorer/compare/comparison.h"

#include <gmock/gmock.h>

namespace texplorer::flip_test {
namespace {

using test::even;
using test::setPixel;
using test::valuesOf;
using testing::AllOf;
using testing::Each;
using testing::Ge;
using testing::Le;

const Criterion flip = criterionOf(Metric::Flip);

class FlipAtADistance : public testing::TestWithParam<double> {};

TEST_P(FlipAtADistance, IsWhatTheEquationsSay) {
    const test::TempDir folder;
    Criterion criterion = flip;
    criterion.pixelsPerDegree = GetParam();
    const std::string line = std::to_string(GetParam());
    ASSERT_TRUE(writeFileAtomically(folder.path() / "pixels-per-degree.txt", viewBytes(line)));
    int checked = 0;
    test::writeMaps(folder.path(), criterion, "flip", checked);
    EXPECT_EQ(checked, 18);
    EXPECT_TRUE(test::runPython("fixtures/check_flip.py", folder.path()));
}

INSTANTIATE_TEST_SUITE_P(All, FlipAtADistance, testing::Values(67.0, 30.5, 5.0));

// Green and blue are what the scale ends with, and of even pictures there are no features.
TEST(Flip, IsOneBetweenGreenAndBlue) {
    const std::vector<float> values =
        valuesOf(even(9, 9, {0, 255, 0, 255}), even(9, 9, {0, 0, 255, 255}), flip);
    for (const float value : values)
        EXPECT_NEAR(value, 1, 1e-5);
}

// A grey has no colour, so the difference of two is that of their CIE lightness: 2 of stored 118 and 123,
// about 4 of 118 and 128. One sees about 2.3 (Mahy, Van Eycken, Oosterlinck 1994).
TEST(Flip, StaysBelowTheToleranceForWhatOneJustSees) {
    const auto grey = [](std::uint8_t value) { return even(9, 9, {value, value, value, 255}); };
    // Stored 118 and 123 are 49.97 and 51.96 in lightness.
    for (const float value : valuesOf(grey(118), grey(123), flip))
        EXPECT_LE(static_cast<double>(value), factsOf(Metric::Flip).tolerance);
    for (const float value : valuesOf(grey(118), grey(128), flip))
        EXPECT_GT(static_cast<double>(value), factsOf(Metric::Flip).tolerance);
}

TEST(Flip, IsBetweenNoneAndOneAndTheSameTheOtherWayRound) {
    Image a = even(30, 20, {3, 200, 90, 255});
    Image b = a;
    setPixel(b, 25, 15, {255, 0, 200, 255});
    setPixel(b, 0, 0, {0, 0, 0, 255});
    EXPECT_THAT(valuesOf(a, b, flip), Each(AllOf(Ge(0.0F), Le(1.0F))));
    EXPECT_EQ(valuesOf(a, b, flip), valuesOf(b, a, flip));
    EXPECT_THAT(valuesOf(a, a, flip), Each(0.0F));
    EXPECT_EQ(comparePictures(a, a, flip)->score, 0);
}

// What one sees of alpha is what shines through.
TEST(Flip, SeesAlphaOverBlackAndOverWhite) {
    const Image white = even(6, 6, {255, 255, 255, 255});
    const Image clear = even(6, 6, {255, 255, 255, 0});
    const Image black = even(6, 6, {0, 0, 0, 255});
    EXPECT_EQ(comparePictures(white, clear, flip)->worst.value,
              comparePictures(white, black, flip)->worst.value);
    const Image clearBlack = even(6, 6, {0, 0, 0, 0});
    EXPECT_EQ(comparePictures(clear, clearBlack, flip)->score, 0);
    Criterion rgb = flip;
    rgb.compared = Compared::Rgb;
    EXPECT_EQ(comparePictures(white, clear, rgb)->score, 0);
}

} // namespace
} // namespace texplorer::flip_test

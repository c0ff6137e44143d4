#include "texplorer/image/alpha_coverage.h"
#include "texplorer/image/mipmaps.h"
#include "texplorer/image/patterns/pattern.h"

#include <gtest/gtest.h>

#include <vector>

namespace texplorer::alpha_coverage_test {
namespace {

Image alphaImage(int width, const std::vector<int>& values, int depth = 1) {
    Image image{PixelFormat::Alpha8, width, static_cast<int>(values.size()) / width / depth, depth, {}};
    for (const int each : values)
        image.pixels.push_back(static_cast<std::byte>(each));
    return image;
}

// The second texel's first point has 3/8 of the first texel: 95.6.
TEST(AlphaCoverage, CountsPointsBetweenTexels) {
    const Image image = alphaImage(2, {255, 0});
    EXPECT_EQ(alphaCoverage(image, 0.5F), 4 / 8.0);  // 127.5
    EXPECT_EQ(alphaCoverage(image, 0.35F), 5 / 8.0); // 89.25
    EXPECT_EQ(alphaCoverage(image, 1), 0);
    EXPECT_EQ(alphaCoverage(alphaImage(1, {255, 0}), 0.35F), 5 / 8.0) << "up as well as across";
    EXPECT_EQ(alphaCoverage(alphaImage(1, {255, 0}, 2), 0.35F), 0.5) << "not between slices";
}

TEST(AlphaCoverage, OfTheOpaqueIsWhole) {
    EXPECT_EQ(alphaCoverage(drawPattern(Pattern::Checker), 0.5F), 1);
    EXPECT_EQ(alphaCoverage(Image::uninitialised(PixelFormat::Rgb8, 2, 2), 0.5F), 1);
}

// All four points of the first texel pass above 204 (5/8 of it are 127.5), none of the second below 340.
TEST(WithCoverage, ScalesAlphaAlone) {
    Image image = Image::uninitialised(PixelFormat::LuminanceAlpha8, 2, 1);
    image.pixels = {std::byte{7}, std::byte{100}, std::byte{9}, std::byte{0}};
    const Image made = withCoverage(image, 0.5F, 0.5);
    EXPECT_EQ(made.pixels[0], std::byte{7});
    EXPECT_GT(made.pixels[1], std::byte{204});
    EXPECT_EQ(made.pixels[2], std::byte{9});
    EXPECT_EQ(made.pixels[3], std::byte{0});
}

TEST(WithCoverage, LeavesWhatFits) {
    const Image image = alphaImage(2, {255, 0});
    EXPECT_EQ(withCoverage(image, 0.5F, 0.5), image);
}

TEST(MipChains, KeepTheCoverageOfTheirBase) {
    const Image tree = drawPattern(Pattern::Tree);
    for (const float reference : {0.25F, 0.5F, 0.9F}) {
        const double whole = alphaCoverage(tree, reference);
        const MipChain plain = buildMipChain(tree);
        const MipChain kept = buildMipChain(tree, {.coverage = reference});
        ASSERT_EQ(kept.size(), plain.size());
        EXPECT_EQ(kept[0], tree);
        for (std::size_t i = 1; i < kept.size() && kept[i].width >= 8; ++i) {
            EXPECT_NEAR(alphaCoverage(kept[i], reference), whole, 0.01) << i;
            for (std::size_t at = 0; at < kept[i].pixels.size(); ++at) {
                if (at % 4 != 3) {
                    ASSERT_EQ(kept[i].pixels[at], plain[i].pixels[at]);
                }
            }
        }
    }
}

} // namespace
} // namespace texplorer::alpha_coverage_test

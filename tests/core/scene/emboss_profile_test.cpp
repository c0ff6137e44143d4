// NeHe's lesson 22 along a line, worked out by hand: grey = 1/2 + (H0 - H1)/2, colour = (1 + H0 - H1) light
// texel.

#include "texplorer/image/patterns/pattern.h"
#include "texplorer/scene/emboss_profile.h"

#include <gtest/gtest.h>

#include <numbers>

namespace texplorer::emboss_profile_test {
namespace {

constexpr float right = std::numbers::pi_v<float> / 6; // 30 degrees: S . l is 1/2
constexpr float below = 1e-5F;

/// 4 texels, whose centres are at 1/8, 3/8, 5/8 and 7/8.
HeightProfile steps() {
    return {{0, 0.25F, 0.75F, 1}, {glm::vec3(0), glm::vec3(0.4F), glm::vec3(0.4F, 0.8F, 0), glm::vec3(1)}};
}

TEST(EmbossProfile, IsReadLinearly) {
    EXPECT_FLOAT_EQ(steps().heightAt(0.125F), 0);
    EXPECT_FLOAT_EQ(steps().heightAt(0.25F), 0.125F);
    EXPECT_FLOAT_EQ(steps().heightAt(0.5F), 0.5F);
    EXPECT_FLOAT_EQ(steps().heightAt(-3), 0);
    EXPECT_FLOAT_EQ(steps().heightAt(3), 1);
    EXPECT_FLOAT_EQ(steps().colorAt(0.25F).r, 0.2F);
}

TEST(EmbossProfile, FlatIsGreyOfOneHalfAtAnyHeight) {
    EXPECT_EQ(embossGrey(0, 0), 0.5F);
    EXPECT_EQ(embossGrey(1, 1), 0.5F);
    EXPECT_EQ(embossGrey(0.25F, 0.25F), 0.5F);
    EXPECT_EQ(embossGrey(1, 0), 1);
    EXPECT_EQ(embossGrey(0, 1), 0);
    EXPECT_FLOAT_EQ(embossGrey(0.6F, 0.4F), 0.6F);
}

TEST(EmbossProfile, TheBlendCountsTheProductTwice) {
    EXPECT_EQ(embossedColor(0.5F, {0.25F, 0.5F, 0.75F}), glm::vec3(0.25F, 0.5F, 0.75F));
    EXPECT_EQ(embossedColor(0.75F, {0.5F, 0.5F, 1}), glm::vec3(0.75F, 0.75F, 1)) << "clamped";
}

// s = 3/8, MAX_EMBOSS = 1/2: ds = 1/4, so H0 = 0.25 and H1 = 0.75: grey 1/4, and half of what is lit.
TEST(EmbossProfile, IsDarkWhereItClimbsTowardsTheLight) {
    const EmbossedPoint point = embossAt(steps(), 0.375F, right, 0.5F, 0.5F);
    EXPECT_NEAR(point.offset, 0.25F, below);
    EXPECT_NEAR(point.h0, 0.25F, below);
    EXPECT_NEAR(point.h1, 0.75F, below);
    EXPECT_NEAR(point.grey, 0.25F, below);
    EXPECT_NEAR(point.color.r, 0.4F * 0.5F * 0.5F, below);
    const EmbossedPoint other = embossAt(steps(), 0.625F, -right, 0.5F, 0.5F); // the light on the other side
    EXPECT_NEAR(other.offset, -0.25F, below);
    EXPECT_NEAR(other.grey, 0.75F, below);
    EXPECT_NEAR(embossAt(steps(), 0.375F, 0, 0.5F, 1).grey, 0.5F, below) << "from above nothing is shifted";
}

TEST(EmbossProfile, TheSketchHasABumpAndABlock) {
    const HeightProfile sketch = sketchedProfile();
    ASSERT_EQ(sketch.heights.size(), sketch.colors.size());
    EXPECT_NEAR(sketch.heightAt(0.02F), 0.2F, 0.01F);
    EXPECT_NEAR(sketch.heightAt(0.27F), 0.8F, 0.01F);
    EXPECT_NEAR(sketch.heightAt(0.5F), 0.2F, 0.01F);
    EXPECT_NEAR(sketch.heightAt(0.72F), 0.8F, 0.01F);
    EXPECT_NEAR(sketch.heightAt(0.605F), 0.5F, 0.02F) << "half way up the block's side";
}

TEST(EmbossProfile, TakesARowOfAnImage) {
    const Image heights = drawPattern(Pattern::BrickHeight);
    const Image colors = drawPattern(Pattern::Brick);
    ASSERT_EQ(heights.width, colors.width);
    const HeightProfile row = profileOf(heights, colors, 16);
    ASSERT_EQ(row.heights.size(), static_cast<std::size_t>(heights.width));
    const float centre = 100.5F / static_cast<float>(heights.width);
    EXPECT_NEAR(row.heightAt(centre) * 255, std::to_integer<int>(heights.at(100, 16)[0]), 0.01F);
    EXPECT_NEAR(row.colorAt(centre).g * 255, std::to_integer<int>(colors.at(100, 16)[1]), 0.01F);
}

} // namespace
} // namespace texplorer::emboss_profile_test

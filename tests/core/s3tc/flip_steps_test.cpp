// The steps lead to where the flip of the whole leads, and to the mirrored picture.

#include "tests/core/s3tc/squish_oracle.h"
#include "texplorer/s3tc/decode.h"
#include "texplorer/s3tc/flip.h"
#include "texplorer/s3tc/flip_steps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace texplorer::flip_steps_test {
namespace {

using Act = FlipStep::Act;

BlockImage noise(BlockFormat format, int width, int height) {
    BlockImage image = BlockImage::uninitialised(format, width, height);
    std::mt19937 random(static_cast<unsigned>(width * 100 + height));
    for (std::byte& each : image.blocks)
        each = static_cast<std::byte>(random());
    return image;
}

Image mirrored(const Image& image) {
    Image flipped = image;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            std::ranges::copy(image.at(x, image.height - 1 - y), flipped.at(x, y).begin());
    return flipped;
}

std::vector<Act> actsOf(const std::vector<FlipStep>& steps) {
    std::vector<Act> acts;
    std::ranges::transform(steps, std::back_inserter(acts), &FlipStep::act);
    return acts;
}

TEST(FlipSteps, EndWhereTheFlipOfTheWholeEnds) {
    for (const BlockFormat format :
         {BlockFormat::Dxt1, BlockFormat::Dxt1Alpha, BlockFormat::Dxt3, BlockFormat::Dxt5})
        for (int height = 1; height <= 20; ++height) {
            const BlockImage image = noise(format, 12, height);
            const auto steps = flipSteps(image);
            ASSERT_TRUE(steps);
            EXPECT_EQ(steps->front().after, image);
            if (!flipsWithoutLoss(height))
                continue;
            BlockImage whole = image;
            ASSERT_TRUE(flipVertically(whole));
            EXPECT_EQ(steps->back().after, whole) << rowOf(format).label << " " << height;
            EXPECT_EQ(decodeWithSquish(steps->back().after), mirrored(decodeWithSquish(image)))
                << rowOf(format).label << " " << height;
        }
}

TEST(FlipSteps, AreAsManyAsTheHeightNeeds) {
    const auto acts = [](int height) { return actsOf(*flipSteps(noise(BlockFormat::Dxt1, 4, height))); };
    EXPECT_EQ(acts(1), std::vector{Act::AsStored});
    EXPECT_EQ(acts(2), (std::vector{Act::AsStored, Act::TurnRows}));
    EXPECT_EQ(acts(3), (std::vector{Act::AsStored, Act::TurnRows}));
    EXPECT_EQ(acts(4), (std::vector{Act::AsStored, Act::TurnRows}));
    EXPECT_EQ(acts(8), (std::vector{Act::AsStored, Act::SwapBlockRows, Act::TurnRows, Act::TurnRows}));
    EXPECT_EQ(acts(12),
              (std::vector{Act::AsStored, Act::SwapBlockRows, Act::TurnRows, Act::TurnRows, Act::TurnRows}));
    EXPECT_EQ(acts(6), (std::vector{Act::AsStored, Act::SwapBlockRows, Act::TurnRows, Act::TurnRows,
                                    Act::Recompress}));
}

// Texel rows 0 to 5 and two that don't count, u and v: after the steps for 8 the picture begins with v.
TEST(FlipSteps, OfHeightSixBringTheUnusedRowsIntoThePicture) {
    const BlockImage image = noise(BlockFormat::Dxt5, 4, 6);
    const std::vector<FlipStep> steps = *flipSteps(image);
    const Image turned = decodeBlocks(steps[3].after);
    BlockImage whole = image;
    whole.height = 8;
    const Image rows = decodeBlocks(whole);
    for (int y = 0; y < 6; ++y)
        for (int x = 0; x < 4; ++x)
            EXPECT_TRUE(std::ranges::equal(turned.at(x, y), rows.at(x, 7 - y))) << x << " " << y;
    EXPECT_EQ(steps.back().after, *decodeFlipEncode(image, FlipAxis::Vertical, EncodeQuality::Best));
}

TEST(FlipSteps, OfBlocksThatAreMissingAreAnError) {
    BlockImage image = noise(BlockFormat::Dxt1, 4, 8);
    image.blocks.pop_back();
    EXPECT_EQ(flipSteps(image).error().code, ErrorCode::Malformed);
}

} // namespace
} // namespace texplorer::flip_steps_test

#include "app/ui/levels/level_strip.h"

#include <gtest/gtest.h>

#include <array>

namespace texplorer::ui::level_strip_test {
namespace {

constexpr std::array levels{StripLevel{0, 8, 4}, StripLevel{1, 4, 2}, StripLevel{2, 2, 1},
                            StripLevel{3, 1, 1}};
constexpr float gap = 10;

// 8 + 4 + 2 + 1 texels and three gaps: 30 pixels for each texel in a width of 480.
TEST(LevelStrip, HasItsTrueSizesAcrossTheRoom) {
    const LevelStrip strip = layOutLevels(levels, {480, 1000}, gap, false, 1);
    ASSERT_EQ(strip.cells.size(), 4U);
    EXPECT_NEAR(strip.texel, 30, 0.01F);
    EXPECT_NEAR(strip.extent.x, 480, 0.1F);
    EXPECT_NEAR(strip.extent.y, 120, 0.1F);
    for (std::size_t i = 0; i < levels.size(); ++i) {
        EXPECT_NEAR(strip.cells[i].picture.x, levels.at(i).width * 30, 0.1F);
        EXPECT_NEAR(strip.cells[i].picture.y, levels.at(i).height * 30, 0.1F);
    }
    EXPECT_NEAR(strip.cells[1].left, 250, 0.1F);
}

TEST(LevelStrip, IsNoHigherThanTheRoom) {
    const LevelStrip strip = layOutLevels(levels, {2000, 40}, gap, false, 1);
    EXPECT_NEAR(strip.texel, 10, 0.01F);
    EXPECT_NEAR(strip.extent.y, 40, 0.1F);
}

TEST(LevelStrip, ShowsEveryTexelOfTheSmallestLevel) {
    constexpr std::array large{StripLevel{0, 4096, 4096}, StripLevel{12, 1, 1}};
    const LevelStrip strip = layOutLevels(large, {200, 100}, gap, false, 1);
    EXPECT_LT(strip.texel, 1);
    EXPECT_EQ(strip.cells[1].picture.x, 1);
    EXPECT_EQ(strip.cells[1].picture.y, 1);
}

TEST(LevelStrip, LeavesRoomForWhatIsWrittenBelow) {
    std::array labelled = levels;
    for (StripLevel& level : labelled)
        level.label = 50;
    const LevelStrip strip = layOutLevels(labelled, {480, 1000}, gap, false, 1);
    for (const LevelStrip::Cell& cell : strip.cells)
        EXPECT_GE(cell.width, 50);
    EXPECT_NEAR(strip.extent.x, 480, 0.1F);
    // 50 for the last one, and 8 + 4 + 2 texels for the others.
    EXPECT_NEAR(strip.texel, (480 - 50 - 3 * gap) / 14, 0.01F);
}

// Four squares and three gaps in 230 pixels.
TEST(LevelStrip, MakesAllAlike) {
    const LevelStrip strip = layOutLevels(levels, {230, 1000}, gap, true, 1);
    for (std::size_t i = 0; i < levels.size(); ++i) {
        EXPECT_NEAR(strip.cells[i].picture.x, 50, 0.1F);
        EXPECT_NEAR(strip.cells[i].picture.y, i < 3 ? 25 : 50, 0.1F) << "as wide to high as it is";
        EXPECT_NEAR(strip.cells[i].left, static_cast<float>(i) * 60, 0.1F);
    }
}

TEST(LevelStrip, GrowsWithTheZoom) {
    const LevelStrip one = layOutLevels(levels, {480, 1000}, gap, false, 1);
    const LevelStrip four = layOutLevels(levels, {480, 1000}, gap, false, 4);
    EXPECT_NEAR(four.texel, 4 * one.texel, 0.1F);
    EXPECT_GT(four.extent.x, 1500);
    EXPECT_EQ(layOutLevels(levels, {480, 1000}, gap, false, 0.1F).texel, one.texel) << "never smaller";
}

TEST(LevelStrip, LeadsFromLevelsToPlacesAndBack) {
    const LevelStrip strip = layOutLevels(levels, {480, 1000}, gap, false, 1);
    EXPECT_FLOAT_EQ(strip.placeOf(1), strip.cells[1].middle());
    EXPECT_FLOAT_EQ(strip.placeOf(1.5F), (strip.cells[1].middle() + strip.cells[2].middle()) / 2);
    EXPECT_FLOAT_EQ(strip.placeOf(-0.5F), 0);
    EXPECT_FLOAT_EQ(strip.placeOf(-1000), 0) << "and no further";
    EXPECT_FLOAT_EQ(strip.placeOf(1000), strip.cells[3].left + strip.cells[3].width);
    for (const float level : {-0.5F, 0.0F, 0.3F, 1.0F, 2.75F, 3.0F, 3.4F})
        EXPECT_NEAR(strip.levelAt(strip.placeOf(level)), level, 1e-4F);
    EXPECT_FLOAT_EQ(strip.levelAt(-50), -0.5F);
    EXPECT_FLOAT_EQ(strip.levelAt(5000), 3.5F);
}

TEST(LevelStrip, IsEmptyWhereThereIsNothing) {
    EXPECT_TRUE(layOutLevels({}, {480, 1000}, gap, false, 1).cells.empty());
    EXPECT_TRUE(layOutLevels(levels, {0, 100}, gap, false, 1).cells.empty());
    EXPECT_EQ(LevelStrip().placeOf(2), 0);
    EXPECT_EQ(LevelStrip().levelAt(100), 0);
}

} // namespace
} // namespace texplorer::ui::level_strip_test

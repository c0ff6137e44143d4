// The steps of the flip of blocks, as the figure shows them.

#include "tests/ui/figures/figure_bench.h"
#include "texplorer/s3tc/flip.h"

#include <set>

namespace texplorer::ui::block_flip_test {
namespace {

using namespace test;

class BlockFlipFigure : public FigureBench {
protected:
    BlockFlipFigure()
        : FigureBench(Figure::Flip) {}

    [[nodiscard]] BlockFlipState& state() { return figures().flip; }
    /// The numbers that the rows had at the beginning, as they stand at a step.
    [[nodiscard]] std::vector<int> rowsAt(std::size_t step) {
        std::vector<int> rows;
        for (int row = 0; row < state().height; ++row)
            rows.push_back(stripeAt(state().steps[step].after, state().steps.front().after, row));
        return rows;
    }
};

TEST(StripedBlocks, HaveRowsThatCanBeToldApart) {
    for (const BlockFormat format : {BlockFormat::Dxt1Alpha, BlockFormat::Dxt3, BlockFormat::Dxt5}) {
        const BlockImage image = stripedBlocks(format, 12);
        for (int row = 0; row < 12; ++row)
            EXPECT_EQ(stripeAt(image, image, row), row);
    }
}

TEST_F(BlockFlipFigure, EightRowsTakeThreeSteps) {
    ASSERT_EQ(state().height, 8);
    ASSERT_EQ(state().steps.size(), 4U);
    for (const std::vector<int>& rows :
         {std::vector{4, 5, 6, 7, 0, 1, 2, 3}, {7, 6, 5, 4, 0, 1, 2, 3}, {7, 6, 5, 4, 3, 2, 1, 0}}) {
        click("flip:next");
        EXPECT_EQ(rowsAt(state().step), rows);
    }
    EXPECT_TRUE(has("flip:row 0 of step 3 is 7"));
    click("flip:step 1");
    EXPECT_EQ(state().step, 1U);
    click("flip:back");
    EXPECT_EQ(state().step, 0U);
}

TEST_F(BlockFlipFigure, EveryHeightThatCanBeIsTurnedAround) {
    for (const char* format : {"DXT1", "DXT3", "DXT5"})
        for (const int height : {1, 2, 3, 4, 8, 12}) {
            click(fmt::format("flip:format {}", format));
            click(fmt::format("flip:height {}", height));
            frames(2);
            ASSERT_EQ(state().height, height);
            std::vector<int> expected;
            for (int row = height; row > 0; --row)
                expected.push_back(row - 1);
            EXPECT_EQ(rowsAt(state().steps.size() - 1), expected) << format << " " << height;
            BlockImage whole = state().steps.front().after;
            ASSERT_TRUE(flipVertically(whole));
            EXPECT_EQ(state().steps.back().after, whole);
        }
}

TEST_F(BlockFlipFigure, SixAndTenRowsCannotBe) {
    click("flip:height 6");
    frames(2);
    ASSERT_EQ(state().steps.size(), 5U);
    EXPECT_EQ(rowsAt(3), (std::vector{7, 6, 5, 4, 3, 2})) << "two that lie outside of the picture";
    EXPECT_EQ(state().steps.back().act, FlipStep::Act::Recompress);
    click("flip:step 4");
    EXPECT_TRUE(has("flip:row 0 of step 4 is 5"));
    const std::vector<Sentence> words = flipSentences(state().steps, 3);
    EXPECT_EQ(words.back(),
              "Wrong: the image begins with 2 unused rows, and has lost as many rows of its own.");
    click("flip:height 10");
    frames(2);
    EXPECT_EQ(state().steps.back().act, FlipStep::Act::Recompress);
}

// The bytes that the words name are those that change.
TEST(FlipSentences, NameTheBytesThatMove) {
    const auto changedBytes = [](BlockFormat format, int height) {
        const std::vector<FlipStep> steps = *flipSteps(stripedBlocks(format, height));
        std::set<int> changed;
        for (int i = 0; i < static_cast<int>(bytesPerBlock(format)); ++i)
            if (steps[0].after.blocks[static_cast<std::size_t>(i)] !=
                steps[1].after.blocks[static_cast<std::size_t>(i)])
                changed.insert(i);
        return changed;
    };
    EXPECT_EQ(changedBytes(BlockFormat::Dxt1Alpha, 2), (std::set{4, 5}));
    EXPECT_EQ(changedBytes(BlockFormat::Dxt1Alpha, 3), (std::set{4, 6}));
    EXPECT_EQ(changedBytes(BlockFormat::Dxt1Alpha, 4), (std::set{4, 5, 6, 7}));
    EXPECT_EQ(changedBytes(BlockFormat::Dxt3, 2), (std::set{0, 1, 2, 3, 12, 13}));
    EXPECT_EQ(changedBytes(BlockFormat::Dxt3, 3), (std::set{0, 1, 4, 5, 12, 14}));
    // Twelve bits and twelve bits: the first row ends within byte 3.
    EXPECT_EQ(changedBytes(BlockFormat::Dxt5, 2), (std::set{2, 3, 4, 12, 13}));
}

} // namespace
} // namespace texplorer::ui::block_flip_test

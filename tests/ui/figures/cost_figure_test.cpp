// The figure of what textures cost, and its words, with times that were made up.

#include "tests/ui/figures/figure_bench.h"

namespace texplorer::ui::cost_figure_test {
namespace {

using namespace test;
using testing::StartsWith;

/// `pairs` pairs, B being `ratio` times A.
view::CostTimes times(std::size_t pairs, double ratio) {
    return {{std::vector<double>(pairs, 1e-4), std::vector<double>(pairs, 1e-4 * ratio)}};
}

TEST(CostWords, AVerdictNeedsPairsThatAgree) {
    EXPECT_TRUE(verdictOn(view::CostTimes{}).empty());
    EXPECT_EQ(verdictOn(times(21, 3.104)).english(), "B takes 3.10× (3.10–3.10×) the time of A");
    EXPECT_EQ(verdictOn(times(21, 0.5)).english(), "B takes 0.50× (0.50–0.50×) the time of A");
    EXPECT_EQ(verdictOn(times(21, 42.25)).english(), "B takes 42.2× (42.2–42.2×) the time of A");
    EXPECT_THAT(verdictOn(times(21, 1)).english(), StartsWith("no difference shown: 1.00×"));
    EXPECT_THAT(verdictOn(times(1, 3)).english(), StartsWith("1 pair: at least 20"));
    EXPECT_THAT(verdictOn(times(19, 3)).english(), StartsWith("19 pairs: at least 20"));
    EXPECT_EQ(verdictOn(view::CostTimes{{}, "it lacks something"}).english(), "it lacks something");
}

TEST(CostWords, TimesHaveThreeDigits) {
    EXPECT_EQ(view::timeText(1.234e-6).english(), "1.23 µs");
    EXPECT_EQ(view::timeText(9.996e-6).english(), "10.0 µs");
    EXPECT_EQ(view::timeText(99.96e-6).english(), "100 µs");
    EXPECT_EQ(view::timeText(0.0009994).english(), "999 µs");
    EXPECT_EQ(view::timeText(0.0009996).english(), "1.00 ms");
}

TEST(CostWords, SayWhereTheDriverDraws) {
    EXPECT_THAT(view::costLimits("llvmpipe (LLVM 15.0.6, 256 bits)").front().english(),
                StartsWith("llvmpipe draws on the processor"));
    EXPECT_THAT(view::costLimits("NVIDIA H100").front().english(), StartsWith("Only this driver"));
}

TEST(CostWords, ProgressCountsPairs) {
    view::TextureCosts costs;
    EXPECT_EQ(progressOf(costs, 2), 0);
    costs.front() = times(1, 1);
    EXPECT_DOUBLE_EQ(progressOf(costs, 2), 0.5 / static_cast<double>(costs.size()));
    costs.fill({{}, "lacking"});
    EXPECT_EQ(progressOf(costs, 2), 1);
}

class CostFigureTest : public FigureBench {
protected:
    CostFigureTest()
        : FigureBench(Figure::Cost) {}
};

TEST_F(CostFigureTest, HasARowForEachClaim) {
    start(defaultScene(), 1280, 1200);
    show(Figure::Cost);
    for (const view::CostRow& row : view::costRows)
        EXPECT_TRUE(has(fmt::format("cost:{}", row.name))) << row.name;
    EXPECT_TRUE(has("cost:limits"));
}

TEST_F(CostFigureTest, TheButtonAsksForAMeasurementOfTheBoundTexture) {
    EXPECT_FALSE(session->cost.subject);
    click("cost:measure");
    frames(2);
    ASSERT_TRUE(session->cost.subject);
    ASSERT_TRUE(session->cost.subject->levels);
    EXPECT_EQ(session->cost.subject->target, Target::Texture2D);
    EXPECT_TRUE(has("cost:progress"));
    session->cost.costs.front() = times(3, 2);
    click("cost:cancel");
    frames(2);
    EXPECT_FALSE(session->cost.subject);
    EXPECT_EQ(session->cost.costs.front().times.a.size(), 3U) << "what is measured stays";
    click("cost:measure");
    frames(2);
    EXPECT_TRUE(session->cost.costs.front().times.a.empty()) << "it starts again";
}

TEST_F(CostFigureTest, WithoutATextureTheOtherRowsAreMeasured) {
    scene().textures.clear();
    frames(3);
    click("cost:measure");
    frames(2);
    ASSERT_TRUE(session->cost.subject);
    EXPECT_FALSE(session->cost.subject->levels);
    EXPECT_FALSE(session->cost.subject->lack.empty());
}

TEST_F(CostFigureTest, WithoutFixedFunctionNothingCanBeMeasured) {
    session->view.offered.withhold(RendererKind::Fixed, "a core profile");
    frames(2);
    click("cost:measure");
    frames(2);
    EXPECT_FALSE(session->cost.subject);
}

TEST_F(CostFigureTest, IsSoundWithEveryKindOfResult) {
    session->cost.costs = {times(21, 40), times(21, 1), times(21, 0.001), times(2, 3)};
    session->cost.costs[4] = {{}, "the driver has no S3TC"};
    frames(3);
    expectSoundFrame();
}

} // namespace
} // namespace texplorer::ui::cost_figure_test

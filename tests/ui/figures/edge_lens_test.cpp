#include "tests/ui/figures/figure_bench.h"

namespace texplorer::ui::edge_lens_test {
namespace {

using namespace test;

class EdgeLens : public FigureBench {
protected:
    EdgeLens()
        : FigureBench(Figure::Edge) {}

    [[nodiscard]] EdgeLensState& state() { return figures().edge; }
    void read(float s) {
        state().s = s;
        frames(2);
    }
};

TEST_F(EdgeLens, AClickOnAStripTakesItsWrapModeInOneStep) {
    for (const EnumRow& mode : wrapRows) {
        click(fmt::format("edge:{}", mode.name));
        EXPECT_EQ(static_cast<std::uint32_t>(texture().wrapS), mode.value) << mode.name;
    }
    EXPECT_EQ(texture().wrapT, Wrap::Repeat) << "t has a mode of its own";
    key('Z', {ctrl});
    EXPECT_EQ(texture().wrapS, static_cast<Wrap>(wrapRows[wrapRows.size() - 2].value));
}

TEST_F(EdgeLens, ThePointerOnAStripPreviewsIt) {
    moveTo(place("edge:GL_CLAMP_TO_EDGE"));
    frames(2);
    ASSERT_TRUE(session->look.preview);
    EXPECT_EQ(session->look.preview->scene->textures[0].wrapS, Wrap::ClampToEdge);
    EXPECT_EQ(texture().wrapS, Wrap::Repeat);
}

// 4 texels, GL_CLAMP, s = -0.5: u = 0, so half of texel -1, which is border, and half of texel 0.
TEST_F(EdgeLens, SaysWhichTexelsAreMixed) {
    texture().wrapS = Wrap::Clamp;
    read(-0.5F);
    expectAll({"edge:u 0.00", "edge:tap -1 0.50", "edge:tap 0 0.50", "edge:border 0.50"});
    texture().wrapS = Wrap::ClampToBorder;
    frames(2);
    EXPECT_TRUE(has("edge:border 1.00"));
    texture().wrapS = Wrap::Repeat; // u = 2: half of texels 1 and 2
    frames(2);
    expectAll({"edge:tap 1 0.50", "edge:tap 2 0.50", "edge:border 0.00"});
}

TEST_F(EdgeLens, TheFilterIsTheScenes) {
    texture().magFilter = MagFilter::Nearest;
    texture().wrapS = Wrap::Clamp;
    read(-0.5F);
    expectAll({"edge:tap 0 1.00", "edge:border 0.00"});
    click("textures[0].magFilter=GL_LINEAR");
    EXPECT_EQ(texture().magFilter, MagFilter::Linear);
    EXPECT_TRUE(has("edge:border 0.50"));
}

TEST_F(EdgeLens, ADragReadsACoordinate) {
    const auto lens = places.items.find("edge:lens")->second; // a copy: the next frame has its own
    const ImVec2 right(lens.right - 1, (lens.top + lens.bottom) / 2);
    drag(right, {-2, 0});
    EXPECT_GT(state().s, 1.9F);
    drag(right, {lens.left - lens.right, 0});
    EXPECT_EQ(state().s, -1) << "not beyond the drawing";
}

TEST_F(EdgeLens, TheRowHasTwoFourOrEightTexels) {
    read(0.25F); // u = 1 of 4: texels 0 and 1
    EXPECT_TRUE(has("edge:tap 0 0.50"));
    click("edge:size 8"); // u = 2: texels 1 and 2
    EXPECT_EQ(state().size, 8);
    EXPECT_TRUE(has("edge:tap 2 0.50"));
    click("edge:size 2"); // u = 0.5: the centre of texel 0
    EXPECT_TRUE(has("edge:tap 0 1.00"));
}

TEST_F(EdgeLens, WithoutATextureSaysWhatToDo) {
    scene().textures.clear();
    frames(3);
    EXPECT_FALSE(has("edge:lens"));
}

} // namespace
} // namespace texplorer::ui::edge_lens_test

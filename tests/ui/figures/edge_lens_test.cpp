#include "app/ui/figures/edge_lens.h"
#include "tests/ui/workbench.h"

#include <fmt/core.h>

namespace texplorer::ui::edge_lens_test {
namespace {

using namespace test;

class EdgeLens : public Workbench {
protected:
    void open(MagFilter filter = MagFilter::Linear) {
        Scene start;
        start.models.resize(1);
        start.textures.resize(1);
        start.textures[0].magFilter = filter;
        start.textures[0].minFilter = MinFilter::Linear;
        start.passes[0].units[0].enabled = true;
        this->start(std::move(start));
        session->window.figure = Figure::Edge;
        session->window.wantedTab = Tab::Figures;
        frames(3);
    }
    /// Presses where s is so much.
    void read(float s) {
        states.details.figures.edge.s = s;
        frames(2);
    }
};

TEST_F(EdgeLens, AClickOnAStripTakesItsWrapModeInOneStep) {
    open();
    for (const EnumRow& mode : wrapRows) {
        click(fmt::format("edge:{}", mode.name));
        EXPECT_EQ(static_cast<std::uint32_t>(texture().wrapS), mode.value) << mode.name;
    }
    EXPECT_EQ(texture().wrapT, Wrap::Repeat) << "t has a mode of its own";
    key('Z', {ctrl});
    EXPECT_EQ(texture().wrapS, static_cast<Wrap>(wrapRows[wrapRows.size() - 2].value));
}

TEST_F(EdgeLens, ThePointerOnAStripPreviewsIt) {
    open();
    moveTo(place("edge:GL_CLAMP_TO_EDGE"));
    frames(2);
    ASSERT_TRUE(session->look.preview);
    EXPECT_EQ(session->look.preview->scene->textures[0].wrapS, Wrap::ClampToEdge);
    EXPECT_EQ(texture().wrapS, Wrap::Repeat);
}

// 4 texels, GL_CLAMP, s = -0.5: u = 0, so half of texel -1, which is border, and half of texel 0.
TEST_F(EdgeLens, SaysWhichTexelsAreMixed) {
    open();
    texture().wrapS = Wrap::Clamp;
    read(-0.5F);
    EXPECT_TRUE(has("edge:u 0.00"));
    EXPECT_TRUE(has("edge:tap -1 0.50"));
    EXPECT_TRUE(has("edge:tap 0 0.50"));
    EXPECT_TRUE(has("edge:border 0.50"));
    texture().wrapS = Wrap::ClampToBorder;
    frames(2);
    EXPECT_TRUE(has("edge:border 1.00"));
    texture().wrapS = Wrap::Repeat; // u = 2: half of texels 1 and 2
    frames(2);
    EXPECT_TRUE(has("edge:tap 1 0.50"));
    EXPECT_TRUE(has("edge:tap 2 0.50"));
    EXPECT_TRUE(has("edge:border 0.00"));
}

TEST_F(EdgeLens, TheFilterIsTheScenes) {
    open(MagFilter::Nearest);
    texture().wrapS = Wrap::Clamp;
    read(-0.5F);
    EXPECT_TRUE(has("edge:tap 0 1.00"));
    EXPECT_TRUE(has("edge:border 0.00"));
    click("textures[0].magFilter=GL_LINEAR");
    EXPECT_EQ(texture().magFilter, MagFilter::Linear);
    EXPECT_TRUE(has("edge:border 0.50"));
}

TEST_F(EdgeLens, ADragReadsACoordinate) {
    open();
    const auto lens = places.items.find("edge:lens")->second; // a copy: the next frame has its own
    const ImVec2 right(lens.right - 1, (lens.top + lens.bottom) / 2);
    drag(right, {-2, 0});
    EXPECT_GT(states.details.figures.edge.s, 1.9F);
    drag(right, {lens.left - lens.right, 0});
    EXPECT_EQ(states.details.figures.edge.s, -1) << "not beyond the drawing";
}

TEST_F(EdgeLens, TheRowHasTwoFourOrEightTexels) {
    open();
    read(0.25F); // u = 1 of 4: texels 0 and 1
    EXPECT_TRUE(has("edge:tap 0 0.50"));
    click("edge:size 8"); // u = 2: texels 1 and 2
    EXPECT_EQ(states.details.figures.edge.size, 8);
    EXPECT_TRUE(has("edge:tap 2 0.50"));
    click("edge:size 2"); // u = 0.5: the centre of texel 0
    EXPECT_TRUE(has("edge:tap 0 1.00"));
}

TEST_F(EdgeLens, WithoutATextureSaysWhatToDo) {
    open();
    scene().textures.clear();
    frames(3);
    EXPECT_FALSE(has("edge:lens"));
}

TEST_F(EdgeLens, FitsWhateverRoomItHas) {
    for (const auto& [width, height, scale] :
         {std::tuple(1280, 800, 1.0F), std::tuple(1024, 700, 1.5F), std::tuple(700, 500, 2.0F)}) {
        open();
        start(scene(), width, height, scale);
        session->window.figure = Figure::Edge;
        session->window.wantedTab = Tab::Figures;
        frames(4);
        EXPECT_TRUE(has("edge:lens"));
        expectSoundFrame();
    }
}

} // namespace
} // namespace texplorer::ui::edge_lens_test

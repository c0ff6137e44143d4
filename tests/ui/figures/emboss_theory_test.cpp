#include "app/ui/figures/emboss_theory.h"
#include "tests/ui/workbench.h"
#include "texplorer/lesson/example.h"

#include <cmath>

namespace texplorer::ui::emboss_theory_test {
namespace {

using namespace test;

class EmbossTheory : public Workbench {
protected:
    void open(Scene scene, int width = 1280, int height = 800, float scale = 1) {
        start(std::move(scene), width, height, scale);
        session->window.figure = Figure::Emboss;
        session->window.wantedTab = Tab::Figures;
        frames(4);
    }
    static Scene nehe() { return *exampleScene("nehe-bumps-2-units.json"); }
    [[nodiscard]] EmbossTheoryState& state() { return states.details.figures.emboss; }
    [[nodiscard]] Emboss& emboss() { return scene().passes[0].units[1].emboss; }
};

// 30 degrees and MAX_EMBOSS 0.2: ds = 0.1. On the block's flat top at 0.7 both heights are 0.8.
TEST_F(EmbossTheory, WorksOutAPlace) {
    open(nehe());
    emboss().depth = 0.2F;
    state().angle = 30;
    state().s = 0.7F;
    frames(2);
    EXPECT_TRUE(has("emboss:ds 0.1000"));
    EXPECT_TRUE(has("emboss:h0 0.80"));
    EXPECT_TRUE(has("emboss:h1 0.80"));
    EXPECT_TRUE(has("emboss:grey 0.50"));
    state().s = 0.5F; // flat ground, 0.2; at 0.6 the block's side, of 0.05, has climbed 0.02 of it: 0.44
    frames(2);
    EXPECT_TRUE(has("emboss:h0 0.20"));
    EXPECT_TRUE(has("emboss:h1 0.44"));
    EXPECT_TRUE(has("emboss:grey 0.38"));
    state().angle = -30; // at 0.4 it is flat, but for the foot of the bump
    frames(2);
    EXPECT_TRUE(has("emboss:ds -0.1000"));
    EXPECT_TRUE(has("emboss:grey 0.50"));
}

TEST_F(EmbossTheory, MaxEmbossIsTheScenes) {
    open(nehe());
    const float before = emboss().depth;
    const ImVec2 at = place("emboss:depth");
    drag(at, {10, 0});
    EXPECT_GT(emboss().depth, before);
    key('Z', {ctrl});
    EXPECT_EQ(emboss().depth, before) << "one step";
}

TEST_F(EmbossTheory, WithoutEmbossingItHasADepthOfItsOwn) {
    open(defaultScene());
    const Scene before = scene();
    drag(place("emboss:depth"), {10, 0});
    EXPECT_GT(state().depth, EmbossTheoryState{}.depth);
    EXPECT_EQ(scene(), before);
}

TEST_F(EmbossTheory, TheSunAndThePlaceAreDragged) {
    open(nehe());
    drag(place("emboss:sun"), {-300, 0});
    EXPECT_LT(state().angle, 0);
    const auto box = places.items.find("emboss:heights")->second; // a copy: the next frame has its own
    const float y = box.bottom - 3;
    drag({box.left + (box.right - box.left) * 0.25F, y}, {(box.right - box.left) * 0.25F, 0});
    EXPECT_NEAR(state().s, 0.5F, 0.01F);
}

TEST_F(EmbossTheory, TheBricksAreTheProgramsImage) {
    open(nehe());
    click("emboss:bricks");
    ASSERT_TRUE(state().profile);
    EXPECT_EQ(state().profile->heights.size(), 256U);
    EXPECT_NE(state().profile->heights, sketchedProfile().heights);
    click("emboss:sketch");
    EXPECT_EQ(state().profile->heights, sketchedProfile().heights);
}

TEST_F(EmbossTheory, FitsWhateverRoomItHas) {
    for (const auto& [width, height, scale] :
         {std::tuple(1280, 800, 1.0F), std::tuple(1024, 700, 1.5F), std::tuple(700, 500, 2.0F)}) {
        open(nehe(), width, height, scale);
        EXPECT_TRUE(has("emboss:heights"));
        expectSoundFrame();
    }
}

} // namespace
} // namespace texplorer::ui::emboss_theory_test

#include "tests/ui/figures/figure_bench.h"
#include "texplorer/lesson/example.h"

namespace texplorer::ui::emboss_theory_test {
namespace {

using namespace test;

class EmbossTheory : public FigureBench {
protected:
    EmbossTheory() { show(*exampleScene("nehe-bumps-2-units.json")); }

    void show(Scene scene) {
        start(std::move(scene));
        FigureBench::show(Figure::Emboss);
    }
    [[nodiscard]] EmbossTheoryState& state() { return figures().emboss; }
    [[nodiscard]] Emboss& emboss() { return scene().passes[0].units[1].emboss; }
    void read(float s, std::initializer_list<const char*> lines) {
        state().s = s;
        frames(2);
        expectAll(lines);
    }
};

// 30 degrees and MAX_EMBOSS 0.2: ds = 0.1. On the block's flat top at 0.7 both heights are 0.8.
TEST_F(EmbossTheory, WorksOutAPlace) {
    emboss().depth = 0.2F;
    state().angle = 30;
    read(0.7F, {"emboss:ds 0.1000", "emboss:h0 0.80", "emboss:h1 0.80", "emboss:grey 0.50"});
    // Flat ground, 0.2; at 0.6 the block's side, of 0.05, has climbed 0.02 of it: 0.44.
    read(0.5F, {"emboss:h0 0.20", "emboss:h1 0.44", "emboss:grey 0.38"});
    state().angle = -30; // at 0.4 it is flat, but for the foot of the bump
    read(0.5F, {"emboss:ds -0.1000", "emboss:grey 0.50"});
}

TEST_F(EmbossTheory, MaxEmbossIsTheScenes) {
    const float before = emboss().depth;
    drag(place("emboss:depth"), {10, 0});
    EXPECT_GT(emboss().depth, before);
    key('Z', {ctrl});
    EXPECT_EQ(emboss().depth, before) << "one step";
}

TEST_F(EmbossTheory, WithoutEmbossingItHasADepthOfItsOwn) {
    show(defaultScene());
    const Scene before = scene();
    drag(place("emboss:depth"), {10, 0});
    EXPECT_GT(state().depth, EmbossTheoryState{}.depth);
    EXPECT_EQ(scene(), before);
}

TEST_F(EmbossTheory, TheSunAndThePlaceAreDragged) {
    drag(place("emboss:sun"), {-300, 0});
    EXPECT_LT(state().angle, 0);
    const auto box = places.items.find("emboss:heights")->second; // a copy: the next frame has its own
    const float y = box.bottom - 3;
    drag({box.left + (box.right - box.left) * 0.25F, y}, {(box.right - box.left) * 0.25F, 0});
    EXPECT_NEAR(state().s, 0.5F, 0.01F);
}

TEST_F(EmbossTheory, TheBricksAreTheProgramsImage) {
    click("emboss:bricks");
    ASSERT_TRUE(state().profile);
    EXPECT_EQ(state().profile->heights.size(), 256U);
    EXPECT_NE(state().profile->heights, sketchedProfile().heights);
    click("emboss:sketch");
    EXPECT_EQ(state().profile->heights, sketchedProfile().heights);
}

} // namespace
} // namespace texplorer::ui::emboss_theory_test

#include "app/ui/files/replaced_document.h"
#include "app/ui/model/explaining.h"
#include "app/ui/model/level_view.h"
#include "tests/ui/workbench.h"
#include "texplorer/image/mip_colors.h"

#include <array>
#include <cmath>

namespace texplorer::ui::levels_tab_test {
namespace {

using namespace test;

class LevelsTab : public Workbench {
protected:
    /// With a square of 64 x 64 texels, seen from far away.
    LevelsTab() {
        Scene start;
        start.view.azimuth = start.view.elevation = 0;
        start.models.resize(1);
        start.models[0].shape = Shape::Quad;
        start.textures.resize(1);
        start.textures[0].pattern = Pattern::Checker;
        start.textures[0].mipmaps = MipPolicy::Generated;
        start.textures[0].minFilter = MinFilter::LinearMipmapLinear;
        start.passes[0].units[0].enabled = true;
        this->start(std::move(start));
        scene().view.distance = 60; // after the camera was fitted
        show();
    }
    void show() {
        session->window.wantedTab = Tab::Levels;
        frames(4);
    }
    void dragTo(std::string_view handle, int level) {
        drag(place(handle), {middleOf("levels:picture " + std::to_string(level)) - place(handle).x, 0});
    }
    /// With a max level of 5, clicks a level, which is then read alone.
    void readAloneOf5(int level) {
        texture().maxLevel = 5;
        frames(2);
        click("levels:level " + std::to_string(level));
    }
    void expectRange(int base, int max) {
        EXPECT_EQ(texture().baseLevel, base);
        EXPECT_EQ(texture().maxLevel, max);
    }
    [[nodiscard]] ImVec2 middleOfTheView() const {
        return {static_cast<float>(layout.picture.x) + static_cast<float>(layout.picture.width) / 2,
                static_cast<float>(layout.picture.y) + static_cast<float>(layout.picture.height) / 2};
    }
    [[nodiscard]] float widthOf(std::string_view name) const {
        const auto& item = places.items.find(name)->second;
        return item.right - item.left;
    }
    [[nodiscard]] float middleOf(std::string_view name) const {
        return places.items.find(name)->second.left + widthOf(name) / 2;
    }
    [[nodiscard]] int lastLevel() const {
        int last = 0;
        while (has("levels:level " + std::to_string(last + 1)))
            ++last;
        return last;
    }
};

TEST_F(LevelsTab, HasAllLevelsAtTheirTrueRelativeSizes) {
    const int last = lastLevel();
    ASSERT_GE(last, 5);
    for (int level = 1; level <= last; ++level) {
        const std::string larger = "levels:picture " + std::to_string(level - 1);
        const std::string smaller = "levels:picture " + std::to_string(level);
        EXPECT_NEAR(widthOf(smaller), std::max(1.0F, widthOf(larger) / 2), 1) << level;
        EXPECT_GT(middleOf(smaller), middleOf(larger));
    }
    EXPECT_TRUE(has("levels:hint"));
    EXPECT_FALSE(has("levels:pixel"));
    click("levels:equal");
    EXPECT_NEAR(widthOf("levels:picture 0"), widthOf("levels:picture " + std::to_string(last)), 1);
}

TEST_F(LevelsTab, MarksTheLevelsOfThePixelUnderThePointer) {
    moveTo(middleOfTheView());
    const reference::PixelLevels* levels = askedLevels(*session);
    ASSERT_NE(levels, nullptr);
    ASSERT_GT(levels->lambda, 0.5F) << "minified";
    EXPECT_TRUE(has("levels:pixel"));
    EXPECT_TRUE(has("levels:read " + std::to_string(levels->first)));
    EXPECT_TRUE(has("levels:read " + std::to_string(levels->second)));
    EXPECT_FALSE(has("levels:read " + std::to_string(lastLevel())));
    // λ is shown between the two levels, at the position of its fraction.
    const float first = middleOf("levels:picture " + std::to_string(levels->first));
    const float second = middleOf("levels:picture " + std::to_string(levels->second));
    EXPECT_NEAR(middleOf("levels:lambda"), std::lerp(first, second, levels->share), 1.5F);
    moveTo({static_cast<float>(layout.picture.x + 12), static_cast<float>(layout.picture.y + 12)});
    EXPECT_EQ(askedLevels(*session), nullptr) << "the background";
    EXPECT_FALSE(has("levels:lambda"));
}

TEST_F(LevelsTab, MarksTheLevelsOfTheProbedPixel) {
    session->look.explaining.pixel = {layout.picture.width / 2, layout.picture.height / 2};
    moveTo({3, 3});
    ASSERT_NE(askedLevels(*session), nullptr);
    ASSERT_NE(probedUnit(*session), nullptr);
    EXPECT_EQ(askedLevels(*session)->lambda, probedUnit(*session)->sample.lod.lambda);
    EXPECT_TRUE(has("levels:lambda"));
}

TEST_F(LevelsTab, AClickReadsALevelAloneAndTheNextOneLetsGo) {
    readAloneOf5(3);
    expectRange(3, 3);
    EXPECT_TRUE(has("levels:remark"));
    click("levels:level 1"); // from one to the next
    expectRange(1, 1);
    click("levels:level 1");
    expectRange(0, 5); // what was there first
    key('Z', {ctrl});
    EXPECT_EQ(texture().baseLevel, 1);
    key('Z', {ctrl});
    EXPECT_EQ(texture().maxLevel, 3) << "each click is a step";
    texture().baseLevel = texture().maxLevel = 2; // by another control
    frames(2);
    click("levels:level 2");
    expectRange(0, 1000);
}

TEST_F(LevelsTab, TheHandlesLimitTheLevels) {
    dragTo("levels:base", 1);
    EXPECT_EQ(texture().baseLevel, 1);
    dragTo("levels:max", 3);
    EXPECT_EQ(texture().maxLevel, 3);
    drag(place("levels:base"), {900, 0});
    EXPECT_EQ(texture().baseLevel, 3) << "not beyond the last that is read";
    key('Z', {ctrl});
    EXPECT_EQ(texture().baseLevel, 1) << "a drag is one step";
    drag(place("levels:max"), {900, 0});
    EXPECT_EQ(texture().maxLevel, 1000) << "at the last level there is no limit";
    drag(place("levels:base"), {-900, 0});
    EXPECT_EQ(texture().baseLevel, 0);
}

TEST_F(LevelsTab, TheScaleLimitsLambda) {
    dragTo("levels:min lod", 1);
    EXPECT_NEAR(texture().minLod, 1, 0.1F);
    dragTo("levels:max lod", 2);
    EXPECT_NEAR(texture().maxLod, 2, 0.1F);
    moveTo(middleOfTheView());
    ASSERT_NE(askedLevels(*session), nullptr);
    EXPECT_LE(askedLevels(*session)->lambda, texture().maxLod);
    EXPECT_GE(askedLevels(*session)->lambda, texture().minLod);
    drag(place("levels:min lod"), {-900, 0});
    EXPECT_EQ(texture().minLod, -1000);
    drag(place("levels:max lod"), {900, 0});
    EXPECT_EQ(texture().maxLod, 1000);
    key('Z', {ctrl});
    EXPECT_NEAR(texture().maxLod, 2, 0.1F) << "a drag is one step";
}

TEST_F(LevelsTab, BothBiasesMoveLambdaAndEverythingGoesBack) {
    moveTo(middleOfTheView());
    const float before = askedLevels(*session)->lambda;
    EXPECT_FALSE(has("levels:unbiased"));
    drag(place("levels:texture bias"), {20, 0});
    EXPECT_GT(texture().lodBias, 0);
    drag(place("levels:unit bias"), {-10, 0});
    EXPECT_LT(unit().lodBias, 0);
    moveTo(middleOfTheView());
    EXPECT_NEAR(askedLevels(*session)->lambda, before + texture().lodBias + unit().lodBias, 1e-3F);
    EXPECT_TRUE(has("levels:unbiased"));
    texture().minLod = 1;
    texture().maxLevel = 3;
    frames(2);
    click("levels:all");
    EXPECT_EQ(texture().lodBias, 0);
    EXPECT_EQ(unit().lodBias, 0);
    EXPECT_EQ(texture().minLod, -1000);
    EXPECT_EQ(texture().maxLevel, 1000);
    const Scene clean = scene();
    click("levels:all");
    EXPECT_EQ(scene(), clean) << "there is nothing left to take back";
}

TEST_F(LevelsTab, TheWheelEnlarges) {
    const float width = widthOf("levels:picture 2");
    wheel(place("levels:level 2"), 3);
    EXPECT_NEAR(widthOf("levels:picture 2"), width * 1.25F * 1.25F * 1.25F, 2);
    wheel(place("levels:level 2"), -10);
    EXPECT_NEAR(widthOf("levels:picture 2"), width, 1);
}

TEST_F(LevelsTab, SaysWhyLessIsReadThanThereIs) {
    EXPECT_FALSE(has("levels:remark"));
    texture().minFilter = MinFilter::Linear;
    frames(2);
    EXPECT_TRUE(has("levels:remark"));
    texture().minFilter = MinFilter::LinearMipmapLinear;
    texture().mipmaps = MipPolicy::None;
    frames(2);
    EXPECT_TRUE(has("levels:incomplete"));
    EXPECT_FALSE(has("levels:level 1"));
    texture().minFilter = MinFilter::Linear;
    frames(2);
    EXPECT_FALSE(has("levels:incomplete"));
    EXPECT_TRUE(has("levels:remark")) << "there is one level";
    texture().mipmaps = MipPolicy::Missing;
    texture().minFilter = MinFilter::LinearMipmapLinear;
    frames(2);
    EXPECT_TRUE(has("levels:incomplete"));
    EXPECT_GE(lastLevel(), 5) << "the one that is missing has its place";
    ASSERT_TRUE(has("levels:fix Generate mipmaps"));
    click("levels:fix Generate mipmaps");
    EXPECT_EQ(texture().mipmaps, MipPolicy::Generated);
    EXPECT_FALSE(has("levels:incomplete"));
    unit().enabled = false;
    frames(2);
    EXPECT_TRUE(has("levels:remark"));
    EXPECT_EQ(levelMapOf(*session), nullptr);
    scene().textures.clear();
    frames(2);
    EXPECT_TRUE(has("levels:none"));
}

TEST_F(LevelsTab, ShowsLinesVolumesAndFaces) {
    for (const Target target : {Target::Texture1D, Target::Texture3D, Target::CubeMap}) {
        unit().target = target;
        frames(3);
        EXPECT_TRUE(has("levels:level 3")) << static_cast<int>(target);
        expectSoundFrame();
    }
}

// Each level in its own colour, with the flag next to its number.
TEST_F(LevelsTab, ShowsTheTexelsOfEachLevel) {
    texture().mipmaps = MipPolicy::Colored;
    texture().pattern = Pattern::MipColors;
    frames(2);
    const Image window = picture();
    for (int level = 0; level < 4; ++level) {
        const auto& item = places.items.find("levels:picture " + std::to_string(level))->second;
        const int x = static_cast<int>((item.left + item.right) / 2);
        const int y = window.height - 1 - static_cast<int>((item.top + item.bottom) / 2);
        const auto color = mipColor(level);
        for (std::size_t i = 0; i < 3; ++i)
            EXPECT_NEAR(std::to_integer<int>(window.at(x, y)[i]), color[i], 1) << level;
    }
}

// The other dock is drawn after this one in the same frame.
TEST_F(LevelsTab, RemembersTheRangeInTheRightDock) {
    moveTab(session->settings.workspace, Tab::Levels, Dock::Right);
    frames(1);
    readAloneOf5(3);
    ASSERT_EQ(texture().maxLevel, 3);
    click("levels:level 3");
    expectRange(0, 5);
}

// Another scene's texture may also use a single level: the earlier range belongs to the old scene.
TEST_F(LevelsTab, AnotherSceneKnowsNothingOfTheLevelsFromBefore) {
    readAloneOf5(3);
    replaceDocument(*session, Document{Scene(scene()), ImageSource{}});
    show();
    ASSERT_EQ(texture().baseLevel, 3);
    click("levels:level 3");
    expectRange(0, 1000); // OpenGL's, not 5
}

TEST_F(LevelsTab, AnotherTextureKnowsNothingOfTheLevelsFromBefore) {
    scene().textures.push_back(texture());
    readAloneOf5(3);
    ASSERT_TRUE(session->document.forced);
    unit().texture = 1;
    frames(1);
    EXPECT_FALSE(session->document.forced);
    unit().texture = 0;
    texture().baseLevel = 2;
    texture().maxLevel = 3;
    frames(1);
    texture().baseLevel = 3; // by another control
    frames(2);
    click("levels:level 3");
    EXPECT_EQ(texture().maxLevel, 1000);
}

// +x of this pattern is red, +y green and +z blue.
TEST_F(LevelsTab, OfACubeMapEachFaceCanBeShown) {
    EXPECT_FALSE(has("levels:face +x")) << "a square has none";
    texture().pattern = Pattern::CubeFaces;
    unit().target = Target::CubeMap;
    frames(3);
    const auto meanOf = [&] {
        const Image window = picture();
        const WidgetPlaces::Item& item = places.items.at("levels:picture 0");
        std::array<long, 3> sum{};
        for (int y = static_cast<int>(item.top); y < static_cast<int>(item.bottom); ++y)
            for (int x = static_cast<int>(item.left); x < static_cast<int>(item.right); ++x)
                for (std::size_t i = 0; i < sum.size(); ++i)
                    sum.at(i) += std::to_integer<int>(window.at(x, window.height - 1 - y)[i]);
        return sum;
    };
    const std::array<long, 3> plusX = meanOf();
    EXPECT_GT(plusX[0], plusX[1]);
    click("levels:face +y");
    EXPECT_EQ(states.details.levels.face, 2);
    const std::array<long, 3> plusY = meanOf();
    EXPECT_GT(plusY[1], plusY[0]);
    unit().target = Target::Texture2D;
    frames(2);
    unit().target = Target::CubeMap;
    frames(2);
    EXPECT_EQ(states.details.levels.face, 2) << "remembered";
}

TEST_F(LevelsTab, IsSoundInEverySize) {
    for (const auto& [width, height, scale] :
         {std::tuple(1024, 700, 1.0F), {1920, 1080, 1.5F}, {3840, 2160, 2.0F}}) {
        start(scene(), width, height, scale);
        show();
        EXPECT_TRUE(has("levels:level 0"));
        expectSoundFrame();
    }
}

} // namespace
} // namespace texplorer::ui::levels_tab_test

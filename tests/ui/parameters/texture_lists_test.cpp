// The lists of a texture: the steps of its preparation and its individual levels.

#include "tests/ui/workbench.h"

#include <gmock/gmock.h>

namespace texplorer::ui::texture_lists_test {
namespace {

using namespace test;

class TextureLists : public Workbench {
protected:
    void press(std::string_view name) {
        scrollTo(name);
        click(name);
    }
};

TEST_F(TextureLists, AStepIsAddedAndShowsItsPicture) {
    press("add step");
    click("add step:invert");
    ASSERT_EQ(texture().preparation.size(), 1U);
    EXPECT_EQ(texture().preparation[0].op, ImageOp::Invert);
    frames(2);
    EXPECT_TRUE(has("picture:textures[0].preparation[0]"));
    EXPECT_TRUE(has("picture:textures[0].source"));
    EXPECT_FALSE(has("textures[0].preparation[0].factor[0]")) << "it does not use it";
    key('Z', {ctrl});
    EXPECT_TRUE(texture().preparation.empty());
}

TEST_F(TextureLists, AStepShowsItsOwnParametersAlone) {
    const auto shows = [&](std::string_view key) {
        return has("textures[0].preparation[0]." + std::string(key));
    };
    texture().preparation = {{.op = ImageOp::Swizzle}};
    scrollTo("add step");
    EXPECT_TRUE(shows("red"));
    EXPECT_FALSE(shows("source")) << "no component is the other image's";
    EXPECT_FALSE(shows("share"));
    texture().preparation[0].alpha = ComponentSource::OtherRed;
    scrollTo("add step");
    EXPECT_TRUE(shows("source"));
    texture().preparation = {{.op = ImageOp::Resize}};
    scrollTo("add step");
    EXPECT_TRUE(shows("share"));
    EXPECT_FALSE(shows("red"));
}

TEST_F(TextureLists, AFringeIsRemovedByAStep) {
    scene() = [] {
        Scene fringe = defaultScene();
        EXPECT_TRUE(applyPreset(*findPreset("fringe"), fringe));
        return fringe;
    }();
    frames(2);
    const std::size_t before = texture().preparation.size();
    press("textures[0].preparation#problem");
    click("textures[0].preparation#fix:Spread colours");
    ASSERT_EQ(texture().preparation.size(), before + 1);
    EXPECT_EQ(texture().preparation.back().op, ImageOp::Spread);
    frames(2);
    EXPECT_FALSE(has("textures[0].preparation#problem"));
}

TEST_F(TextureLists, StepsChangePlacesAndGo) {
    texture().preparation = {{.op = ImageOp::Invert}, {.op = ImageOp::Sharpen}};
    frames(2);
    press("textures[0].preparation[1]#up");
    EXPECT_EQ(texture().preparation[0].op, ImageOp::Sharpen);
    press("textures[0].preparation[0]#remove");
    ASSERT_EQ(texture().preparation.size(), 1U);
    EXPECT_EQ(texture().preparation[0].op, ImageOp::Invert);
}

TEST_F(TextureLists, LevelsAreAddedDownToTheLast) {
    EXPECT_FALSE(has("levels:add all")) << "they are not wanted yet";
    texture().mipmaps = MipPolicy::Given;
    frames(2);
    press("levels:add");
    EXPECT_EQ(texture().levels.size(), 1U);
    press("levels:add all");
    EXPECT_EQ(texture().levels.size(), 6U) << "below 64 × 64 texels";
    scrollTo("textures[0].levels[0]#remove");
    frames(2);
    EXPECT_TRUE(has("picture:textures[0].levels[0]"));
    EXPECT_TRUE(has("level extents:1"));
}

TEST_F(TextureLists, ALevelAsksForItsFile) {
    texture().mipmaps = MipPolicy::Given;
    texture().levels.resize(2);
    frames(2);
    choose("textures[0].levels[1].source", "file");
    EXPECT_EQ(session->asking.dialog, Dialog::OpenImage);
    EXPECT_EQ(session->asking.imageParam, "textures[0].levels[1].file");
    EXPECT_EQ(texture().levels[1].source, SourceKind::Pattern);
}

} // namespace
} // namespace texplorer::ui::texture_lists_test

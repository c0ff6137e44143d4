#include "app/ui/parameters/sections.h"
#include "tests/ui/workbench.h"

namespace texplorer::ui::unit_bar_test {
namespace {

using namespace test;

class UnitBar : public Workbench {};

TEST_F(UnitBar, IsThereWhateverTabIsInFront) {
    for (const ParameterTabRow& tab : parameterTabRows) {
        click(std::string("parameters:") + tab.label);
        EXPECT_EQ(states.parameters.tab, tab.tab);
        EXPECT_TRUE(places.items.at("unit:2").visible) << tab.label;
    }
    click("unit:2");
    EXPECT_EQ(session->look.selection.unit, 2);
}

TEST_F(UnitBar, ShowsTheTextureOfEachUnit) {
    EXPECT_TRUE(has("picture:unit 0"));
    EXPECT_TRUE(has("picture:unit 1"));
    scene().passes[0].units[1].texture = 7;
    frames(2);
    EXPECT_FALSE(has("picture:unit 1")) << "there is no such texture";
}

TEST_F(UnitBar, AUnitGetsATextureOfItsOwnTheFirstTime) {
    click("unit:1 on");
    EXPECT_EQ(session->look.selection.unit, 1);
    ASSERT_EQ(scene().textures.size(), 2U);
    const auto second = [&]() -> const Unit& { return scene().passes[0].units[1]; };
    EXPECT_TRUE(second().enabled);
    EXPECT_EQ(second().texture, 1);
    EXPECT_NE(scene().textures[1].pattern, scene().textures[0].pattern);
    EXPECT_EQ(scene().textures[1].mipmaps, MipPolicy::Generated) << "it is complete";
    click("unit:1 on");
    EXPECT_FALSE(second().enabled);
    click("unit:1 on");
    EXPECT_EQ(scene().textures.size(), 2U) << "now it has one";
    click("unit:2 on");
    ASSERT_EQ(scene().textures.size(), 3U);
    EXPECT_NE(scene().textures[2].pattern, scene().textures[1].pattern);
    for (int i = 0; i < 4; ++i)
        key('Z', {ctrl});
    EXPECT_EQ(scene().textures.size(), 1U);
    EXPECT_EQ(scene(), session->document.saved);
}

TEST_F(UnitBar, AUnitThatWasSetUpKeepsWhatItWasGiven) {
    scene().passes[0].units[1].envMode = EnvMode::Add;
    frames(2);
    click("unit:1 on");
    EXPECT_EQ(scene().textures.size(), 1U);
    EXPECT_EQ(scene().passes[0].units[1].texture, 0);
    EXPECT_TRUE(has("shares texture"));
}

TEST_F(UnitBar, WhereThereIsNoRoomForATextureItShares) {
    scene().textures.resize(maxTextures);
    frames(2);
    click("unit:1 on");
    EXPECT_EQ(scene().textures.size(), maxTextures);
    EXPECT_TRUE(scene().passes[0].units[1].enabled);
    scene().passes[0].units[2].texture = maxTextures + 3; // as no file can have it
    frames(2);
    click("unit:2 on");
    EXPECT_FALSE(scene().passes[0].units[2].enabled);
    EXPECT_FALSE(session->look.notice.text.empty());
}

TEST_F(UnitBar, SaysWhatAChangeReachesAndGivesAUnitItsOwn) {
    EXPECT_FALSE(has("shares texture")) << "unit 0 is alone";
    scene().passes[0].units[1].enabled = true;
    frames(2);
    EXPECT_EQ(sharersText(*session, 0), "unit 1");
    EXPECT_TRUE(has("shares texture"));
    click("unit:1");
    const Texture shared = texture();
    click("own texture");
    ASSERT_EQ(scene().textures.size(), 2U);
    EXPECT_EQ(scene().textures[1], shared) << "nothing changes in the picture";
    EXPECT_EQ(scene().passes[0].units[1].texture, 1);
    EXPECT_EQ(unit().texture, 0);
    EXPECT_FALSE(has("shares texture"));
    key('Z', {ctrl});
    EXPECT_EQ(scene().textures.size(), 1U);
}

TEST_F(UnitBar, SharingIsSaidOfOtherPassesToo) {
    scene().passes.push_back(scene().passes[0]);
    scene().passes[1].units[2].enabled = true;
    frames(2);
    EXPECT_EQ(sharersText(*session, 0), "unit 0 of pass 1, unit 2 of pass 1");
    EXPECT_TRUE(has("shares texture"));
    scene().textures.resize(maxTextures);
    frames(2);
    click("own texture");
    EXPECT_EQ(scene().textures.size(), maxTextures) << "there is no room for one";
}

} // namespace
} // namespace texplorer::ui::unit_bar_test

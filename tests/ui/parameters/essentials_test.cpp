#include "app/ui/model/preview.h"
#include "app/ui/model/session.h"
#include "app/ui/parameters/sections.h"
#include "app/ui/widgets/keys.h"
#include "tests/ui/workbench.h"
#include "texplorer/scene/tex_coords.h"

#include <fmt/core.h>
#include <gmock/gmock.h>

namespace texplorer::ui::essentials_test {
namespace {

using namespace test;
using testing::ElementsAre;
using testing::IsEmpty;

class Essentials : public Workbench {
protected:
    void expectWholeInSight(std::string_view name) {
        const auto item = places.items.find(name);
        ASSERT_NE(item, places.items.end()) << name;
        const WidgetPlaces::Item& room = places.items.at("parameters");
        EXPECT_TRUE(item->second.visible) << name;
        EXPECT_LE(item->second.bottom, room.bottom) << name;
        EXPECT_LE(item->second.right, static_cast<float>(layout.parameters.right())) << name;
        EXPECT_GE(item->second.left, static_cast<float>(layout.parameters.x)) << name;
    }
    void undo(int steps) {
        for (int i = 0; i < steps; ++i)
            key('Z', {ctrl});
    }
    [[nodiscard]] glm::vec4 coordinate(std::size_t vertex) {
        return effectiveTexCoord(scene().models[0], selectedMesh(*session), 0, vertex);
    }
};

// All names of a row of buttons are in sight: that one of them is no longer GL's is said by one sign.
TEST_F(Essentials, ARowOfButtonsIsResetByItsSign) {
    for (const char* path : {"textures[0].wrapS", "textures[0].wrapT", "passes[0].units[0].envMode"})
        EXPECT_FALSE(has(std::string(path) + "#reset")) << path;
    const ImVec2 before = place("textures[0].wrapS=GL_CLAMP");
    click("textures[0].wrapS=GL_CLAMP");
    click("passes[0].units[0].envMode=GL_DECAL");
    EXPECT_EQ(place("textures[0].wrapS=GL_CLAMP").x, before.x) << "it stays under the pointer";
    EXPECT_FALSE(has("textures[0].wrapT#reset"));
    const WidgetPlaces::Item& sign = places.items.at("textures[0].wrapS#reset");
    EXPECT_GE(sign.left, places.items.at("textures[0].wrapS=GL_CLAMP").right);
    EXPECT_LE(sign.right, static_cast<float>(layout.parameters.right()));
    click("textures[0].wrapS#reset");
    EXPECT_EQ(texture().wrapS, Wrap::Repeat);
    click("passes[0].units[0].envMode#reset");
    EXPECT_EQ(unit().envMode, EnvMode::Modulate);
    EXPECT_FALSE(has("passes[0].units[0].envMode#reset"));
}

constexpr std::array needed{"search",
                            "GL names",
                            "unit:0",
                            "unit:3 on",
                            "parameters:Essentials",
                            "parameters:View",
                            "next vertex",
                            "open image",
                            "textures[0].pattern=checker",
                            "textures[0].pattern=gradient",
                            "textures[0].magFilter=GL_NEAREST",
                            "textures[0].minFilter=GL_NEAREST",
                            "textures[0].minFilter=GL_LINEAR_MIPMAP_LINEAR",
                            "textures[0].wrapS=GL_REPEAT",
                            "textures[0].wrapS=GL_CLAMP",
                            "textures[0].wrapT=GL_CLAMP_TO_BORDER",
                            "textures[0].borderColor",
                            "textures[0].maxAnisotropy=16",
                            "textures[0].maxAnisotropy",
                            "passes[0].units[0].envMode=GL_MODULATE",
                            "passes[0].units[0].envMode=GL_COMBINE",
                            "passes[0].units[0].envColor",
                            "material.color",
                            "motion:scroll",
                            "motion:spin",
                            "motion:pulse",
                            "motion:rotate-centre",
                            "add matrix step"};

TEST_F(Essentials, AreInFrontAndNothingOfThemScrolls) {
    for (const auto& [width, height, scale] : {std::tuple{1280, 800, 1.0F}, std::tuple{1920, 1080, 1.0F},
                                               std::tuple{1920, 1080, 1.5F}, std::tuple{3840, 2160, 2.0F}}) {
        start(defaultScene(), width, height, scale);
        for (const char* name : needed)
            expectWholeInSight(name);
    }
}

TEST_F(Essentials, TheVertexIsChosenAndItsCoordinatesDragged) {
    EXPECT_TRUE(has("no vertex"));
    EXPECT_FALSE(has("vertex s"));
    click("next vertex");
    EXPECT_EQ(session->look.selection.vertex, 0U);
    click("next vertex");
    EXPECT_EQ(session->look.selection.vertex, 1U);
    click("previous vertex");
    click("previous vertex");
    EXPECT_EQ(session->look.selection.vertex, selectedMesh(*session).vertices.size() - 1);
    session->look.selection.vertex = 2;
    frames(2);
    const glm::vec4 before = coordinate(2);
    drag(place("vertex s"), {40, 0}); // 0.005 a pixel
    EXPECT_NEAR(coordinate(2).x, before.x + 0.2F, 0.011F);
    EXPECT_EQ(coordinate(2).y, before.y);
    drag(place("vertex t"), {-40, 0});
    EXPECT_NEAR(coordinate(2).y, before.y - 0.2F, 0.011F);
    key('Z', {ctrl});
    EXPECT_EQ(coordinate(2).y, before.y) << "a drag is one step";
    key('Z', {ctrl});
    EXPECT_EQ(coordinate(2), before);
    EXPECT_FALSE(session->document.history.canUndo());
}

TEST_F(Essentials, AModelOfNoVerticesHasNoneToChoose) {
    scene().models.clear();
    frames(2);
    click("next vertex");
    EXPECT_EQ(session->look.selection.vertex, std::nullopt);
    EXPECT_TRUE(has("no vertex"));
}

TEST_F(Essentials, OneClickSetsAFilterAWrapModeAndAnEnvironment) {
    click("textures[0].magFilter=GL_NEAREST");
    EXPECT_EQ(texture().magFilter, MagFilter::Nearest);
    click("textures[0].minFilter=GL_LINEAR_MIPMAP_NEAREST");
    EXPECT_EQ(texture().minFilter, MinFilter::LinearMipmapNearest);
    click("textures[0].wrapT=GL_MIRRORED_REPEAT");
    EXPECT_EQ(texture().wrapT, Wrap::MirroredRepeat);
    EXPECT_EQ(texture().wrapS, Wrap::Repeat);
    click("passes[0].units[0].envMode=GL_DECAL");
    EXPECT_EQ(unit().envMode, EnvMode::Decal);
    EXPECT_EQ(session->document.lastChanged, "passes[0].units[0].envMode");
    undo(4);
    EXPECT_EQ(scene(), session->document.saved);
}

TEST_F(Essentials, AnisotropyIsSetByAButtonOrByANumber) {
    click("textures[0].maxAnisotropy=8");
    EXPECT_EQ(texture().maxAnisotropy, 8);
    click("textures[0].maxAnisotropy=16");
    EXPECT_EQ(texture().maxAnisotropy, 16);
    drag(place("textures[0].maxAnisotropy"), {-2000, 0});
    EXPECT_EQ(texture().maxAnisotropy, 1);
    undo(2);
    EXPECT_EQ(texture().maxAnisotropy, 8);
}

TEST_F(Essentials, TheSliderOfAnisotropyDoublesInEqualSteps) {
    const ImVec2 middle = place("textures[0].maxAnisotropy");
    clickAt(middle);
    EXPECT_NEAR(texture().maxAnisotropy, 4, 0.3F) << "half of the way from 1 to 16";
    EXPECT_TRUE(has("textures[0].maxAnisotropy=16"));
    drag(middle, {2000, 0});
    EXPECT_EQ(texture().maxAnisotropy, 16);
    key('Z', {ctrl});
    EXPECT_NEAR(texture().maxAnisotropy, 4, 0.3F) << "the way is one step of undo";
    // Its buttons are in a small window, too.
    start(defaultScene(), 1024, 700);
    click("textures[0].maxAnisotropy=2");
    EXPECT_EQ(texture().maxAnisotropy, 2);
}

TEST(Anisotropy, EndsWhereTheDriversDoes) {
    const ParamRow& row = *findParam(textureTable(), "maxAnisotropy");
    EXPECT_EQ(maxAnisotropyOf(8, row), 8);
    EXPECT_EQ(maxAnisotropyOf(64, row), 16) << "scenes go as far as this";
    EXPECT_EQ(maxAnisotropyOf(1, row), 16) << "the driver has none, but the reference renderer has";
}

TEST_F(Essentials, AButtonSaysItsLabelItsGlNameAndItsHelp) {
    start(defaultScene(), 2560, 1440); // the status bar has room for a line
    moveTo(place("textures[0].wrapS=GL_MIRRORED_REPEAT"));
    frames();
    const EnumRow& mirror = rowOf(Wrap::MirroredRepeat);
    EXPECT_TRUE(has(fmt::format("hint:{}  ·  GL_MIRRORED_REPEAT  ·  {}", mirror.label, mirror.help)));
}

TEST_F(Essentials, APatternIsChosenByItsPicture) {
    texture().source = SourceKind::LightDepth;
    frames(2);
    click("textures[0].pattern=brick");
    EXPECT_EQ(texture().pattern, Pattern::Brick);
    EXPECT_EQ(texture().source, SourceKind::Pattern) << "both in one step";
    key('Z', {ctrl});
    EXPECT_EQ(texture().pattern, Pattern::Checker);
    click("open image");
    EXPECT_EQ(session->asking.dialog, Dialog::OpenImage);
}

TEST_F(Essentials, TheMatrixIsSetInMotionAndItsStepsAreAClickAway) {
    click("motion:scroll");
    ASSERT_EQ(unit().matrix.size(), 1U);
    EXPECT_EQ(unit().matrix[0].op, MatrixOp::Translate);
    EXPECT_NE(unit().matrix[0].rate.x, 0);
    click("motion:rotate-centre");
    ASSERT_EQ(unit().matrix.size(), 1U);
    EXPECT_EQ(unit().matrix[0].pivot, glm::vec3(0.5F, 0.5F, 0));
    click("add matrix step");
    click("add:scale");
    ASSERT_EQ(unit().matrix.size(), 2U);
    EXPECT_EQ(unit().matrix[1].amount, glm::vec3(1));
    undo(3);
    EXPECT_THAT(unit().matrix, IsEmpty());
    EXPECT_FALSE(session->document.history.canUndo());
    click("motion:spin");
    click("edit matrix");
    EXPECT_EQ(states.parameters.tab, ParameterTab::Coordinates);
    EXPECT_TRUE(has("passes[0].units[0].matrix[0].angleRate"));
}

TEST_F(Essentials, AHoveredChoiceIsPreviewedInAListToo) {
    const Scene before = scene();
    moveTo(place("textures[0].wrapS=GL_CLAMP"));
    ASSERT_TRUE(session->look.preview);
    EXPECT_EQ(shownScene(*session).textures[0].wrapS, Wrap::Clamp);
    EXPECT_TRUE(has("preview")) << "the view says so";
    EXPECT_EQ(scene(), before);
    EXPECT_THAT(requests.title, testing::Not(testing::HasSubstr("•")));
    moveTo(place("textures[0].wrapS=GL_CLAMP_TO_BORDER"));
    EXPECT_EQ(shownScene(*session).textures[0].wrapS, Wrap::ClampToBorder);
    moveTo(place("textures[0].wrapS=GL_REPEAT"));
    EXPECT_FALSE(session->look.preview) << "it is so already";
    moveTo(place("passes[0].units[0].envMode=GL_DECAL"));
    EXPECT_EQ(shownScene(*session).passes[0].units[0].envMode, EnvMode::Decal);
    moveTo(place("textures[0].pattern=tree"));
    EXPECT_EQ(shownScene(*session).textures[0].pattern, Pattern::Tree);
    moveTo(place("textures[0].maxAnisotropy=16"));
    EXPECT_EQ(shownScene(*session).textures[0].maxAnisotropy, 16);
    moveTo(place("motion:scroll"));
    EXPECT_EQ(shownScene(*session).passes[0].units[0].matrix.size(), 1U);
    moveTo(place("view"));
    EXPECT_FALSE(session->look.preview);
    EXPECT_FALSE(has("preview"));
    EXPECT_EQ(scene(), before);
    EXPECT_FALSE(session->document.history.canUndo());
    session->settings.glNames = true;
    frames(2);
    scrollTo("textures[0].minFilter");
    click("textures[0].minFilter");
    moveTo(place("textures[0].minFilter=GL_NEAREST"));
    EXPECT_EQ(shownScene(*session).textures[0].minFilter, MinFilter::Nearest);
    key(key::escape);
    moveTo(place("view"));
    EXPECT_FALSE(session->look.preview);
    EXPECT_EQ(texture().minFilter, MinFilter::LinearMipmapLinear);
}

TEST_F(Essentials, ARowIsPinnedAndTakenOutAgain) {
    const auto pick = [this](const std::string& item) {
        click("textures[0].lodBias#label", ImGuiMouseButton_Right);
        click("textures[0].lodBias#menu:" + item);
    };
    scrollTo("textures[0].lodBias#label");
    pick("pin");
    EXPECT_THAT(session->settings.pinned, ElementsAre("textures[].lodBias"));
    states.parameters.tab = ParameterTab::Essentials;
    frames(2);
    drag(place("textures[0].lodBias"), {50, 0}); // 0.02 a pixel
    EXPECT_NEAR(texture().lodBias, 1, 0.05F);
    pick("reset");
    EXPECT_EQ(texture().lodBias, 0);
    pick("pin");
    EXPECT_THAT(session->settings.pinned, IsEmpty());
    EXPECT_FALSE(has("textures[0].lodBias"));
}

TEST_F(Essentials, WhatEssentialsHasOrNothingHasIsNotPinned) {
    click("textures[0].magFilter#label", ImGuiMouseButton_Right);
    click("textures[0].magFilter#menu:pin");
    EXPECT_THAT(session->settings.pinned, IsEmpty());
    key(key::escape);
    session->settings.pinned = {"textures[].nothing", "", "models[].material.ambient"};
    frames(2);
    expectSoundFrame();
    EXPECT_FALSE(has("models[0].material.ambient")) << "the model has no material of its own";
}

TEST_F(Essentials, NamesAreThoseOfOpenGlWhereOneWantsThem) {
    EXPECT_FALSE(has("textures[0].minFilter#label") && session->settings.glNames);
    click("GL names");
    EXPECT_TRUE(session->settings.glNames);
    EXPECT_TRUE(has("textures[0].magFilter=GL_NEAREST") || has("textures[0].magFilter"));
    choose("textures[0].wrapS", "GL_CLAMP_TO_EDGE");
    EXPECT_EQ(texture().wrapS, Wrap::ClampToEdge);
    click("GL names");
    EXPECT_FALSE(session->settings.glNames);
}

TEST_F(Essentials, WithoutATextureTheySayWhatToDo) {
    scene().textures.clear();
    unit().enabled = false;
    frames(2);
    EXPECT_FALSE(has("open image"));
    click("unit:0 on");
    EXPECT_EQ(scene().textures.size(), 1U);
    EXPECT_TRUE(unit().enabled);
    EXPECT_TRUE(has("open image"));
}

} // namespace
} // namespace texplorer::ui::essentials_test

// A frame of a host without OpenGL.

#include "app/ui/model/kept.h"
#include "app/ui/widgets/palette.h"
#include "tests/stage/numbers_for_pictures.h"

#include <gmock/gmock.h>

#include <algorithm>

namespace texplorer::stage::stage_test {
namespace {

using testing::Contains;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

class StageTest : public testing::Test {
protected:
    ui::Requests frame(float scale = 1) {
        return stage.draw(session, {{1280, 800}, {1280, 800}, scale}, 1.0F / 60);
    }
    NumbersForPictures graphics;
    Stage stage{graphics, 1};
    ui::ServicesAtOnce services;
    ui::Session session{services.lend()};
};

TEST_F(StageTest, AFrameIsDrawnByWhatTheHostLends) {
    const ui::Requests requests = frame();
    EXPECT_THAT(requests.title, HasSubstr("Untitled"));
    EXPECT_THAT(graphics.drawn, ElementsAre(RendererKind::Fixed));
    EXPECT_EQ(graphics.pixels, (view::Size{1280, 800}));
    EXPECT_EQ(ImGui::ColorConvertFloat4ToU32(graphics.cleared), ui::palette().panel)
        << "panels draw no ground";
    EXPECT_EQ(graphics.frames, 1);
    frame();
    EXPECT_THAT(graphics.pictures, Contains(1000U)) << "the view";
    EXPECT_THAT(graphics.pictures, Contains(2000U)) << "the texture space";
    graphics.reads = 0;
    frame();
    EXPECT_EQ(graphics.reads, 0) << "the history has its picture, and nothing else needs pixels";
    EXPECT_THAT(stage.problems(), IsEmpty());
}

TEST_F(StageTest, TheReferenceNeedsNoRenderer) {
    showOne(session.view, RendererKind::Reference);
    frame();
    EXPECT_THAT(graphics.drawn, IsEmpty());
    const auto isView = [](const auto& shown) { // the panels' small pictures are scaled
        return shown.second == Graphics::Use::Enlarged && shown.first->width > 100;
    };
    EXPECT_EQ(std::ranges::count_if(graphics.shown, isView), 1);
    EXPECT_THAT(stage.problems(), IsEmpty());
}

TEST_F(StageTest, OnlyWhatTheHostHasIsAskedFor) {
    session.window.wantedTab = ui::Tab::Glsl;
    frame();
    showOne(session.view, RendererKind::Shader);
    for (int i = 0; i < 3; ++i)
        frame();
    EXPECT_TRUE(isShown(session.settings.workspace, ui::Tab::Glsl));
    EXPECT_EQ(session.view.renderer, RendererKind::Fixed);
    EXPECT_THAT(graphics.drawn, Each(RendererKind::Fixed));
    EXPECT_THAT(stage.problems(), IsEmpty());
    EXPECT_EQ(session.look.notice.text, "") << "it was requested only after that frame";
}

TEST_F(StageTest, WhatWasChosenAndIsNotThereGivesWayAndIsSaid) {
    graphics.offered.withhold(RendererKind::Fixed, "the driver has a core profile");
    frame();
    EXPECT_EQ(session.view.renderer, RendererKind::Reference);
    EXPECT_THAT(session.look.notice.text, HasSubstr("the driver has a core profile"));
    EXPECT_THAT(graphics.drawn, IsEmpty());
    EXPECT_THAT(stage.problems(), IsEmpty());
}

TEST_F(StageTest, AHostMayLoseWhatItHadAndHaveItAgain) {
    graphics.offered = {};
    showComparison(session.view, {RendererKind::Fixed, RendererKind::Shader});
    frame();
    EXPECT_THAT(graphics.drawn, ElementsAre(RendererKind::Fixed, RendererKind::Shader));
    graphics.drawn.clear();
    graphics.offered.withhold(RendererKind::Shader, "its context is lost");
    frame();
    EXPECT_THAT(graphics.drawn, ElementsAre(RendererKind::Fixed));
    EXPECT_THAT(session.view.compared, ElementsAre(RendererKind::Fixed, RendererKind::Reference));
    EXPECT_TRUE(isComparing(session.view));
    graphics.offered.withhold(RendererKind::Fixed, "its context is lost");
    frame();
    EXPECT_FALSE(isComparing(session.view)) << "one picture is no comparison";
    EXPECT_EQ(session.view.renderer, RendererKind::Reference);
    graphics.offered = {};
    frame();
    showOne(session.view, RendererKind::Shader);
    EXPECT_EQ(session.view.renderer, RendererKind::Shader);
}

TEST_F(StageTest, PixelsAreReadOnceForEachPicture) {
    showComparison(session.view, {RendererKind::Fixed, RendererKind::Reference});
    for (int i = 0; i < 3; ++i)
        frame();
    EXPECT_EQ(graphics.reads, 1) << "its revision stays";
}

TEST_F(StageTest, WhatWasKeptIsDrawnBesideWhatIsNow) {
    frame();
    keepAsA(session);
    session.document.scene.passes[0].blend = true;
    graphics.drawnScenes.clear();
    frame();
    EXPECT_FALSE(graphics.drawnScenes.contains(view::Side::Kept)) << "it is not shown";
    splitKept(session);
    session.document.scene.view.azimuth += 10;
    frame();
    ASSERT_TRUE(graphics.drawnScenes.contains(view::Side::Kept));
    EXPECT_FALSE(graphics.drawnScenes[view::Side::Kept].passes[0].blend);
    EXPECT_TRUE(graphics.drawnScenes[view::Side::Now].passes[0].blend);
    EXPECT_EQ(graphics.drawnScenes[view::Side::Kept].view, session.document.scene.view) << "one camera";
    forgetKept(session);
    graphics.drawnScenes.clear();
    frame();
    EXPECT_FALSE(graphics.drawnScenes.contains(view::Side::Kept));
}

TEST_F(StageTest, AStepOfTheHistoryGetsItsPictureOnce) {
    frame();
    frame();
    const auto picture = session.document.history.pictureOf(0);
    ASSERT_TRUE(picture);
    EXPECT_LE(picture->width, 96);
    EXPECT_LE(picture->height, 60);
    frame();
    EXPECT_EQ(session.document.history.pictureOf(0), picture);
}

TEST_F(StageTest, AnUploadAsksForAnotherFrame) {
    frame();
    EXPECT_FALSE(frame().unfinished);
    graphics.uploading = true;
    EXPECT_TRUE(frame().unfinished);
}

TEST_F(StageTest, AnotherScaleMakesTheFontsAgain) {
    frame();
    EXPECT_EQ(graphics.fonts, 0);
    frame(2);
    EXPECT_EQ(graphics.fonts, 1);
    frame(2);
    EXPECT_EQ(graphics.fonts, 1);
}

TEST(StagesEndTest, ThePanelsEndWithTheStage) {
    NumbersForPictures graphics;
    {
        const Stage stage(graphics, 1);
        EXPECT_TRUE(graphics.started);
    }
    EXPECT_FALSE(graphics.started);
}

} // namespace
} // namespace texplorer::stage::stage_test

#include "app/ui/editor/editor.h"
#include "app/ui/model/playback.h"
#include "app/ui/model/preview.h"
#include "app/ui/model/session.h"
#include "app/ui/model/shown_passes.h"

#include <gtest/gtest.h>

namespace texplorer::ui::preview_test {
namespace {

class PreviewTest : public testing::Test {
protected:
    void hover() {
        hover("wrap", "Wrap s: Clamp", [this](Scene& scene) {
            ++edits;
            scene.textures[0].wrapS = Wrap::Clamp;
        });
    }
    void hover(const char* choice, const char* text, const std::function<void(Scene&)>& edit) {
        preview(session, choice, text, edit);
        takeRequests(session);
    }

    ServicesAtOnce services;
    Session session{services.lend(), Document{defaultScene(), ImageSource{}}};
    int edits = 0;
};

TEST_F(PreviewTest, IsShownUntilAFrameInWhichNobodyAsks) {
    EXPECT_EQ(&shownScene(session), &session.document.scene);
    hover();
    endPreview(session);
    EXPECT_EQ(shownScene(session).textures[0].wrapS, Wrap::Clamp);
    EXPECT_EQ(session.document.scene, session.document.saved) << "the document knows nothing of it";
    EXPECT_FALSE(session.document.history.canUndo());
    EXPECT_FALSE(isDirty(session.document));
    hover();
    endPreview(session);
    EXPECT_EQ(edits, 1) << "the same one is made once";
    endPreview(session);
    EXPECT_EQ(&shownScene(session), &session.document.scene);
}

TEST_F(PreviewTest, RestsAfterUndoUntilThePointerLeavesTheChoice) {
    restPreview(session);
    endPreview(session);
    for (int frame = 0; frame < 3; ++frame) {
        hover();
        EXPECT_EQ(shownPreview(session), nullptr);
        endPreview(session);
    }
    EXPECT_EQ(edits, 0);
    endPreview(session);
    hover();
    EXPECT_EQ(shownScene(session).textures[0].wrapS, Wrap::Clamp);
}

TEST_F(PreviewTest, ShowsAnotherChoiceThanTheOneThatRests) {
    restPreview(session);
    hover();
    hover("filter", "Nearest", [](Scene& scene) { scene.textures[0].magFilter = MagFilter::Nearest; });
    EXPECT_EQ(shownScene(session).textures[0].magFilter, MagFilter::Nearest);
}

TEST_F(PreviewTest, FollowsTheDocument) {
    hover();
    session.document.scene.textures[0].wrapT = Wrap::Clamp;
    hover();
    EXPECT_EQ(edits, 2);
    EXPECT_EQ(shownScene(session).textures[0].wrapT, Wrap::Clamp);
}

TEST_F(PreviewTest, TheNextChoiceTakesItsPlace) {
    hover();
    hover("filter", "Nearest", [](Scene& scene) { scene.textures[0].magFilter = MagFilter::Nearest; });
    EXPECT_EQ(shownScene(session).textures[0].magFilter, MagFilter::Nearest);
    EXPECT_EQ(shownScene(session).textures[0].wrapS, Wrap::Repeat);
}

TEST_F(PreviewTest, NoFileIsReadForIt) {
    hover("file", "Image file", [](Scene& scene) {
        scene.textures[0].source = SourceKind::File;
        scene.textures[0].file = "nowhere.png";
    });
    EXPECT_EQ(&shownScene(session), &session.document.scene);
    EXPECT_TRUE(session.document.loads.empty());
}

TEST_F(PreviewTest, PlaysWhereItMoves) {
    EXPECT_FALSE(isMoving(session));
    hover("scroll", "Scroll", [](Scene& scene) {
        scene.passes[0].units[0].matrix = {{.op = MatrixOp::Translate, .rate = {1, 0, 0}}};
    });
    EXPECT_TRUE(isMoving(session));
    endPreview(session);
    endPreview(session);
    EXPECT_FALSE(isMoving(session));
}

TEST_F(PreviewTest, ShowsItsOwnPasses) {
    hover("pass", "Another pass", [](Scene& scene) { scene.passes.push_back(scene.passes[0]); });
    EXPECT_EQ(shownPasses(session), 2U);
    session.view.stepsThroughPasses = true;
    Scene stepped;
    EXPECT_EQ(shownScene(session, stepped).passes.size(), 1U);
}

} // namespace
} // namespace texplorer::ui::preview_test

// A fitted camera follows the shape of its view until the user moves it.

#include "app/ui/state/camera.h"
#include "tests/ui/edits.h"
#include "tests/ui/workbench.h"

namespace texplorer::ui::framing_test {
namespace {

using namespace test;

class Framing : public Workbench {
protected:
    /// The distance at which the scene would fill the current view.
    [[nodiscard]] float filling() const {
        Scene copy = session->document.scene;
        fitDistance(copy, session->look.playback.time, aspectOf(layout));
        return copy.view.distance;
    }
    void narrowTheView() {
        drag(place("left seam"), {120, 0});
        frames(3);
    }
};

TEST_F(Framing, FollowsTheSeamsAndIsNoEdit) {
    const float before = scene().view.distance;
    EXPECT_FLOAT_EQ(before, filling());
    narrowTheView();
    EXPECT_NE(scene().view.distance, before);
    EXPECT_FLOAT_EQ(scene().view.distance, filling());
    EXPECT_FALSE(session->document.history.canUndo());
    EXPECT_EQ(session->document.saved, scene());
}

TEST_F(Framing, LeavesACameraThatSomebodyMoved) {
    wheel(place("view"), 3);
    const View moved = scene().view;
    narrowTheView();
    EXPECT_EQ(scene().view, moved);
}

TEST_F(Framing, FollowsAgainAfterTheModelsWereFramed) {
    wheel(place("view"), 3);
    click("frame");
    narrowTheView();
    EXPECT_FLOAT_EQ(scene().view.distance, filling());
}

TEST_F(Framing, UndoGoesBackToACameraOfTheShapeThatTheViewHasNow) {
    scene().textures[0].wrapS = Wrap::Clamp;
    recordEdit(*session, "Wrap s", "textures[0].wrapS");
    narrowTheView();
    take(*session, Undo{});
    frames();
    EXPECT_EQ(scene().textures[0].wrapS, Wrap::Repeat);
    EXPECT_FLOAT_EQ(scene().view.distance, filling());
    EXPECT_FALSE(session->document.history.canUndo());
}

} // namespace
} // namespace texplorer::ui::framing_test

#include "app/ui/model/playback.h"
#include "app/ui/widgets/keys.h"
#include "tests/ui/workbench.h"

namespace texplorer::ui::playback_controls_test {
namespace {

using namespace test;

class PlaybackControls : public Workbench {
protected:
    void animate() {
        scene().models[0].spin = {0, 30, 0};
        frames(2);
    }
};

TEST_F(PlaybackControls, TimeGoesOnOnlyWhereSomethingMoves) {
    advance(*session, 1);
    EXPECT_EQ(session->look.playback.time, 0);
    EXPECT_FALSE(isMoving(*session));
    animate();
    EXPECT_TRUE(isMoving(*session));
    advance(*session, 0.5);
    EXPECT_DOUBLE_EQ(session->look.playback.time, 0.5);
}

TEST_F(PlaybackControls, SpaceAndTheButtonPauseAndPlay) {
    animate();
    key(key::space);
    EXPECT_FALSE(session->look.playback.playing);
    advance(*session, 1);
    EXPECT_EQ(session->look.playback.time, 0);
    click("play");
    EXPECT_TRUE(session->look.playback.playing);
}

TEST_F(PlaybackControls, StepsScrubsAndRewinds) {
    animate();
    click("step");
    EXPECT_FALSE(session->look.playback.playing);
    EXPECT_NEAR(session->look.playback.time, 0.1, 1e-6);
    const WidgetPlaces::Item slider = places.items.at("time");
    clickAt({(slider.left + slider.right) / 2, (slider.top + slider.bottom) / 2});
    EXPECT_NEAR(session->look.playback.time, 5, 0.1); // the middle of 0 to 10 s
    click("rewind");
    EXPECT_EQ(session->look.playback.time, 0);
}

TEST_F(PlaybackControls, SpeedScalesTheClock) {
    animate();
    click("speed");
    click("speed:2×");
    advance(*session, 0.25);
    EXPECT_DOUBLE_EQ(session->look.playback.time, 0.5);
}

TEST_F(PlaybackControls, ThePictureFollowsTheTime) {
    animate();
    const Image before = picture();
    session->look.playback.time = 1;
    frames(1);
    EXPECT_NE(picture(), before);
}

} // namespace
} // namespace texplorer::ui::playback_controls_test

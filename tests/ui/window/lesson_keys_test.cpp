// The keys of NeHe's lesson 22, pressed while the lesson is open.

#include "app/ui/files/lessons.h"
#include "app/ui/files/replaced_document.h"
#include "app/ui/model/lesson_run.h"
#include "app/ui/model/playback.h"
#include "app/ui/widgets/keys.h"
#include "app/ui/window/shortcuts.h"
#include "tests/ui/workbench.h"

#include <gmock/gmock.h>
#include <imgui_internal.h> // windows, and how far they are scrolled

#include <algorithm>
#include <string_view>

namespace texplorer::ui::lesson_keys_test {
namespace {

using namespace test;
using testing::ElementsAre;

class LessonKeys : public Workbench {
protected:
    LessonKeys() { open(0); }
    void open(std::size_t step) {
        ASSERT_TRUE(openLessonNamed(*session, "bumps", step));
        frames(4);
    }
    [[nodiscard]] std::vector<bool> passes() {
        std::vector<bool> enabled;
        for (const Pass& pass : scene().passes)
            enabled.push_back(pass.enabled);
        return enabled;
    }
    void hold(int code, int count) {
        setHeld(code, true);
        frames(count);
        setHeld(code, false);
        frames(2);
    }
    void undoOnce() { key('Z', {ctrl}); }
};

// Two units: sum, base; one: bump, inverse, base; none: base alone. The plates come last.
TEST_F(LessonKeys, AreThoseOfTheProgram) {
    EXPECT_THAT(passes(), ElementsAre(true, false, false, true, false, true, true));
    key('M');
    EXPECT_THAT(passes(), ElementsAre(false, true, true, true, false, true, false));
    key('E');
    EXPECT_THAT(passes(), ElementsAre(false, true, true, false, false, true, false));
    key('B');
    EXPECT_THAT(passes(), ElementsAre(false, false, false, false, true, true, false));
    key('M');
    EXPECT_THAT(passes(), ElementsAre(false, false, false, false, true, true, true));
    key('B');
    EXPECT_THAT(passes(), ElementsAre(true, false, false, false, false, true, true));
    key('E');
    EXPECT_EQ(scene(), session->lesson->start.scene);
}

TEST_F(LessonKeys, AChoiceThatAnotherOverridesIsKept) {
    key('B');
    const Scene without = scene();
    key('E');
    EXPECT_EQ(scene(), without);
    key('B');
    EXPECT_THAT(passes(), ElementsAre(true, false, false, false, false, true, true));
}

TEST_F(LessonKeys, TwoArrowsAreAdded) {
    const glm::vec3 before = scene().models[0].spin;
    setHeld(key::right, true);
    hold(key::up, 3);
    setHeld(key::right, false);
    EXPECT_NE(scene().models[0].spin.x, before.x);
    EXPECT_NE(scene().models[0].spin.y, before.y);
}

TEST_F(LessonKeys, FTakesTheNextFilterInTheCameraAsItIs) {
    scene().view.azimuth = 33;
    EXPECT_EQ(texture().minFilter, MinFilter::Linear);
    key('F');
    EXPECT_EQ(texture().minFilter, MinFilter::LinearMipmapNearest);
    EXPECT_EQ(texture().mipmaps, MipPolicy::Glu);
    EXPECT_EQ(scene().textures[2].minFilter, MinFilter::LinearMipmapNearest);
    key('F');
    EXPECT_EQ(texture().magFilter, MagFilter::Nearest);
    key('F');
    EXPECT_EQ(texture().minFilter, MinFilter::Linear);
    EXPECT_EQ(scene().view.azimuth, 33) << "F alone frames all models";
}

[[nodiscard]] float scrollOfText() {
    float scroll = 0;
    for (const ImGuiWindow* each : ImGui::GetCurrentContext()->Windows) {
        if (each->Active && std::string_view(each->Name).find("/step_") != std::string_view::npos)
            scroll += each->Scroll.y;
    }
    return scroll;
}

TEST_F(LessonKeys, DoNothingElse) {
    clickAt(place("lesson title"));
    const float distance = scene().view.distance;
    key(key::pageDown);
    EXPECT_NE(scene().view.distance, distance);
    EXPECT_EQ(scrollOfText(), 0);
    session->lesson->usable.assign(session->lesson->usable.size(), false);
    key(key::pageDown);
    EXPECT_GT(scrollOfText(), 0) << "a key that the step hasn't turns the page";
}

TEST_F(LessonKeys, AreNoLongerOfferedForWhatTheyDidBefore) {
    const auto offered = [this](std::string_view words) {
        return std::ranges::any_of(places.items, [words](const auto& item) {
            return item.first.starts_with("view hints:") && item.first.find(words) != std::string::npos;
        });
    };
    EXPECT_FALSE(offered("Hold E"));
    EXPECT_FALSE(offered("M: magnifier"));
    EXPECT_TRUE(offered("Drag: orbit"));
    EXPECT_EQ(keysOf(*session, "frame"), "");
    EXPECT_EQ(keysOf(*session, "search"), "Ctrl+F");
    EXPECT_EQ(keysOf(*session, "note"), "N");
    closeLesson(*session);
    frames(4);
    EXPECT_TRUE(offered("Hold E"));
    EXPECT_TRUE(offered("M: magnifier"));
    EXPECT_EQ(keysOf(*session, "frame"), "F");
}

TEST_F(LessonKeys, EachPressIsAStepOfUndo) {
    key('M');
    key('B');
    undoOnce();
    EXPECT_THAT(passes(), ElementsAre(false, true, true, true, false, true, false));
    EXPECT_TRUE(has("lesson key:B=on"));
    EXPECT_TRUE(has("lesson key:M=one unit"));
    undoOnce();
    EXPECT_TRUE(has("lesson key:M=two units"));
    EXPECT_EQ(scene(), session->lesson->start.scene);
}

TEST_F(LessonKeys, ArrowsGoOnWhileTheyAreHeld) {
    const glm::vec3 spin = scene().models[0].spin;
    key(key::up);
    EXPECT_NEAR(scene().models[0].spin.x, spin.x - 0.6F, 1e-4F) << "0.01 degrees a frame";
    key(key::right);
    EXPECT_NEAR(scene().models[0].spin.y, spin.y + 0.6F, 1e-4F);
    hold(key::down, 30);
    const float held = scene().models[0].spin.x;
    EXPECT_GT(held, spin.x + 0.6F);
    undoOnce();
    EXPECT_NEAR(scene().models[0].spin.x, spin.x - 0.6F, 1e-4F) << "one step, however long";
    const float distance = scene().view.distance;
    key(key::pageUp);
    EXPECT_NEAR(scene().view.distance, distance + 0.02F, 1e-5F);
    key(key::pageDown);
    EXPECT_NEAR(scene().view.distance, distance, 1e-5F);
}

TEST_F(LessonKeys, TheWindowGoesOnWhileOneIsHeld) {
    session->look.playback.playing = false;
    EXPECT_FALSE(isMoving(*session));
    setHeld(key::up, true);
    frames(2);
    EXPECT_TRUE(isMoving(*session));
    const double time = session->look.playback.time;
    advance(*session, 1);
    EXPECT_EQ(session->look.playback.time, time) << "the clock is stopped";
    setHeld(key::up, false);
    frames(2);
    EXPECT_FALSE(isMoving(*session));
}

TEST_F(LessonKeys, GoBeforeTheWindowsOwn) {
    session->look.explaining.pixel = {100, 100};
    moveTo(ImVec2(static_cast<float>(layout.view.x + layout.view.width / 2),
                  static_cast<float>(layout.view.y + layout.view.height / 2)));
    const auto before = session->look.explaining.pixel;
    key('E'); // held over the view it explains the pixel there
    key(key::left);
    EXPECT_EQ(session->look.explaining.pixel, before);
    key('F', {ctrl}); // with Control it is the window's
    EXPECT_EQ(texture().minFilter, MinFilter::Linear);
}

TEST_F(LessonKeys, AreLettersWhereOneTypes) {
    session->out.wantsSearch = true;
    frames(4);
    ASSERT_TRUE(ImGui::GetIO().WantTextInput);
    key('M');
    EXPECT_EQ(scene(), session->lesson->start.scene);
}

TEST_F(LessonKeys, AreClickedAsWell) {
    click("lesson key:M");
    EXPECT_TRUE(has("lesson key:M=one unit"));
    click("lesson key:Up");
    EXPECT_NEAR(scene().models[0].spin.x, session->lesson->start.scene.models[0].spin.x - 0.6F, 1e-4F);
}

TEST_F(LessonKeys, DoNothingWhereTheSceneHasNotWhatTheyChange) {
    open(1); // a relief without the lit bricks
    EXPECT_TRUE(has("lesson key:M"));
    EXPECT_FALSE(has("lesson key:M=two units"));
    const Scene before = scene();
    key('M');
    EXPECT_EQ(scene(), before);
    key(key::pageUp);
    EXPECT_NE(scene(), before);
}

TEST_F(LessonKeys, AreListedAmongAllKeysWhileTheLessonIsOpen) {
    key(key::f1);
    frames(3);
    EXPECT_TRUE(has("help:Multitexture"));
    click("help:close");
    closeLesson(*session);
    frames(2);
    key(key::f1);
    frames(3);
    EXPECT_FALSE(has("help:Multitexture"));
}

TEST_F(LessonKeys, EndWithTheLesson) {
    closeLesson(*session);
    frames(3);
    const Scene before = scene();
    key('B');
    key(key::pageUp);
    EXPECT_EQ(scene(), before);
}

} // namespace
} // namespace texplorer::ui::lesson_keys_test

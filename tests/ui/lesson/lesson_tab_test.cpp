// Lessons by mouse: from the menu through their steps.

#include "app/ui/files/lessons.h"
#include "app/ui/model/lesson_run.h"
#include "tests/ui/edits.h"
#include "tests/ui/workbench.h"

namespace texplorer::ui::lesson_tab_test {
namespace {

using namespace test;
using testing::Not;

class LessonTab : public Workbench {
protected:
    void openWrap() {
        click("menu:Lessons");
        click("menu:lesson:wrap");
        ASSERT_TRUE(session->lesson);
        ASSERT_EQ(session->lesson->folder.name(), "wrap");
    }
    void next(int times = 1) {
        for (int i = 0; i < times; ++i)
            click("lesson:Next");
    }
    [[nodiscard]] LessonRun& run() { return *session->lesson; }
    [[nodiscard]] StepRecord record(std::size_t step) { return session->settings.lessons["wrap"].at(step); }
    /// Turns the wheel over the step, above its buttons, until an item is visible.
    void wheelTo(std::string_view name) {
        const ImVec2 buttons = place("lesson:Next");
        for (int turn = 0; turn < 50; ++turn) {
            const auto found = places.items.find(name);
            const auto top = static_cast<float>(layout.rightDock.y) + 40; // below the tabs
            if (found != places.items.end() && found->second.visible && found->second.top > top &&
                found->second.bottom < buttons.y - 12)
                return;
            wheel({buttons.x, buttons.y - 40}, turn == 0 ? 100.0F : -1.0F);
        }
    }
};

// Without room for their own menu they are in the menu that opens all others.
TEST_F(LessonTab, AreHighUpInTheFileMenuWhereTextIsLarge) {
    session->settings.textPercent = 200;
    frames(4);
    ASSERT_FALSE(has("menu:Lessons"));
    click("menu:File");
    EXPECT_LT(place("menu:Lessons").y, place("menu:Open scene…").y);
}

TEST_F(LessonTab, MenuListsThemInTheirOrder) {
    click("menu:Lessons");
    float above = 0;
    for (const std::string& name : lesson::builtInLessons()) {
        ASSERT_TRUE(has("menu:lesson:" + name)) << name;
        EXPECT_GT(place("menu:lesson:" + name).y, above);
        above = place("menu:lesson:" + name).y;
    }
}

TEST_F(LessonTab, IsSteppedThrough) {
    openWrap();
    EXPECT_EQ(run().step, 0U);
    EXPECT_EQ(scene(), run().start.scene);
    next();
    EXPECT_EQ(run().step, 1U);
    EXPECT_EQ(scene(), run().start.scene);
    click("lesson:Previous");
    EXPECT_EQ(run().step, 0U);
    click("lesson:Previous"); // does nothing
    EXPECT_EQ(run().step, 0U);
    texture().wrapS = Wrap::Clamp;
    frames(2);
    click("lesson:Restart step");
    EXPECT_EQ(scene(), run().start.scene);
    click("lesson step:4");
    EXPECT_EQ(run().step, 3U);
}

TEST_F(LessonTab, EndsWithTheListOfAll) {
    openWrap();
    next(static_cast<int>(run().lesson.steps.size()));
    EXPECT_FALSE(session->lesson);
    ASSERT_TRUE(has("lesson:first-texture"));
    click("lesson:first-texture");
    ASSERT_TRUE(session->lesson);
    EXPECT_EQ(run().folder.name(), "first-texture");
}

TEST_F(LessonTab, IsLeftByTheMenu) {
    openWrap();
    const Scene mine = scene();
    click("menu:Lessons");
    click("menu:Leave the lesson");
    EXPECT_FALSE(session->lesson);
    EXPECT_FALSE(has("lesson:Next"));
    EXPECT_EQ(scene(), mine) << "one goes on with what there is";
}

TEST_F(LessonTab, TakesAnswersUntilTheRightOne) {
    openWrap();
    next();
    wheelTo("answer:3");
    click("answer:3");
    EXPECT_EQ(record(1), (StepRecord{false, 1, 2}));
    EXPECT_FALSE(has("reason"));
    wheelTo("answer:1");
    click("answer:1");
    EXPECT_EQ(record(1), (StepRecord{true, 2, 0}));
    frames(2);
    EXPECT_TRUE(has("reason"));
    EXPECT_THAT(run().reason(), testing::HasSubstr("integer part is 1"));
    EXPECT_THAT(run().reason(), Not(testing::HasSubstr("{")));
    EXPECT_EQ(texture().wrapT, Wrap::MirroredRepeat);
}

TEST_F(LessonTab, ScrollsToTheVerdictAndStartsTheNextStepAtItsTop) {
    start(defaultScene(), 1024, 640);
    openWrap();
    next();
    for (const int answer : {3, 1}) { // a wrong one, and the right one
        wheelTo("answer:" + std::to_string(answer));
        click("answer:" + std::to_string(answer));
        frames(3);
        const std::string verdict = answer == 1 ? "reason" : "not this one";
        ASSERT_TRUE(has(verdict));
        EXPECT_TRUE(places.items[verdict].visible) << verdict;
        EXPECT_LE(places.items[verdict].bottom, places.items["lesson:Next"].top) << verdict;
    }
    EXPECT_FALSE(places.items["lesson title"].visible) << "the step is higher than the tab";
    next();
    frames(2);
    EXPECT_TRUE(places.items["lesson title"].visible);
    wheel(place("lesson title"), -100);
    EXPECT_FALSE(places.items["lesson title"].visible);
    click("lesson:Restart step");
    frames(2);
    EXPECT_TRUE(places.items["lesson title"].visible);
}

TEST_F(LessonTab, HintsAtWhatIsMissingAndSaysWhenItIsReached) {
    openWrap();
    next(2);
    ASSERT_EQ(run().step, 2U);
    wheelTo("match:hint");
    EXPECT_FALSE(has("reached"));
    click("match:hint");
    EXPECT_TRUE(run().wantsHint);
    frames(2);
    const std::string first = session->look.shownParam;
    EXPECT_THAT(first, testing::AnyOf("textures[0].wrapS", "textures[0].wrapT"));
    texture().wrapS = Wrap::ClampToEdge;
    frames(3);
    EXPECT_EQ(session->look.shownParam, "textures[0].wrapT") << "what is missing now";
    EXPECT_FALSE(record(2).done);
    texture().wrapT = Wrap::ClampToBorder;
    frames(3);
    EXPECT_TRUE(has("reached"));
    EXPECT_FALSE(has("match:hint"));
    EXPECT_TRUE(record(2).done);
}

TEST_F(LessonTab, ScrollsToWhatStillDiffersAfterAnEdit) {
    start(defaultScene(), 1024, 640);
    openWrap();
    next(2);
    frames(3);
    ASSERT_TRUE(run().grade && !run().grade->passed);
    EXPECT_TRUE(places.items["lesson title"].visible) << "not before anything was tried";
    const auto isInSight = [this] {
        const WidgetPlaces::Item& item = places.items["not reached"];
        return item.visible && item.bottom <= places.items["lesson:Next"].top;
    };
    ASSERT_FALSE(isInSight()) << "the step is higher than the tab";
    texture().wrapS = Wrap::ClampToEdge;
    recordEdit(*session, "Wrap s");
    frames(4);
    ASSERT_FALSE(run().grade->passed);
    EXPECT_TRUE(isInSight());
    wheel(place("match:hint"), 100);
    frames(3);
    EXPECT_FALSE(isInSight()) << "once, not with every frame";
}

TEST_F(LessonTab, AsksAboutUnsavedChangesFirst) {
    scene().material.shininess = 77;
    recordEdit(*session, "Shininess");
    frames(1);
    const Scene mine = scene();
    click("menu:Lessons");
    click("menu:lesson:wrap");
    EXPECT_EQ(session->asking.dialog, Dialog::Discard);
    EXPECT_EQ(scene(), mine);
    EXPECT_FALSE(session->lesson);
    click("discard:cancel");
    EXPECT_FALSE(session->lesson);
    click("menu:Lessons");
    click("menu:lesson:wrap");
    click("discard:drop");
    ASSERT_TRUE(session->lesson);
    texture().wrapS = Wrap::Clamp; // edits of a lesson are not saved
    recordEdit(*session, "Wrap s");
    frames(1);
    click("menu:Lessons");
    click("menu:lesson:alpha");
    EXPECT_EQ(session->asking.dialog, Dialog::None);
    EXPECT_EQ(run().folder.name(), "alpha");
}

TEST_F(LessonTab, IsInTheWindowsLanguage) {
    openWrap();
    EXPECT_EQ(run().text("Repeated"), "Repeated");
    for (const Language language : {Language::Russian, Language::Chinese}) {
        speak(language);
        frames(3);
        EXPECT_EQ(run().language, language);
        EXPECT_EQ(run().text("Repeated"), language == Language::Russian ? "Повторение" : "重复");
        EXPECT_EQ(run().text("No text of the lesson"), "No text of the lesson");
        click("menu:Lessons");
        EXPECT_TRUE(has("menu:lesson:wrap"));
        click("menu:lesson:wrap");
    }
}

/// Every step of every lesson in the language whose words are the longest.
TEST_F(LessonTab, IsDrawnWhateverItSays) {
    speak(Language::Russian);
    for (const std::string& name : lesson::builtInLessons()) {
        SCOPED_TRACE(name);
        ASSERT_TRUE(openLessonNamed(*session, name, 0));
        for (std::size_t i = 0; i < run().lesson.steps.size(); ++i) {
            goToLessonStep(*session, i);
            frames(1);
            expectSoundFrame();
            ASSERT_TRUE(has("lesson:Next"));
            ASSERT_EQ(session->look.notice.text, "");
        }
    }
}

TEST_F(LessonTab, ShowsThePicturesOfItsAnswers) {
    openWrap();
    static_cast<void>(picture()); // expects no message from a renderer
    next();
    const Image before = picture();
    run().pictures = nullptr;
    EXPECT_NE(picture().pixels, before.pixels);
    expectSoundFrame();
}

} // namespace
} // namespace texplorer::ui::lesson_tab_test

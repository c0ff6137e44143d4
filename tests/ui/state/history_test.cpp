#include "app/ui/state/history.h"

#include <gtest/gtest.h>

namespace texplorer::ui::history_test {
namespace {

/// Scenes that differ in one number.
Scene numbered(float azimuth) {
    Scene scene;
    scene.view.azimuth = azimuth;
    return scene;
}

float number(const Scene& scene) {
    return scene.view.azimuth;
}

// The number of the scene afterwards.
float undo(History& history) {
    Selection selection;
    history.undo(selection);
    return number(history.current());
}

float redo(History& history) {
    Selection selection;
    history.redo(selection);
    return number(history.current());
}

float takeBack(History& history) {
    Selection selection;
    history.takeBack(selection);
    return number(history.current());
}

float goTo(History& history, std::size_t step) {
    Selection selection;
    history.goTo(step, selection);
    return number(history.current());
}

TEST(History, BeginsWithNothingToUndo) {
    History history(numbered(1));
    EXPECT_EQ(number(history.current()), 1);
    EXPECT_FALSE(history.canUndo());
    EXPECT_FALSE(history.canRedo());
    EXPECT_EQ(history.undoName(), "");
    EXPECT_EQ(history.redoName(), "");
    EXPECT_EQ(undo(history), 1);
    EXPECT_EQ(redo(history), 1);
}

TEST(History, UndoesAndRedoesByName) {
    History history(numbered(1));
    history.record(numbered(2), "Wrap s");
    history.record(numbered(3), "Filter");
    EXPECT_EQ(history.undoName(), "Filter");
    EXPECT_EQ(undo(history), 2);
    EXPECT_EQ(history.undoName(), "Wrap s");
    EXPECT_EQ(history.redoName(), "Filter");
    EXPECT_EQ(undo(history), 1);
    EXPECT_FALSE(history.canUndo());
    EXPECT_EQ(redo(history), 2);
    EXPECT_EQ(redo(history), 3);
    EXPECT_FALSE(history.canRedo());
}

TEST(History, ADragIsOneStep) {
    History history(numbered(1));
    for (int i = 2; i < 100; ++i)
        history.record(numbered(static_cast<float>(i)), "Azimuth");
    EXPECT_EQ(number(history.current()), 99);
    EXPECT_EQ(undo(history), 1);
    EXPECT_EQ(redo(history), 99);
}

TEST(History, ASealSeparatesTwoDragsOfTheSameThing) {
    History history(numbered(1));
    history.record(numbered(2), "Azimuth");
    history.seal();
    history.record(numbered(3), "Azimuth");
    EXPECT_EQ(undo(history), 2);
    EXPECT_EQ(undo(history), 1);
}

TEST(History, EditsWithoutANameStayApart) {
    History history(numbered(1));
    history.record(numbered(2), "");
    history.record(numbered(3), "");
    EXPECT_EQ(undo(history), 2);
}

TEST(History, RecordingTheSameSceneIsNoStep) {
    History history(numbered(1));
    history.record(numbered(1), "Azimuth");
    EXPECT_FALSE(history.canUndo());
    history.record(numbered(2), "Azimuth");
    undo(history);
    history.record(numbered(1), "Azimuth");
    EXPECT_TRUE(history.canRedo()) << "nothing changed, so nothing is given up";
}

TEST(History, AnEditAfterUndoGivesUpTheRedo) {
    History history(numbered(1));
    history.record(numbered(2), "a");
    history.record(numbered(3), "b");
    undo(history);
    history.record(numbered(4), "a"); // the same name as the current step, but after an undo
    EXPECT_FALSE(history.canRedo());
    EXPECT_EQ(undo(history), 2);
    EXPECT_EQ(undo(history), 1);
}

TEST(History, KeepsAtMostItsLimit) {
    History history(numbered(0), 3);
    for (int i = 1; i <= 10; ++i)
        history.record(numbered(static_cast<float>(i)), std::to_string(i));
    EXPECT_EQ(undo(history), 9);
    EXPECT_EQ(undo(history), 8);
    EXPECT_EQ(undo(history), 7);
    EXPECT_FALSE(history.canUndo());
}

TEST(History, ACameraIsReplacedInEveryStepThatHasIt) {
    Scene other = numbered(2);
    other.passes.resize(2);
    Scene moved = numbered(3);
    History history(numbered(2));
    history.record(other, "Add pass");
    history.record(moved, "Orbit");
    history.change([](Scene& scene) {
        if (scene.view == numbered(2).view)
            scene.view = numbered(7).view;
    });
    EXPECT_EQ(number(history.current()), 3);
    EXPECT_EQ(undo(history), 7);
    EXPECT_EQ(history.current().passes.size(), 2U);
    EXPECT_EQ(undo(history), 7);
    EXPECT_EQ(history.undoName(), "");
}

TEST(History, ALimitOfZeroKeepsTheCurrentSceneAlone) {
    History history(numbered(1), 0);
    history.record(numbered(2), "a");
    EXPECT_EQ(number(history.current()), 2);
    EXPECT_FALSE(history.canUndo());
}

TEST(History, IsAListOfStepsToWhichOneGoes) {
    History history(numbered(1));
    history.record(numbered(2), "a");
    history.record(numbered(3), "b");
    ASSERT_EQ(history.size(), 3U);
    EXPECT_EQ(history.position(), 2U);
    EXPECT_EQ(history.nameOf(0), "");
    EXPECT_EQ(history.nameOf(2), "b");
    EXPECT_EQ(goTo(history, 0), 1);
    EXPECT_EQ(history.redoName(), "a");
    EXPECT_EQ(goTo(history, 2), 3);
    EXPECT_EQ(goTo(history, 99), 3) << "the last one";
    history.record(numbered(4), "b");
    EXPECT_EQ(history.size(), 4U) << "going somewhere ends a step";
}

TEST(History, AnEditThatIsTakenBackLeavesNothing) {
    History history(numbered(1));
    history.record(numbered(2), "a");
    history.record(numbered(3), "b");
    undo(history);
    history.record(numbered(4), "drag");
    history.record(numbered(5), "drag");
    EXPECT_FALSE(history.canRedo());
    EXPECT_EQ(takeBack(history), 2);
    EXPECT_EQ(history.redoName(), "b") << "what could be redone before";
    EXPECT_EQ(history.size(), 3U);
    EXPECT_EQ(takeBack(history), 2) << "nothing is in progress";
    EXPECT_EQ(redo(history), 3);
    history.record(numbered(6), "c");
    history.seal();
    EXPECT_EQ(takeBack(history), 6) << "a step that has ended stays";
}

TEST(History, ACameraIsReplacedInWhatComesBackWithATakenBackEdit) {
    History history(numbered(1));
    history.record(numbered(2), "a");
    undo(history);
    history.record(numbered(3), "drag");
    history.change([](Scene& scene) {
        if (scene.view == numbered(2).view)
            scene.view = numbered(7).view;
    });
    EXPECT_EQ(takeBack(history), 1);
    EXPECT_EQ(redo(history), 7);
}

TEST(History, AStepsPictureIsGivenUpWhenItGoesOn) {
    History history(numbered(1), 2);
    const auto picture = std::make_shared<const Image>();
    EXPECT_EQ(history.pictureOf(0), nullptr);
    history.setPicture(picture);
    EXPECT_EQ(history.pictureOf(0), picture);
    history.record(numbered(2), "Azimuth");
    EXPECT_EQ(history.pictureOf(0), picture);
    history.setPicture(picture);
    history.record(numbered(3), "Azimuth");
    EXPECT_EQ(history.pictureOf(1), nullptr);
    history.record(numbered(4), "b");
    history.record(numbered(5), "c");
    EXPECT_EQ(history.size(), 3U);
    EXPECT_EQ(picture.use_count(), 1) << "what is forgotten takes its picture along";
}

// 1000 vertices take 12 kB: 10 of 20 such steps fit into 500 kB, because each has some overhead.
TEST(History, RemembersFewerStepsOfLargeScenes) {
    History history(numbered(0), 200, 500'000);
    for (int i = 1; i <= 20; ++i) {
        Scene scene = numbered(static_cast<float>(i));
        scene.models.resize(1);
        scene.models[0].mesh.positions.resize(1000);
        history.record(scene, "");
    }
    EXPECT_EQ(number(history.current()), 20);
    EXPECT_GE(history.size(), 5U);
    EXPECT_LE(history.size(), 15U);
    EXPECT_EQ(history.position(), history.size() - 1);
    EXPECT_EQ(undo(history), 19);
    Scene huge = numbered(21);
    huge.models.resize(1);
    huge.models[0].mesh.positions.resize(100'000);
    history.record(huge, "");
    EXPECT_EQ(history.size(), 2U) << "the last edit can be undone in any case";
    EXPECT_EQ(undo(history), 19);
}

TEST(History, RestoresTheSelectionOfItsSteps) {
    const auto reselection = [](int before, int after) {
        return Reselection{.before = {.pass = before}, .after = {.pass = after}};
    };
    History history(numbered(0));
    history.record(numbered(1), "a", reselection(0, 1));
    history.record(numbered(2), "b");
    history.record(numbered(3), "drag", reselection(4, 5));
    history.record(numbered(4), "drag", reselection(5, 6));
    Selection selection{.pass = 9};
    history.undo(selection);
    EXPECT_EQ(selection.pass, 4) << "before the whole drag";
    selection.pass = 9;
    history.undo(selection);
    EXPECT_EQ(selection.pass, 9) << "b selects nothing";
    history.undo(selection);
    EXPECT_EQ(selection.pass, 0);
    history.undo(selection);
    EXPECT_EQ(selection.pass, 0);
    history.goTo(3, selection);
    EXPECT_EQ(selection.pass, 6);
    history.goTo(0, selection);
    EXPECT_EQ(selection.pass, 0);
    history.record(numbered(5), "c", reselection(7, 8));
    history.takeBack(selection);
    EXPECT_EQ(selection.pass, 7);
}

} // namespace
} // namespace texplorer::ui::history_test

// Submitted steps, without panels and without Dear ImGui.

#include "app/ui/editor/editor.h"
#include "app/ui/files/replaced_document.h"
#include "app/ui/model/session.h"
#include "app/ui/services/services.h"
#include "tests/ui/edits.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <random>
#include <type_traits>

namespace texplorer::ui::editor_test {
namespace {

class Editor : public testing::Test {
protected:
    void make(Step step) {
        submit(session, std::move(step));
        takeRequests(session);
    }
    [[nodiscard]] Scene& scene() { return session.document.scene; }
    [[nodiscard]] const History& history() const { return session.document.history; }

    ServicesAtOnce services;
    Session session{services.lend()};
};

Step set(const std::string& path, const std::string& value, bool continues = false) {
    return {.name = path, .edits = {edit::Set{path, value}}, .path = path, .continues = continues};
}

TEST_F(Editor, MakesStepsInTheirOrderAsStepsOfUndo) {
    const std::size_t steps = history().size();
    submit(session, set("view.azimuth", "10"));
    submit(session, set("view.azimuth", "20"));
    EXPECT_NE(scene().view.azimuth, 10) << "not before the end of the frame";
    takeRequests(session);
    EXPECT_EQ(scene().view.azimuth, 20);
    EXPECT_EQ(history().size(), steps + 2);
    EXPECT_EQ(session.document.lastChanged, "view.azimuth");
    take(session, Undo{});
    EXPECT_EQ(scene().view.azimuth, 10);
}

TEST_F(Editor, JoinsTheStepsOfADragUntilItEnds) {
    const std::size_t steps = history().size();
    make(set("view.azimuth", "10", true));
    make(set("view.azimuth", "20", true));
    EXPECT_EQ(history().size(), steps + 1);
    submit(session, set("view.azimuth", "30", true));
    sealEdit(session);
    submit(session, set("view.azimuth", "40", true));
    takeRequests(session);
    EXPECT_EQ(history().size(), steps + 2);
    take(session, Undo{});
    EXPECT_EQ(scene().view.azimuth, 30);
}

TEST_F(Editor, RefusesAStepThatIsNotPossibleAndSaysWhy) {
    const Scene before = scene();
    const std::size_t steps = history().size();
    make({.name = "Impossible", .edits = {edit::Set{"view.azimuth", "10"}, edit::Remove{"models", 99}}});
    EXPECT_EQ(scene(), before);
    EXPECT_EQ(history().size(), steps);
    EXPECT_THAT(session.look.notice.text, testing::HasSubstr("found 99"));
}

TEST_F(Editor, SaysThatAKeyFrameIsMissing) {
    scene().timeline.keys.assign(maxKeyFrames, {0, "view.azimuth", "0"});
    for (std::size_t i = 0; i < maxKeyFrames; ++i)
        scene().timeline.keys[i].time = static_cast<float>(i) / 100;
    session.look.playback = {.playing = false, .time = 100};
    const Scene before = scene();
    make(set("view.azimuth", "7"));
    EXPECT_EQ(scene(), before);
    EXPECT_THAT(session.look.notice.text, testing::HasSubstr("a key frame can't be added: expected at most"));
}

TEST_F(Editor, SelectsWhatTheStepSaysAsFarAsItExists) {
    make({.name = "Select",
          .edits = {edit::Set{"view.azimuth", "10"}},
          .select = Selection{.model = 99, .unit = 2}});
    EXPECT_EQ(session.look.selection.model, 0) << "the first that is visible";
    EXPECT_EQ(session.look.selection.unit, 2);
}

TEST_F(Editor, ForgetsTheStepsOfAnotherDocument) {
    submit(session, set("view.azimuth", "10"));
    replaceDocument(session, Document(defaultScene(), ImageSource{}));
    takeRequests(session);
    EXPECT_NE(scene().view.azimuth, 10);
}

TEST_F(Editor, DoesWhatAnActionRequestsInTheSameFrame) {
    submit(session, set("view.azimuth", "10"));
    act(session, [](Session& acting) {
        EXPECT_EQ(acting.document.scene.view.azimuth, 10) << "after the earlier step";
        submit(acting, set("view.azimuth", "20"));
    });
    act(session, [](Session& changed) { changed.view.magnifies = true; });
    EXPECT_FALSE(session.view.magnifies) << "not before the end of the frame";
    takeRequests(session);
    EXPECT_EQ(scene().view.azimuth, 20);
    EXPECT_TRUE(session.view.magnifies);
    EXPECT_TRUE(session.out.requests.empty());
}

TEST_F(Editor, MakesNoStepInADocumentThatAnActionHasOpened) {
    act(session, [](Session& acting) { replaceDocument(acting, Document(defaultScene(), ImageSource{})); });
    submit(session, set("view.azimuth", "10"));
    act(session, [](Session& changed) { changed.view.magnifies = true; });
    takeRequests(session);
    EXPECT_NE(scene().view.azimuth, 10);
    EXPECT_TRUE(session.view.magnifies) << "the window stays";
}

/// What panels get: they can request, and write nothing else.
static_assert(!std::is_assignable_v<decltype((std::declval<const Session&>().document.scene)), Scene>);
static_assert(!std::is_assignable_v<decltype((std::declval<const Session&>().asking.dialog)), Dialog>);

/// Whether a const session gives only const workers.
template<auto... services>
constexpr bool areConst =
    (std::is_const_v<
         std::remove_pointer_t<decltype((std::declval<const Session&>().services.*services).operator->())>> &&
     ...) &&
    sizeof(Services) == sizeof...(services) * sizeof(void*);
static_assert(
    areConst<&Services::files, &Services::levels, &Services::reference, &Services::kept, &Services::probe,
             &Services::levelMap, &Services::patterns, &Services::levelPictures, &Services::lessons,
             &Services::environments, &Services::plainProbe, &Services::sheet, &Services::programs,
             &Services::writing, &Services::unsaved, &Services::settings, &Services::captures>);
static_assert(!std::is_convertible_v<const ServiceRef<LevelsWorker>&, LevelsWorker&>);

TEST_F(Editor, SelectsTheSamePassAfterUndoAndRedo) {
    make({.name = "Add pass", .edits = {edit::Insert{"passes", 1}}});
    make({.name = "Move pass", .edits = {edit::Move{"passes", 1, 0}}});
    EXPECT_EQ(session.look.selection.pass, 0);
    take(session, Undo{});
    EXPECT_EQ(session.look.selection.pass, 1);
    take(session, GoToStep{});
    EXPECT_EQ(session.look.selection.pass, 0);
    take(session, GoToStep{1});
    EXPECT_EQ(session.look.selection.pass, 1);
    take(session, Redo{});
    EXPECT_EQ(session.look.selection.pass, 0);
}

TEST_F(Editor, RemovesTheMessageOfAnUndoneStep) {
    make({.name = "Blue", .edits = {edit::Set{"view.azimuth", "10"}}, .says = "Blue: less red"});
    EXPECT_EQ(session.look.notice.text, "Blue: less red");
    take(session, Undo{});
    EXPECT_EQ(session.look.notice.text, "");
}

using Selected = std::array<int, 3>;

/// Any steps, undone and redone, lead to the same scenes and selections.
TEST_F(Editor, LeadsToTheSameSceneAfterUndoAndRedo) {
    std::mt19937 random(3);
    const auto selected = [this] {
        const Selection& selection = session.look.selection;
        return Selected{selection.model, selection.pass, selection.unit};
    };
    std::vector<Scene> scenes{scene()};
    std::vector<Selected> before; // of each step
    std::vector<Selected> after;
    const auto number = [&random](std::size_t below) { return random() % below; };
    while (scenes.size() < 120) {
        constexpr std::array lists{"models", "textures", "passes", "passes[0].units[0].matrix",
                                   "textures[0].levels"};
        const std::string list = lists[number(lists.size())];
        const std::array<Edit, 5> edits{edit::Insert{list, number(4)}, edit::Remove{list, number(4)},
                                        edit::Move{list, number(4), number(4)},
                                        edit::Set{"textures[0].wrapS", number(2) ? "GL_CLAMP" : "GL_REPEAT"},
                                        edit::Set{"material.shininess", std::to_string(number(128))}};
        const Selected present = selected();
        make({.name = "Step", .edits = {edits[number(edits.size())]}});
        if (scene() != scenes.back()) {
            scenes.push_back(scene());
            before.push_back(present);
            after.push_back(selected());
        }
        if (number(4) == 0 && scenes.size() > 2) {
            take(session, Undo{});
            EXPECT_EQ(scene(), scenes[scenes.size() - 2]);
            EXPECT_EQ(selected(), before.back());
            take(session, Redo{});
            EXPECT_EQ(scene(), scenes.back());
            EXPECT_EQ(selected(), after.back());
        }
    }
    for (std::size_t i = scenes.size() - 1; i-- > 0;) {
        take(session, Undo{});
        ASSERT_EQ(scene(), scenes[i]) << i;
        ASSERT_EQ(selected(), before[i]) << i;
    }
    for (std::size_t i = 1; i < scenes.size(); ++i) {
        take(session, Redo{});
        ASSERT_EQ(scene(), scenes[i]) << i;
        ASSERT_EQ(selected(), after[i - 1]) << i;
    }
}

} // namespace
} // namespace texplorer::ui::editor_test

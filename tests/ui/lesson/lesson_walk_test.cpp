// Every lesson from its first step to its last, in each language: its words fit, every question and every
// task is done as a student would, and the marks show it.

#include "app/ui/files/lessons.h"
#include "app/ui/model/lesson_run.h"
#include "app/ui/state/lesson_records.h"
#include "app/ui/widgets/keys.h"
#include "tests/ui/edits.h"
#include "tests/ui/workbench.h"

#include <fmt/core.h>
#include <imgui_internal.h>

#include <algorithm>
#include <string>

namespace texplorer::ui::lesson_walk_test {
namespace {

using namespace test;
using testing::StartsWith;

/// A window as Dear ImGui's internal API has it, the child of another one.
const ImGuiWindow* childNamed(std::string_view part) {
    for (const ImGuiWindow* each : ImGui::GetCurrentContext()->Windows) {
        if (each->WasActive && std::string_view(each->Name).find(part) != std::string_view::npos)
            return each;
    }
    return nullptr;
}

class LessonWalk : public Workbench, public testing::WithParamInterface<Language> {
protected:
    LessonWalk() {
        speak(GetParam());
        start(defaultScene(), 1600, 1200);
    }

    [[nodiscard]] LessonRun& run() { return *session->lesson; }
    [[nodiscard]] bool isDone() { return isStepDone(session->settings, run().key, run().step); }

    /// No item extends beyond the right edge or is wider than its parent.
    void expectUncut() {
        const ImGuiWindow* step = childNamed("/step_");
        ASSERT_TRUE(step);
        EXPECT_LE(step->ScrollMax.x, 1) << "a pixel may be rounded";
        EXPECT_LE(step->ContentSize.x, step->InnerRect.GetWidth() + 1);
        for (const auto& [name, item] : places.items) {
            if (name.starts_with("answer:") || name.starts_with("lesson:") || name == "match:hint") {
                EXPECT_LE(item.right, step->OuterRectClipped.Max.x + 1) << name;
            }
        }
    }

    /// Turns the wheel over the step until an item is completely visible.
    void wheelTo(std::string_view name) {
        const ImVec2 buttons = place("lesson:Next");
        for (int turn = 0; turn < 60; ++turn) {
            const auto found = places.items.find(name);
            if (found != places.items.end() && found->second.visible && found->second.bottom < buttons.y - 12)
                return;
            wheel({buttons.x, buttons.y - 60}, turn == 0 ? 100.0F : -1.0F);
        }
        FAIL() << name << " is nowhere";
    }

    /// The item with the keyboard focus.
    [[nodiscard]] static std::optional<ImRect> focused() {
        const ImGuiContext& context = *ImGui::GetCurrentContext();
        if (!context.NavWindow || context.NavId == 0 || !context.NavIdIsAlive)
            return std::nullopt;
        return ImGui::WindowRectRelToAbs(context.NavWindow, context.NavWindow->NavRectRel[context.NavLayer]);
    }
    /// Goes to the panel by F6, then to the item by pages and arrows; fails the test if it is not reached.
    void walkTo(std::string_view name) {
        const auto isInPanel = [&] {
            const ImGuiWindow* now = ImGui::GetCurrentContext()->NavWindow;
            return now && states.keyboard.walks && now->RootWindow->Rect().Contains(place("lesson:Next"));
        };
        for (int i = 0; i < 12 && !isInPanel(); ++i)
            key(ui::key::f6);
        ASSERT_TRUE(isInPanel());
        for (int i = 0; i < 60; ++i) {
            const auto found = places.items.find(name);
            ASSERT_NE(found, places.items.end()) << name;
            const WidgetPlaces::Item& item = found->second;
            const ImVec2 middle((item.left + item.right) / 2, (item.top + item.bottom) / 2);
            const std::optional<ImRect> here = focused();
            if (here && here->Contains(middle))
                return;
            if (!item.visible)
                key(middle.y < childNamed("/step_")->InnerRect.Min.y ? ui::key::pageUp : ui::key::pageDown);
            else if (here && middle.y < here->Min.y)
                key(ui::key::up);
            else if (!here || middle.y > here->Max.y)
                key(ui::key::down);
            else
                key(middle.x < here->Min.x ? ui::key::left : ui::key::right);
        }
        FAIL() << "no arrows lead to " << name;
    }
    void press(const std::string& name) {
        SCOPED_TRACE(name);
        if (byKeyboard) {
            walkTo(name);
            key(ui::key::space);
        } else {
            if (!name.starts_with("lesson:"))
                wheelTo(name);
            click(name);
        }
    }

    void doTask(const std::monostate& /*task*/) {}
    void doTask(const lesson::Try& /*task*/) {}
    void doTask(const lesson::Predict& predict) {
        EXPECT_FALSE(isDone());
        const std::size_t wrong = predict.right == 0 ? 1 : 0;
        press(fmt::format("answer:{}", wrong + 1));
        EXPECT_EQ(run().answer, wrong);
        EXPECT_FALSE(isDone());
        press(fmt::format("answer:{}", predict.right + 1));
        frames(2);
        EXPECT_TRUE(has("reason"));
        EXPECT_NE(run().reason(), "");
    }
    void doTask(const lesson::Match& /*match*/) {
        EXPECT_FALSE(isDone());
        press("match:hint");
        frames(2);
        ASSERT_TRUE(run().hint && run().hint->hint);
        EXPECT_EQ(session->look.shownParam, run().hint->hint->path);
        expectUncut();
        scene() = run().target.value();
        recordEdit(*session, "All at once");
        sealEdit(*session);
        frames(3);
        EXPECT_TRUE(has("reached"));
    }

    void walk(const std::string& name) {
        SCOPED_TRACE(name);
        ASSERT_TRUE(openLessonNamed(*session, name, 0));
        frames(3);
        const std::size_t steps = run().lesson.steps.size();
        for (std::size_t i = 0; i < steps; ++i) {
            SCOPED_TRACE(fmt::format("step {}", i + 1));
            ASSERT_EQ(run().step, i);
            expectUncut();
            // A copy: the list of steps is the lesson's, and tasks change the session.
            const auto task = run().lesson.steps[i].task;
            std::visit([this](const auto& each) { doTask(each); }, task);
            EXPECT_TRUE(isDone());
            expectUncut();
            press("lesson:Next");
            frames(2);
            if (testing::Test::HasFatalFailure())
                return;
        }
        EXPECT_FALSE(session->lesson) << "the list of all lessons";
        EXPECT_EQ(progressOf(session->settings, name, steps).done, steps);
    }

    /// The first lesson and a third of the others, different in each language: all of them together.
    void walkThird(std::size_t shift) {
        const std::vector<std::string> names = lesson::builtInLessons();
        for (std::size_t i = 0; i < names.size() && !HasFatalFailure(); ++i) {
            if (i == 0 || i % 3 == (static_cast<std::size_t>(GetParam()) + shift) % 3)
                walk(names[i]);
        }
    }

    bool byKeyboard = false;
};

TEST_P(LessonWalk, LeadsThroughEveryStepByMouse) {
    walkThird(0);
}

TEST_P(LessonWalk, LeadsThroughEveryStepByKeyboard) {
    byKeyboard = true;
    walkThird(1);
}

/// Every step of every lesson in a narrow panel, without doing its tasks.
TEST_P(LessonWalk, CutsNoWordsInASmallWindow) {
    start(defaultScene(), 1024, 700);
    ServicesAtOnce atOnce;
    LessonWork beside(When::WhenReady); // pictures aren't waited for
    const Services all = atOnce.lend();
    lend({all.files, all.levels, all.reference, all.kept, all.probe, all.levelMap, all.patterns,
          all.levelPictures, beside, all.environments, all.plainProbe, all.sheet, all.programs, all.writing});
    speak(GetParam());
    for (const std::string& name : lesson::builtInLessons()) {
        SCOPED_TRACE(name);
        ASSERT_TRUE(openLessonNamed(*session, name, 0));
        for (std::size_t i = 0; i < run().lesson.steps.size(); ++i) {
            SCOPED_TRACE(fmt::format("step {}", i + 1));
            goToLessonStep(*session, i);
            frames(4); // until there is a bar to scroll with, and its words are wrapped next to it
            expectUncut();
        }
    }
}

INSTANTIATE_TEST_SUITE_P(All, LessonWalk,
                         testing::Values(Language::English, Language::Chinese, Language::Russian),
                         [](const auto& each) { return std::string(rowOf(each.param).name); });

} // namespace
} // namespace texplorer::ui::lesson_walk_test

#include "app/stage/input_queue.h"
#include "app/ui/widgets/keys.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <algorithm>
#include <cfloat>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace texplorer::stage::input_queue_test {
namespace {

namespace key = ui::key;
using Kind = KeyChanged::Kind;

constexpr int shift = 340;
constexpr int control = 341;
constexpr Modifiers none{};
constexpr Modifiers withControl{.control = true};
constexpr Modifiers withShift{.shift = true};

KeyChanged down(int code, Modifiers modifiers = none) {
    return {Kind::Press, code, modifiers};
}
KeyChanged up(int code, Modifiers modifiers = none) {
    return {Kind::Release, code, modifiers};
}
KeyChanged again(int code) {
    return {Kind::Repeat, code};
}
TextEntered letter(char32_t code) {
    return {code};
}
ButtonChanged press(Modifiers modifiers = none, int button = 0) {
    return {button, true, modifiers};
}
ButtonChanged release(Modifiers modifiers = none, int button = 0) {
    return {button, false, modifiers};
}
PointerMoved to(float x, float y) {
    return {x, y};
}
constexpr WheelTurned wheel{0, 1};
constexpr FocusChanged unfocused{false};
constexpr PointerMoved before{10, 10}; // where the pointer was in the frame before

struct Case {
    const char* name;
    std::deque<Input> waiting;
    std::size_t taken;
    bool typing = false;

    friend std::ostream& operator<<(std::ostream& out, const Case& c) { return out << c.name; }
};

class InputQueueRows : public testing::TestWithParam<Case> {};

TEST_P(InputQueueRows, AFrameTakesWhatItCanTellApart) {
    EXPECT_EQ(inputsForOneFrame(GetParam().waiting, {before, none, GetParam().typing}), GetParam().taken);
}

INSTANTIATE_TEST_SUITE_P(
    Keys, InputQueueRows,
    testing::Values(
        Case{"Nothing", {}, 0}, Case{"OneKey", {down('A')}, 1},
        Case{"ATapTakesTwoFrames", {down('A'), up('A')}, 1},
        Case{"AShortcut",
             {down(control, withControl), down('S', withControl), up('S', withControl), up(control)},
             2},
        Case{"ItsEnd", {up('S', withControl), up(control)}, 1},
        Case{
            "AModifierThatWasHeldBeforeTheWindowListened", {down('S', withControl), up('S', withControl)}, 1},
        Case{"AKeyBeforeAModifierIsNoShortcut", {down('S'), down(control, withControl)}, 1},
        Case{"AModifierLetGoBetweenTwoKeys", {down('S', withControl), down('F')}, 1},
        Case{"AKeyHeldForLong", {down('E'), again('E'), again('E'), again('E'), again('E')}, 5},
        Case{"AKeyLetGoAfterLong", {again('E'), again('E'), up('E')}, 3},
        Case{"TypedText", {down('A'), letter('a'), down('B'), letter('b')}, 4},
        Case{"TheSameLetterTwice", {down('A'), letter('a'), up('A'), down('A'), letter('a')}, 2},
        Case{"TypingTheSameLetterTwice",
             {down('A'), letter('a'), up('A'), down('A'), letter('a'), up('A')},
             6,
             true},
        Case{"TypingThenEnter", {down('A'), letter('a'), up('A'), down(key::enter)}, 3, true},
        Case{"SelectAllWhileTyping",
             {down(control, withControl), down('A', withControl), up('A', withControl), up(control)},
             2,
             true},
        Case{"EnterAfterText", {down('A'), letter('a'), down(key::enter)}, 2},
        Case{"TextAfterBackspace", {down(key::backspace), down('A'), letter('a')}, 2},
        Case{"KeysAreLetGoWithTheFocus", {down('A'), unfocused}, 1},
        Case{"TheFocusAlone", {unfocused, down('A')}, 1}),
    [](const auto& test) { return test.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Mouse, InputQueueRows,
    testing::Values(
        Case{"ManyMoves", {to(1, 1), to(2, 2), to(3, 3)}, 3},
        Case{"ThePointerRestsBeforeAPress", {to(20, 20), press()}, 1},
        Case{"APressWhereThePointerIs", {to(10, 10), press()}, 2},
        Case{"AClickTakesTwoFrames", {press(), release()}, 1},
        Case{"TwoClicksTakeFour", {release(), press(), release()}, 1},
        Case{"TwoButtons", {press(none, 0), press(none, 1)}, 2},
        Case{"ADragHasArrivedBeforeItEnds", {to(20, 20), release()}, 1},
        Case{"APressDoesNotMove", {press(), to(20, 20)}, 1},
        Case{"AShiftClick", {down(shift, withShift), press(withShift), release(withShift), up(shift)}, 2},
        Case{"ShiftIsLetGoAfterThePress", {press(withShift), up(shift)}, 1},
        Case{"ShiftIsLetGoAfterTheClick", {release(withShift), up(shift)}, 1},
        Case{"TheWheelTurnsWhereThePointerIs", {to(20, 20), wheel, wheel}, 1},
        Case{"TurnsAddUp", {wheel, wheel, wheel}, 3}, Case{"AMoveAfterATurn", {wheel, to(20, 20)}, 1},
        Case{"AClickLeadsTheKeyboard", {press(), down('A'), letter('a')}, 1},
        Case{"TextWaitsForAClick", {release(), letter('a')}, 1},
        Case{"AKeyBeforeAPress", {down('A'), press()}, 1},
        Case{"AKeyBelowTheNewPlace", {to(20, 20), down('E')}, 2},
        Case{"OutOfTheWindow", {to(20, 20), PointerLeft{}}, 2}),
    [](const auto& test) { return test.param.name; });

/// However long the queue, frame after frame it becomes empty.
TEST(InputQueueRow, EveryFrameTakesSomething) {
    std::deque<Input> waiting;
    for (int i = 0; i < 100; ++i) {
        waiting.push_back(i % 3 == 0   ? Input(down(control, withControl))
                          : i % 3 == 1 ? Input(letter('x'))
                                       : Input(up(control)));
        waiting.push_back(i % 2 == 0 ? Input(down(key::enter)) : Input(press()));
        waiting.push_back(to(static_cast<float>(i), 0));
        waiting.push_back(unfocused);
    }
    while (!waiting.empty()) {
        const std::size_t taken = inputsForOneFrame(waiting, {before, none, false});
        ASSERT_GE(taken, 1U);
        waiting.erase(waiting.begin(), waiting.begin() + static_cast<std::ptrdiff_t>(taken));
    }
}

/// What Dear ImGui itself makes of it, frame after frame.
class InputQueueFrames : public testing::Test {
protected:
    InputQueueFrames() {
        ImGui::CreateContext();
        ui::prepareKeys();
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.DisplaySize = {100, 100};
        unsigned char* pixels = nullptr;
        int width = 0;
        int height = 0;
        io.Fonts->GetTexDataAsAlpha8(&pixels, &width, &height);
    }
    ~InputQueueFrames() override { ImGui::DestroyContext(); }
    InputQueueFrames(const InputQueueFrames&) = delete;
    InputQueueFrames& operator=(const InputQueueFrames&) = delete;

    /// Adds all of it, and shows frames until nothing waits, and one more.
    template<class Look>
    void happen(std::initializer_list<Input> inputs, const Look& look) {
        for (const Input& input : inputs)
            queue.add(input);
        for (bool more = true; more;) {
            more = !queue.empty();
            ImGui::GetIO().DeltaTime = 1.0F / 60;
            queue.feed();
            ImGui::NewFrame();
            look(ImGui::GetIO());
            ImGui::EndFrame();
        }
    }
    InputQueue queue;
};

TEST_F(InputQueueFrames, AShortcutIsPressedWithItsModifierAndLetGo) {
    int saves = 0;
    int others = 0;
    happen({down(control, withControl), down('S', withControl), up('S', withControl), up(control)},
           [&](const ImGuiIO& io) {
               if (ui::isKeyPressed('S', false))
                   ++(io.KeyCtrl && !io.KeyShift && !io.KeyAlt ? saves : others);
           });
    EXPECT_EQ(saves, 1);
    EXPECT_EQ(others, 0);
    EXPECT_FALSE(ImGui::GetIO().KeyCtrl);
    EXPECT_FALSE(ui::isKeyDown('S'));
}

TEST_F(InputQueueFrames, EveryClickIsAClickWhereThePointerWas) {
    std::vector<std::pair<float, bool>> clicks;
    int doubles = 0;
    happen({to(20, 5), press(), release(), press(), release(), to(80, 5), press(withShift),
            release(withShift), up(shift)},
           [&](const ImGuiIO& io) {
               if (ImGui::IsMouseClicked(0))
                   clicks.emplace_back(io.MousePos.x, io.KeyShift);
               doubles += ImGui::IsMouseDoubleClicked(0) ? 1 : 0;
           });
    EXPECT_EQ(clicks, (std::vector<std::pair<float, bool>>{{20.0F, false}, {20.0F, false}, {80.0F, true}}));
    EXPECT_EQ(doubles, 1);
    EXPECT_FALSE(ImGui::GetIO().KeyShift);
}

TEST_F(InputQueueFrames, ADragThatLeavesTheWindowGoesOn) {
    ImVec2 way{0, 0};
    const auto add = [&way](const ImGuiIO& io) {
        if (io.MouseDown[0])
            way = {way.x + io.MouseDelta.x, way.y + io.MouseDelta.y};
    };
    happen({to(90, 50), press(), to(99, 50), PointerLeft{}, to(150, 60), to(170, 70)}, add);
    EXPECT_EQ(way.x, 80);
    EXPECT_EQ(way.y, 20);
    happen({PointerLeft{}, release()}, add);
    EXPECT_EQ(ImGui::GetIO().MousePos.x, -FLT_MAX) << "after its end it is outside";
    happen({to(30, 30)}, add);
    EXPECT_EQ(ImGui::GetIO().MousePos.x, 30);
}

TEST_F(InputQueueFrames, WhatNoKeyboardAndNoMouseHasIsIgnored) {
    happen({down(-1), down(512), up(100000), ButtonChanged{5, true}, ButtonChanged{-1, true}},
           [](const ImGuiIO& io) {
               for (int code = 32; code <= ui::key::menu; ++code)
                   EXPECT_FALSE(ui::isKeyDown(code)) << code;
               EXPECT_FALSE(std::ranges::any_of(io.MouseDown, [](bool each) { return each; }));
           });
}

TEST_F(InputQueueFrames, TextArrivesInItsOrder) {
    std::u32string text;
    happen({down('H'), letter('H'), up('H'), letter(U'ä'), down(key::enter), letter('!')},
           [&](const ImGuiIO& io) {
               for (const ImWchar each : io.InputQueueCharacters)
                   text.push_back(each);
               if (ui::isKeyPressed(key::enter, false))
                   text.push_back('\n');
           });
    EXPECT_EQ(text, U"Hä\n!");
}

TEST_F(InputQueueFrames, WhatIsHeldEndsWithTheFocus) {
    happen({down(control, withControl), down('S', withControl), unfocused}, [](const ImGuiIO&) {});
    EXPECT_FALSE(ui::isKeyDown('S'));
    EXPECT_FALSE(ImGui::GetIO().KeyCtrl);
}

/// How many frames it takes until nothing waits.
int framesFor(InputQueue& queue) {
    int frames = 0;
    for (; !queue.empty(); ++frames) {
        ImGui::GetIO().DeltaTime = 1.0F / 60;
        queue.feed();
        ImGui::NewFrame();
        ImGui::EndFrame();
    }
    return frames;
}

TEST_F(InputQueueFrames, WhatArrivesFasterThanFramesIsJoined) {
    queue.add(down('A'));
    for (int i = 0; i < 10'000; ++i) {
        queue.add(to(static_cast<float>(i), 5));
        queue.add(again('A'));
    }
    EXPECT_LE(framesFor(queue), 3);
    EXPECT_EQ(ImGui::GetIO().MousePos.x, 9999);
    EXPECT_TRUE(ui::isKeyDown('A'));
    float turned = 0;
    for (int i = 0; i < 10'000; ++i)
        queue.add(wheel);
    queue.feed();
    turned += ImGui::GetIO().MouseWheel;
    EXPECT_TRUE(queue.empty());
    EXPECT_EQ(turned, 10'000);
}

// Each takes frames of its own: a window that is that far behind doesn't catch up with all.
TEST_F(InputQueueFrames, MoreKeysAndButtonsThanItCanFollowAreDroppedWithTheirEnds) {
    for (int i = 0; i < 10'000; ++i) {
        queue.add(down('A'));
        queue.add(up('A'));
        queue.add(to(static_cast<float>(i % 50), 5));
        queue.add(press());
        queue.add(release());
    }
    EXPECT_LE(framesFor(queue), static_cast<int>(4 * InputQueue::maxPresses));
    EXPECT_FALSE(ui::isKeyDown('A'));
    EXPECT_FALSE(ImGui::GetIO().MouseDown[0]);
    int clicks = 0;
    happen({press(), release()}, [&](const ImGuiIO&) { clicks += ImGui::IsMouseClicked(0) ? 1 : 0; });
    EXPECT_EQ(clicks, 1) << "what comes later counts again";
}

} // namespace
} // namespace texplorer::stage::input_queue_test

#include "app/ui/widgets/input_queue.h"
#include "app/ui/widgets/keys.h"

#include <gtest/gtest.h>

#include <ostream>

namespace texplorer::ui {
namespace {

constexpr int control = 341;

KeyEvent down(int code) {
    return {KeyEvent::Kind::Press, code};
}
KeyEvent up(int code) {
    return {KeyEvent::Kind::Release, code};
}
KeyEvent again(int code) {
    return {KeyEvent::Kind::Repeat, code};
}
KeyEvent letter(int code) {
    return {KeyEvent::Kind::Character, code};
}

struct Case {
    const char* name;
    std::deque<KeyEvent> waiting;
    std::size_t taken;
    bool typing = false;

    friend std::ostream& operator<<(std::ostream& out, const Case& c) { return out << c.name; }
};

class InputQueue : public testing::TestWithParam<Case> {};

TEST_P(InputQueue, TakesWhatOneFrameCanTellApart) {
    EXPECT_EQ(eventsForOneFrame(GetParam().waiting, GetParam().typing), GetParam().taken);
}

INSTANTIATE_TEST_SUITE_P(
    Rows, InputQueue,
    testing::Values(Case{"Nothing", {}, 0}, Case{"OneKey", {down('A')}, 1},
                    Case{"ATapTakesTwoFrames", {down('A'), up('A')}, 1},
                    Case{"AShortcut", {down(control), down('S'), up('S'), up(control)}, 2},
                    Case{"ItsEnd", {up('S'), up(control)}, 1},
                    Case{"AKeyBeforeAModifierIsNoShortcut", {down('S'), down(control)}, 1},
                    Case{"AKeyHeldForLong", {down('E'), again('E'), again('E'), again('E'), again('E')}, 5},
                    Case{"AKeyLetGoAfterLong", {again('E'), again('E'), up('E')}, 3},
                    Case{"TypedText", {down('A'), letter('a'), down('B'), letter('b')}, 4},
                    Case{"TheSameLetterTwice", {down('A'), letter('a'), up('A'), down('A'), letter('a')}, 2},
                    Case{"TypingTheSameLetterTwice",
                         {down('A'), letter('a'), up('A'), down('A'), letter('a'), up('A')},
                         6,
                         true},
                    Case{"TypingThenEnter", {down('A'), letter('a'), up('A'), down(key::enter)}, 3, true},
                    Case{"SelectAllWhileTyping", {down(control), down('A'), up('A'), up(control)}, 2, true},
                    Case{"EnterAfterText", {down('A'), letter('a'), down(key::enter)}, 2},
                    Case{"TextAfterBackspace", {down(key::backspace), down('A'), letter('a')}, 2}),
    [](const auto& test) { return test.param.name; });

/// However long the queue, frame after frame it becomes empty.
TEST(InputQueueDrained, EveryFrameTakesSomething) {
    std::deque<KeyEvent> waiting;
    for (int i = 0; i < 100; ++i) {
        waiting.push_back(i % 3 == 0 ? down(control) : i % 3 == 1 ? letter('x') : up(control));
        waiting.push_back(down(key::enter));
    }
    while (!waiting.empty()) {
        const std::size_t taken = eventsForOneFrame(waiting, false);
        ASSERT_GE(taken, 1U);
        waiting.erase(waiting.begin(), waiting.begin() + static_cast<std::ptrdiff_t>(taken));
    }
}

} // namespace
} // namespace texplorer::ui

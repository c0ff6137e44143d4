#include "tests/random/batches.h"

#include <gmock/gmock.h>

#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <unistd.h>

namespace texplorer::random::batches_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<int> numbersOf(const std::vector<Note>& notes, std::string_view kind) {
    std::vector<int> numbers;
    for (const Note& note : notes) {
        if (note.kind == kind)
            numbers.push_back(note.number);
    }
    return numbers;
}

TEST(Batches, DoEveryNumberOnce) {
    for (const unsigned jobs : {1U, 3U}) {
        const Ended ended = runBatches({.first = 7, .count = 10, .size = 4, .jobs = jobs}, [](int) -> Work {
            return
                [](int number, Journal& journal) { journal.note("square", std::to_string(number * number)); };
        });
        EXPECT_EQ(ended.done, 10);
        EXPECT_THAT(ended.deaths, IsEmpty());
        EXPECT_THAT(numbersOf(ended.notes, "square"), ElementsAre(7, 8, 9, 10, 11, 12, 13, 14, 15, 16));
        EXPECT_EQ(ended.notes[2].text, "81");
    }
}

TEST(Batches, ChargeADeathToItsNumberAndGoOn) {
    const Ended ended = runBatches({.count = 10, .size = 5, .limitSeconds = 5}, [](int) -> Work {
        return [](int number, Journal& journal) {
            journal.step("first");
            journal.step("second");
            if (number == 0)
                std::raise(SIGSEGV);
            if (number == 3)
                std::raise(SIGKILL);
            if (number == 4)
                _exit(3);
            if (number == 6)
                for (;;)
                    pause();
            if (number == 8)
                throw std::runtime_error("thrown");
            journal.note("well", "");
        };
    });
    ASSERT_EQ(ended.deaths.size(), 4U);
    const std::vector<std::pair<int, std::string>> expected{
        {0, "Segmentation fault"}, {3, "Killed"}, {4, "exit status 3"}, {6, "no end within 5 s"}};
    for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_EQ(ended.deaths[i].number, expected[i].first);
        EXPECT_EQ(ended.deaths[i].cause, expected[i].second);
        EXPECT_EQ(ended.deaths[i].step, "second");
        EXPECT_TRUE(ended.deaths[i].alone);
    }
    EXPECT_THAT(numbersOf(ended.notes, "well"), ElementsAre(1, 2, 5, 7, 9));
    EXPECT_THAT(numbersOf(ended.notes, "broken"), ElementsAre(8));
}

// Some die of what their process did before.
TEST(Batches, SayWhetherANumberDiesAlone) {
    const Ended ended = runBatches({.first = 12, .count = 6, .size = 6}, [](int) -> Work {
        return [done = 0](int, Journal& journal) mutable {
            if (++done == 4)
                std::raise(SIGSEGV);
            journal.note("well", "");
        };
    });
    ASSERT_EQ(ended.deaths.size(), 1U);
    EXPECT_EQ(ended.deaths[0].number, 15);
    EXPECT_EQ(ended.deaths[0].first, 12);
    EXPECT_FALSE(ended.deaths[0].alone);
    EXPECT_THAT(numbersOf(ended.notes, "well"), ElementsAre(12, 13, 14, 15, 16, 17));
}

TEST(Batches, SayWhatKeepsAChildFromBeginning) {
    const Ended ended =
        runBatches({.count = 2}, [](int) -> Work { throw std::runtime_error("no\ncontext"); });
    ASSERT_EQ(ended.deaths.size(), 2U);
    EXPECT_EQ(ended.deaths[0].step, "opening: no context");
    EXPECT_EQ(ended.done, 0);
}

TEST(Batches, KeepAChildWithinItsMemory) {
    const Ended ended = runBatches({.count = 1, .memoryLimit = 1ULL << 30}, [](int) -> Work {
        return [](int, Journal&) { std::vector<char> much(std::size_t{2} << 30); };
    });
    ASSERT_EQ(ended.notes.size(), 1U);
    EXPECT_THAT(ended.notes[0].text, HasSubstr("bad_alloc"));
}

} // namespace
} // namespace texplorer::random::batches_test

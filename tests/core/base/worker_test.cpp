#include "tests/support/no_threads.h"
#include "texplorer/base/thrown.h"
#include "texplorer/base/worker.h"

#include <gmock/gmock.h>

#include <array>
#include <atomic>
#include <latch>
#include <memory>
#include <stdexcept>

namespace texplorer::worker_test {
namespace {

using testing::ElementsAre;

/// Jobs are numbers. The answers come from `work`, errors from their sentences.
class Working : public testing::Test {
protected:
    using Numbers = Worker<int, std::string, float>;

    /// Answers `number * 10`, unless the test sets another function.
    std::unique_ptr<Numbers> make(When when, JobOrder order = JobOrder::Queue) {
        return std::make_unique<Numbers>(
            WorkerSetup{when, order, {"no memory", "can't"}, [this] { ++wakes; }, caller.get_token()},
            [this](const Numbers::Task& task) { return work(task); },
            [](int number, const Error& error) {
                return std::to_string(number) + ": " + error.message.english();
            });
    }
    static std::optional<std::string> timesTen(const Numbers::Task& task) {
        return std::to_string(10 * task.job());
    }

    std::function<std::optional<std::string>(const Numbers::Task&)> work = timesTen;
    std::atomic<int> wakes = 0;
    std::stop_source caller;
};

/// Holds the first job, so that a test knows that it is running.
struct Held {
    std::latch begun{1};
    std::latch goOn{1};

    void pass() {
        begun.count_down();
        goOn.wait();
    }
};

struct Way {
    const char* name;
    When when;
    bool hasThread;
};
class WorkingEachWay : public Working, public testing::WithParamInterface<Way> {
protected:
    WorkingEachWay() {
        if (!GetParam().hasThread)
            noThreads.emplace();
    }
    std::optional<test::NoThreads> noThreads;
};

TEST_P(WorkingEachWay, AnswersInOrderAndWakesForEach) {
    const auto worker = make(GetParam().when);
    for (const int number : {1, 2, 3})
        worker->ask(number);
    worker->wait();
    EXPECT_FALSE(worker->isWorking());
    EXPECT_THAT(worker->take(), ElementsAre("10", "20", "30"));
    EXPECT_EQ(wakes, 3);
    EXPECT_TRUE(worker->take().empty()) << "taken once";
}

TEST_P(WorkingEachWay, WhatIsThrownIsAnAnswerAndTheNextJobIsDone) {
    work = [](const Numbers::Task& task) {
        if (task.job() == 1)
            throw std::bad_alloc();
        if (task.job() == 2)
            throw std::runtime_error("the disc is gone");
        return timesTen(task);
    };
    const auto worker = make(GetParam().when);
    for (const int number : {1, 2, 3})
        worker->ask(number);
    worker->wait();
    EXPECT_THAT(worker->take(), ElementsAre("1: no memory", "2: can't: " + std::string(ownMistake), "30"));
}

TEST_P(WorkingEachWay, GivesEarlierAnswersAndNoneAtAll) {
    work = [](const Numbers::Task& task) -> std::optional<std::string> {
        if (task.job() == 1)
            return std::nullopt;
        task.give("coarse");
        return "fine";
    };
    const auto worker = make(GetParam().when);
    worker->ask(1);
    worker->ask(2);
    worker->wait();
    EXPECT_THAT(worker->take(), ElementsAre("coarse", "fine"));
    EXPECT_EQ(wakes, 2);
}

TEST_P(WorkingEachWay, KnowsWhetherSomebodyWaits) {
    work = [](const Numbers::Task& task) { return task.atOnce() ? "at once" : "later"; };
    const auto worker = make(GetParam().when);
    worker->ask(1);
    worker->wait();
    EXPECT_THAT(worker->take(), ElementsAre(GetParam().hasThread ? "later" : "at once"));
}

TEST_P(WorkingEachWay, TheCallersTokenEndsWhatIsDoneAtOnce) {
    work = [](const Numbers::Task& task) {
        return std::to_string(static_cast<int>(task.stop().stop_requested())) +
               std::to_string(static_cast<int>(task.superseded().stop_requested()));
    };
    caller.request_stop();
    const auto worker = make(GetParam().when);
    worker->ask(1);
    worker->wait();
    EXPECT_THAT(worker->take(), ElementsAre(GetParam().hasThread ? "00" : "11"));
}

TEST_P(WorkingEachWay, LetsAJobGoBeforeItIsThroughWithIt) {
    using Sharing = Worker<std::shared_ptr<int>, int>;
    auto job = std::make_shared<int>(7);
    const std::weak_ptr<int> alive = job;
    Sharing worker(
        {.when = GetParam().when}, [](const Sharing::Task& task) { return *task.job(); },
        [](const std::shared_ptr<int>&, const Error&) { return -1; });
    worker.ask(std::move(job));
    worker.wait();
    EXPECT_TRUE(alive.expired());
    EXPECT_THAT(worker.take(), ElementsAre(7));
}

INSTANTIATE_TEST_SUITE_P(All, WorkingEachWay,
                         testing::Values(Way{"AtOnce", When::AtOnce, false},
                                         Way{"NoThread", When::WhenReady, false},
                                         Way{"Thread", When::WhenReady, true}),
                         [](const auto& test) { return test.param.name; });

TEST_F(Working, StartsItsThreadAsSoonAsThereIsOne) {
    work = [](const Numbers::Task& task) { return task.atOnce() ? "at once" : "later"; };
    const auto worker = make(When::WhenReady);
    {
        const test::NoThreads none;
        worker->ask(1);
    }
    worker->ask(2);
    worker->wait();
    EXPECT_THAT(worker->take(), ElementsAre("at once", "later"));
}

TEST_F(Working, TheNewestWins) {
    Held held;
    work = [&](const Numbers::Task& task) -> std::optional<std::string> {
        if (task.job() == 1) {
            held.pass();
            EXPECT_TRUE(task.superseded().stop_requested());
            EXPECT_FALSE(task.stop().stop_requested()) << "its answer is better than none";
        } else {
            EXPECT_FALSE(task.superseded().stop_requested());
        }
        return timesTen(task);
    };
    const auto worker = make(When::WhenReady, JobOrder::NewestWins);
    worker->ask(1);
    held.begun.wait();
    worker->ask(2); // never done
    worker->ask(3);
    held.goOn.count_down();
    worker->wait();
    EXPECT_EQ(wakes, 2) << "for 1 and 3";
    EXPECT_THAT(worker->take(), ElementsAre("30")) << "the answer to 1 was not taken";
}

TEST_F(Working, NothingComesOfWhatIsDropped) {
    Held held;
    work = [&](const Numbers::Task& task) -> std::optional<std::string> {
        if (task.job() == 1) {
            held.pass();
            EXPECT_TRUE(task.stop().stop_requested());
            EXPECT_TRUE(task.superseded().stop_requested());
            task.give("too late");
        }
        return timesTen(task);
    };
    const auto worker = make(When::WhenReady);
    worker->ask(1);
    worker->ask(2);
    worker->ask(3);
    held.begun.wait();
    worker->drop([](int number) { return number < 3; });
    EXPECT_TRUE(worker->isWorking()) << "3 waits";
    worker->drop([](int number) { return number == 3; });
    EXPECT_FALSE(worker->isWorking());
    worker->wait(); // returns at once, although the thread is still busy
    worker->ask(4);
    held.goOn.count_down();
    worker->wait();
    EXPECT_THAT(worker->take(), ElementsAre("40"));
    EXPECT_EQ(wakes, 1);
}

TEST_F(Working, AnswersCanBeLookedAtAndDiscardedUntilTheyAreTaken) {
    const auto worker = make(When::WhenReady);
    for (const int number : {1, 2, 3})
        worker->ask(number);
    worker->wait();
    worker->discard([](const std::string& answer) { return answer == "20"; });
    std::size_t letters = 0;
    worker->look([&](const std::string& answer) { letters += answer.size(); });
    EXPECT_EQ(letters, 4U);
    EXPECT_THAT(worker->take(), ElementsAre("10", "30"));
    worker->ask(4);
    worker->wait();
    worker->clear();
    EXPECT_TRUE(worker->take().empty());
}

TEST_F(Working, SaysHowFarItIs) {
    Held held;
    work = [&](const Numbers::Task& task) {
        if (task.job() == 1) {
            task.report(0.5F);
            held.pass();
        }
        return timesTen(task);
    };
    const auto worker = make(When::WhenReady);
    EXPECT_EQ(worker->progress(), std::nullopt);
    worker->ask(1, 0.0F);
    worker->ask(2); // nothing to mention
    worker->ask(3, 0.25F);
    held.begun.wait();
    EXPECT_EQ(worker->progress(), 0.5F);
    EXPECT_EQ(wakes, 1) << "for the report";
    worker->drop([](int number) { return number == 1; });
    EXPECT_EQ(worker->progress(), 0.25F) << "of the next that waits";
    held.goOn.count_down();
    worker->wait();
    EXPECT_EQ(worker->progress(), std::nullopt);
}

TEST_F(Working, EndsWhileItWorks) {
    Held held;
    std::atomic<int> done = 0;
    work = [&](const Numbers::Task& task) {
        if (task.job() == 1) {
            held.begun.count_down();
            while (!task.stop().stop_requested()) // requested by the destructor alone
                std::this_thread::yield();
        }
        ++done;
        return timesTen(task);
    };
    {
        const auto worker = make(When::WhenReady);
        for (int number = 1; number <= 100; ++number)
            worker->ask(number);
        held.begun.wait();
    }
    EXPECT_EQ(done, 1) << "what waits is not begun";
    EXPECT_EQ(wakes, 0) << "there is nothing to wake";
}

TEST_F(Working, EndsWithoutHavingBeenAsked) {
    EXPECT_TRUE(make(When::WhenReady)->take().empty());
    EXPECT_TRUE(make(When::AtOnce)->take().empty());
}

TEST(Tried, PassesOnResultsAndErrors) {
    constexpr FailureWords words{"no memory", "can't"};
    EXPECT_EQ(tried(words, [] { return 7; }), Result<int>(7));
    const Result<int> refused =
        tried(words, [] { return Result<int>(fail(ErrorCode::Malformed, "odd", "x")); });
    EXPECT_EQ(refused.error(), (Error{ErrorCode::Malformed, "odd", "x"}));
    const auto threw = [&](auto what) { return tried(words, [&]() -> int { throw what; }).error(); };
    EXPECT_EQ(threw(std::bad_alloc()), (Error{ErrorCode::TooLarge, "no memory", ""}));
    EXPECT_EQ(threw(std::runtime_error("sorry")),
              (Error{ErrorCode::Unsupported, "can't: " + std::string(ownMistake), ""}));
}

} // namespace
} // namespace texplorer::worker_test

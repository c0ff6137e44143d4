#include "app/screenshot/workers/pool.h"
#include "app/screenshot/workers/work_loop.h"
#include "tests/support/temp_dir.h"
#include "texplorer/files/file_io.h"

#include <gmock/gmock.h>

#include <csignal>
#include <fcntl.h>
#include <set>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace texplorer::workers::pool_test {
namespace {

using namespace std::chrono_literals;
using testing::AllOf;
using testing::Each;
using testing::Field;
using testing::HasSubstr;

PoolSetup setupWith(unsigned processes) {
    PoolSetup setup;
    setup.command.arguments = {"texplorer_screenshot_tests"};
    setup.processes = processes;
    return setup;
}

/// The outcomes of jobs with these messages, in their order.
std::vector<Outcome> outcomesOf(Pool& pool, const std::vector<std::string>& messages,
                                std::chrono::duration<double> limit = 60s) {
    std::vector<Outcome> outcomes(messages.size());
    std::size_t next = 0;
    std::set<std::size_t> ended;
    const Result<void> done = pool.run(
        [&]() -> std::optional<Job> {
            if (next == messages.size())
                return std::nullopt;
            const std::size_t number = next++;
            return Job{.number = number, .message = messages[number], .limit = limit};
        },
        [&](Outcome outcome) {
            EXPECT_TRUE(ended.insert(outcome.number).second) << "twice";
            outcomes.at(outcome.number) = std::move(outcome);
        });
    EXPECT_TRUE(done) << done.error().message;
    EXPECT_EQ(ended.size(), messages.size());
    return outcomes;
}

std::vector<Outcome> outcomesOf(const std::vector<std::string>& messages, unsigned processes = 2,
                                std::chrono::duration<double> limit = 60s) {
    Pool pool(setupWith(processes));
    return outcomesOf(pool, messages, limit);
}

TEST(Pool, EveryJobHasItsAnswer) {
    std::vector<std::string> messages;
    for (int i = 0; i < 200; ++i)
        messages.push_back("echo " + std::string(static_cast<std::size_t>(i) * 997, 'x') + std::to_string(i));
    const std::vector<Outcome> outcomes = outcomesOf(messages, 3);
    for (std::size_t i = 0; i < messages.size(); ++i) {
        EXPECT_EQ(outcomes[i].end, Outcome::End::Answered);
        EXPECT_EQ(outcomes[i].answer, messages[i].substr(5));
        EXPECT_EQ(outcomes[i].attempt, 1);
    }
    EXPECT_TRUE(outcomesOf({}).empty());
}

TEST(Pool, ProcessesStayForTheNextRun) {
    Pool pool(setupWith(1));
    const std::string first = outcomesOf(pool, {"process"})[0].answer;
    const std::vector<Outcome> outcomes = outcomesOf(pool, {"process", "process"});
    EXPECT_THAT(outcomes, Each(Field(&Outcome::answer, first)));
    EXPECT_NE(first, std::to_string(::getpid()));
    EXPECT_EQ(outcomes[1].before, 2U);
}

TEST(Pool, CrashIsTheJobsAloneAndIsToldByItsSignal) {
    const std::vector<Outcome> outcomes = outcomesOf({"echo 1", "raise " + std::to_string(SIGSEGV), "echo 2",
                                                      "raise " + std::to_string(SIGABRT), "exit 3", "echo 3"},
                                                     1);
    for (const std::size_t good : {0U, 2U, 5U})
        EXPECT_EQ(outcomes[good].end, Outcome::End::Answered) << good;
    EXPECT_EQ(outcomes[1].end, Outcome::End::Crashed);
    EXPECT_EQ(sentenceOf(outcomes[1], "the driver"),
              "the driver crashed: SIGSEGV, segmentation fault (after 1 other case in the same process)");
    EXPECT_EQ(sentenceOf(outcomes[3], "the driver"),
              "the driver crashed: SIGABRT, aborted (after 1 other case in the same process)");
    EXPECT_EQ(sentenceOf(outcomes[4], "the driver"), "the driver ended the process, with status 3");
}

TEST(Pool, JobThatHangsIsEndedAtItsLimit) {
    const std::vector<Outcome> outcomes = outcomesOf({"hang", "echo 1", "echo 2"}, 2, 1s);
    EXPECT_EQ(outcomes[0].end, Outcome::End::Hung);
    EXPECT_EQ(sentenceOf(outcomes[0], "the reference"),
              "no answer within 1 s: the reference hangs, or needs more time");
    EXPECT_EQ(outcomes[1].answer + outcomes[2].answer, "12");
}

TEST(Pool, ProcessThatIsStoppedHangs) {
    const std::vector<Outcome> outcomes = outcomesOf({"raise " + std::to_string(SIGSTOP), "echo 1"}, 1, 1s);
    EXPECT_EQ(outcomes[0].end, Outcome::End::Hung);
    EXPECT_EQ(outcomes[1].answer, "1");
}

TEST(Pool, WhatIsKilledFromOutsideIsTriedOnceMore) {
    const test::TempDir folder;
    const std::vector<Outcome> outcomes =
        outcomesOf({"killed-once " + (folder / "mark").string(), "raise " + std::to_string(SIGKILL)}, 1);
    EXPECT_EQ(outcomes[0].end, Outcome::End::Answered);
    EXPECT_EQ(outcomes[0].attempt, 2);
    EXPECT_EQ(outcomes[1].end, Outcome::End::Killed);
    EXPECT_EQ(outcomes[1].attempt, 2);
    EXPECT_THAT(sentenceOf(outcomes[1], "the driver"), HasSubstr("and so was a second one: SIGKILL"));
}

TEST(Pool, ProcessThatGoesBetweenJobsTakesNoneWithIt) {
    Pool pool(setupWith(1));
    for (int i = 0; i < 20; ++i) {
        const Outcome before = outcomesOf(pool, {"process"})[0];
        ASSERT_EQ(::kill(std::stoi(before.answer), SIGSEGV), 0);
        const Outcome after = outcomesOf(pool, {"process"})[0];
        EXPECT_EQ(after.end, Outcome::End::Answered);
        EXPECT_NE(after.answer, before.answer);
        EXPECT_EQ(after.before, 0U);
    }
}

TEST(Pool, WhatADriverPrintsIsNoAnswerAndIsKeptForTheSentence) {
    const std::vector<Outcome> outcomes =
        outcomesOf({"print \1\2\3hello\n", "print dying", "raise " + std::to_string(SIGSEGV), "echo 1"}, 1);
    EXPECT_EQ(outcomes[0].answer, "\1\2\3hello\n");
    EXPECT_EQ(outcomes[0].lastWords, "");
    EXPECT_EQ(outcomes[2].lastWords, "") << "that was said by the job before";
    EXPECT_EQ(outcomes[3].answer, "1");
    std::string loud = "print " + std::string(300000, 'x');
    EXPECT_EQ(outcomesOf({loud})[0].answer.size(), 300000U) << "the writer does not wait for a reader";
}

TEST(Pool, GarbageFromAProcessEndsItAndItsJob) {
    const std::vector<Outcome> outcomes = outcomesOf({"garble", "echo 1"}, 1);
    EXPECT_EQ(outcomes[0].end, Outcome::End::Garbled);
    EXPECT_EQ(outcomes[1].end, Outcome::End::Answered);
}

TEST(Pool, JobsWithAnotherEnvironmentHaveOtherProcesses) {
    Pool pool(setupWith(2));
    std::vector<std::string> answers(6);
    std::size_t next = 0;
    const Result<void> done = pool.run(
        [&]() -> std::optional<Job> {
            if (next == answers.size())
                return std::nullopt;
            Job job{.number = next, .message = "environment TEST_VALUE"};
            if (next >= 3)
                job.environment = {"TEST_VALUE=" + std::to_string(next / 4)};
            ++next;
            return job;
        },
        [&](const Outcome& outcome) { answers[outcome.number] = outcome.answer; });
    EXPECT_TRUE(done);
    EXPECT_THAT(answers, testing::ElementsAre("(none)", "(none)", "(none)", "0", "1", "1"));
}

TEST(Pool, ProcessThatGrewIsReplaced) {
    PoolSetup setup = setupWith(1);
    setup.maxResidentBytes = std::size_t{200} << 20;
    Pool pool(setup);
    const std::vector<Outcome> outcomes = outcomesOf(pool, {"process", "process", "grow 300", "process"});
    EXPECT_EQ(outcomes[0].answer, outcomes[1].answer);
    EXPECT_NE(outcomes[0].answer, outcomes[3].answer);
}

TEST(Pool, ProcessIsReplacedAfterSoManyJobs) {
    PoolSetup setup = setupWith(1);
    setup.maxJobs = 2;
    Pool pool(setup);
    const std::vector<Outcome> outcomes = outcomesOf(pool, {"process", "process", "process", "process"});
    EXPECT_EQ(outcomes[0].answer, outcomes[1].answer);
    EXPECT_NE(outcomes[1].answer, outcomes[2].answer);
    EXPECT_EQ(outcomes[2].answer, outcomes[3].answer);
}

TEST(Pool, JobsThatAreTooHeavyTogetherAreDoneOneByOne) {
    PoolSetup setup = setupWith(4);
    setup.maxWeight = 10;
    Pool pool(setup);
    int handed = 0;
    int answered = 0;
    const Result<void> done = pool.run(
        [&]() -> std::optional<Job> {
            EXPECT_LE(handed - answered, 1) << "one is done, one is looked at";
            if (handed == 6)
                return std::nullopt;
            return Job{.number = static_cast<std::size_t>(handed++), .message = "echo 1", .weight = 11};
        },
        [&](const Outcome&) { ++answered; });
    EXPECT_TRUE(done);
    EXPECT_EQ(answered, 6);
}

TEST(Pool, ProcessesThatNeverBeginEndTheRunWithWhatTheySaid) {
    PoolSetup setup = setupWith(2);
    setup.command.environment = {"TEST_WORKER_FAILS=1"};
    const auto once = [sent = false]() mutable -> std::optional<Job> {
        return std::exchange(sent, true) ? std::nullopt : std::optional(Job{.message = "echo 1"});
    };
    const auto never = [](const Outcome&) { FAIL(); };
    Result<void> done = Pool(setup).run(once, never);
    ASSERT_FALSE(done);
    EXPECT_EQ(done.error().message,
              "worker processes end immediately; the last one printed: no screen available");
    setup = setupWith(2);
    setup.command.program = "/nonexistent/program";
    done = Pool(setup).run(once, never);
    ASSERT_FALSE(done);
    EXPECT_EQ(done.error().message, "worker processes end immediately");
}

TEST(Pool, StopRequestEndsWorkAndProcesses) {
    std::stop_source stop;
    pid_t process = 0;
    {
        PoolSetup setup = setupWith(1);
        setup.stop = stop.get_token();
        Pool pool(setup);
        process = std::stoi(outcomesOf(pool, {"process"})[0].answer);
        const Result<void> done = pool.run(
            [&]() -> std::optional<Job> {
                std::thread([&stop] { stop.request_stop(); }).detach();
                return Job{.message = "hang"};
            },
            [](const Outcome&) { FAIL(); });
        ASSERT_FALSE(done);
        EXPECT_EQ(done.error().code, ErrorCode::Cancelled);
    }
    EXPECT_EQ(::kill(process, 0), -1) << "it is gone";
}

TEST(Pool, ProcessesHaveNoneOfTheProgramsFilesAndIgnoreTheTerminal) {
    const Descriptor own(::open("/dev/null", O_RDONLY | O_CLOEXEC));
    Pool pool(setupWith(1));
    const std::vector<Outcome> outcomes =
        outcomesOf(pool, {"inherited " + std::to_string(own.get()), "raise " + std::to_string(SIGINT),
                          "raise " + std::to_string(SIGTERM), "raise " + std::to_string(SIGTSTP), "process"});
    EXPECT_EQ(outcomes[0].answer, "closed");
    EXPECT_THAT(outcomes, Each(Field(&Outcome::end, Outcome::End::Answered)));
}

TEST(Pool, ProcessesEndWithTheProgramThatStartedThem) {
    std::array<int, 2> pipe{};
    ASSERT_EQ(::pipe(pipe.data()), 0);
    const pid_t program = ::fork();
    if (program == 0) { // a program that is killed while its processes work
        Pool pool(setupWith(1));
        const std::string process = outcomesOf(pool, {"process"})[0].answer;
        static_cast<void>(::write(pipe[1], process.data(), process.size()));
        static_cast<void>(pool.run([] { return Job{.message = "hang"}; }, [](const Outcome&) {}));
        _exit(0);
    }
    std::array<char, 32> text{};
    ASSERT_GT(::read(pipe[0], text.data(), text.size() - 1), 0);
    const pid_t process = std::stoi(text.data());
    ASSERT_EQ(::kill(program, SIGKILL), 0);
    ASSERT_EQ(::waitpid(program, nullptr, 0), program);
    const std::string state = "/proc/" + std::to_string(process) + "/stat";
    const auto isGone = [&state] { // or its parent has not asked for its status yet
        const Result<std::string> stat = readText(state, 4096);
        return !stat || stat->find(") Z ") != std::string::npos;
    };
    while (!isGone()) // for ever if it never happens: ctest has a time limit
        std::this_thread::sleep_for(5ms);
    ::close(pipe[0]);
    ::close(pipe[1]);
}

TEST(WorkerSocket, ATypedCallIsNone) {
    const std::array<const char*, 3> typed{"texshot", workerWord, "1"};
    EXPECT_FALSE(workerSocket(3, typed.data())) << "standard output is no socket";
    const std::array<const char*, 3> nonsense{"texshot", workerWord, "x"};
    EXPECT_FALSE(workerSocket(3, nonsense.data()));
    EXPECT_FALSE(workerSocket(2, typed.data()));
}

} // namespace
} // namespace texplorer::workers::pool_test

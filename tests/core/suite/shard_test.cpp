#include "texplorer/suite/shard.h"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

namespace texplorer::suite::shard_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<std::string> namesOf(int count) {
    std::vector<std::string> names;
    for (int i = 0; i < count; ++i)
        names.push_back("case " + std::to_string(i));
    return names;
}

TEST(Shard, WithoutDurationsCasesAreDealtInTurn) {
    const std::vector<std::string> names = namesOf(5);
    EXPECT_THAT(casesOfShard(names, {1, 2}), ElementsAre(0, 2, 4));
    EXPECT_THAT(casesOfShard(names, {2, 2}), ElementsAre(1, 3));
    EXPECT_THAT(casesOfShard(names, {6, 7}), IsEmpty());
}

/// Longest first: 7 to A, 6 to B, 5 to B? no: B has 6, A 7, so 5 to B (11), 4 to A (11), 3 to A (14), 2 to B
/// (13).
TEST(Shard, TheLongestCaseGoesToWhoHasLeastToDo) {
    const std::vector<std::string> names = namesOf(6);
    const Durations durations{{names[0], 2}, {names[1], 3}, {names[2], 4},
                              {names[3], 5}, {names[4], 6}, {names[5], 7}};
    EXPECT_THAT(casesOfShard(names, {1, 2}, durations), ElementsAre(1, 2, 5));
    EXPECT_THAT(casesOfShard(names, {2, 2}, durations), ElementsAre(0, 3, 4));
}

/// Known are 1 and 9 and 5: the other ones count as 5, the median.
TEST(Shard, WhatNobodyKnowsTakesAsLongAsTheMedian) {
    const std::vector<std::string> names = namesOf(5);
    const Durations durations{{names[0], 1}, {names[1], 9}, {names[2], 5}, {"another suite's", 100}};
    // 9 to 1; 5 (case 2) to 2; 5 (case 3) to 2: 10; 5 (case 4) to 1: 14; 1 to 2.
    EXPECT_THAT(casesOfShard(names, {1, 2}, durations), ElementsAre(1, 4));
    EXPECT_THAT(casesOfShard(names, {2, 2}, durations), ElementsAre(0, 2, 3));
}

/// Whatever the file says, and however many shards: no case is lost, and none is drawn twice.
TEST(Shard, EveryCaseIsInExactlyOne) {
    std::mt19937 engine(7);
    const std::vector<std::string> names = namesOf(97);
    for (int round = 0; round < 50; ++round) {
        Durations durations;
        for (const std::string& name : names) {
            constexpr std::array odd{0.0, -1.0, 1e300, 0.25, 1e-300};
            const auto dice = engine() % 8;
            if (dice < odd.size())
                durations[name] = odd[dice];
            else if (dice == 6)
                durations[name] = NAN;
        }
        const int count = 1 + static_cast<int>(engine() % 120);
        std::vector<int> seen(names.size(), 0);
        for (int number = 1; number <= count; ++number) {
            for (const std::size_t each : casesOfShard(names, {number, count}, durations))
                ++seen[each];
        }
        EXPECT_THAT(seen, testing::Each(1)) << count;
    }
}

/// Graham 1969: LPT is within 4/3 of the best; the best can't be below the mean or the longest case.
TEST(Shard, PartsAreBalanced) {
    std::mt19937 engine(3);
    const std::vector<std::string> names = namesOf(200);
    Durations durations;
    double sum = 0;
    double longest = 0;
    for (const std::string& name : names) {
        const double seconds = 0.1 + static_cast<double>(engine() % 1000) / 100;
        durations[name] = seconds;
        sum += seconds;
        longest = std::max(longest, seconds);
    }
    constexpr int parts = 8;
    for (int number = 1; number <= parts; ++number) {
        double load = 0;
        for (const std::size_t each : casesOfShard(names, {number, parts}, durations))
            load += durations[names[each]];
        EXPECT_LE(load, std::max(sum / parts, longest) * 4 / 3);
    }
}

TEST(Shard, DurationsAreReadBack) {
    const Durations durations{{"a/b", 0.25}, {"\"<>", 3}};
    const Result<Durations> read = parseDurations(writeDurations(durations));
    ASSERT_TRUE(read) << describe(read.error());
    EXPECT_EQ(*read, durations);
    EXPECT_EQ(*parseDurations(writeDurations({})), Durations{});
}

TEST(Shard, BrokenDurationsAreRefused) {
    const std::array<std::pair<std::string, std::string>, 6> wrongs{{
        {"", "the file ends"},
        {"{}", "expected the key \"version\""},
        {R"({"version": 2, "seconds": {}})", "/version: expected version 1, found 2"},
        {R"({"version": 1, "seconds": []})", "expected an object"},
        {R"({"version": 1, "seconds": {"a": -1}})", "/seconds/a: expected seconds from 0"},
        {R"({"version": 1, "seconds": {"a": "1"}})", "/seconds/a: expected seconds from 0"},
    }};
    for (const auto& [text, said] : wrongs) {
        const Result<Durations> read = parseDurations(text);
        ASSERT_FALSE(read) << text;
        EXPECT_THAT(describe(read.error()), HasSubstr(said));
    }
}

TEST(Shard, OfAKilledCaseTheTimeSaysNothing) {
    RunRecord run;
    run.cases = {{.name = "a", .state = State::Passed},
                 {.name = "b", .state = State::TimedOut},
                 {.name = "c", .state = State::Skipped},
                 {.name = "d", .state = State::Failed}};
    for (CaseRecord& each : run.cases)
        each.seconds = 2;
    EXPECT_EQ(durationsOf(run, {{"a", 1}, {"b", 1}, {"e", 1}}),
              (Durations{{"a", 2}, {"b", 1}, {"d", 2}, {"e", 1}}));
}

} // namespace
} // namespace texplorer::suite::shard_test

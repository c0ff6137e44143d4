#include "texplorer/suite/merge.h"

#include <gmock/gmock.h>

namespace texplorer::suite::merge_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

RunRecord part(int number, int count, const std::vector<std::string>& names, std::size_t planned = 4) {
    RunRecord run;
    run.program = "texshot 0.1.0";
    run.suites = {"s"};
    run.plan = "p";
    run.driver = "driver " + std::to_string(number);
    run.started = "2026-11-22T02:3" + std::to_string(9 - number) + ":00Z";
    run.planned = planned;
    run.shard = {number, count};
    run.names = names;
    run.seconds = number;
    for (const std::string& name : names)
        run.cases.push_back({.name = name, .state = State::Passed});
    return run;
}

TEST(Merge, JoinsParts) {
    RunRecord second = part(2, 2, {"b", "d"});
    second.cases[1].state = State::Failed;
    const Result<Merged> merged = merge({part(1, 2, {"a", "c"}), second}, {"1.json", "2.json"});
    ASSERT_TRUE(merged) << describe(merged.error());
    EXPECT_THAT(merged->problems, IsEmpty());
    EXPECT_EQ(merged->status, 1);
    EXPECT_THAT(merged->run.names, ElementsAre("a", "c", "b", "d"));
    EXPECT_EQ(merged->run.cases.size(), 4U);
    EXPECT_EQ(merged->run.seconds, 3);
    EXPECT_EQ(merged->run.driver, "driver 1, driver 2");
    EXPECT_EQ(merged->run.started, "2026-11-22T02:37:00Z");
    EXPECT_EQ(merged->run.shard, Shard{});
}

TEST(Merge, AHoleIsAnError) {
    const Result<Merged> absent = merge({part(1, 3, {"a"}), part(3, 3, {"c"})}, {"1.json", "3.json"});
    ASSERT_TRUE(absent) << describe(absent.error());
    EXPECT_EQ(absent->status, 2);
    EXPECT_THAT(absent->problems,
                ElementsAre("there is no report of \"2/3\"", "2 of 4 cases are in no report"));

    RunRecord cut = part(2, 2, {"b", "d"});
    cut.cases.pop_back();
    const Result<Merged> killed = merge({part(1, 2, {"a", "c"}), cut}, {"1.json", "2.json"});
    ASSERT_TRUE(killed) << describe(killed.error());
    EXPECT_EQ(killed->status, 2);
    EXPECT_THAT(killed->problems, ElementsAre("1 case was not run: \"d\""));
}

TEST(Merge, OfACaseThatIsThereTwiceTheLaterAttemptOrTheWorseStays) {
    RunRecord again = part(2, 2, {"a", "c", "b", "d"});
    again.cases[0].state = State::Failed;  // worse
    again.cases[1].state = State::Crashed; // an earlier attempt
    RunRecord first = part(1, 2, {"a", "c"});
    first.cases[1].attempt = 2;
    const Result<Merged> merged = merge({first, again}, {"1.json", "2.json"});
    ASSERT_TRUE(merged) << describe(merged.error());
    EXPECT_THAT(merged->problems, ElementsAre("2 cases are in several reports: \"a\", \"c\""));
    EXPECT_EQ(merged->run.cases[0].state, State::Failed);
    EXPECT_EQ(merged->run.cases[1].state, State::Passed);
    EXPECT_EQ(merged->status, 1);
}

TEST(Merge, OtherSuitesAreRefused) {
    EXPECT_THAT(merge({}, {}).error().message, HasSubstr("found none"));
    RunRecord other = part(2, 2, {"b"});
    other.suites = {"t"};
    const Result<Merged> suites = merge({part(1, 2, {"a"}), other}, {"1.json", "2.json"});
    ASSERT_FALSE(suites);
    EXPECT_EQ(describe(suites.error()), "2.json: \"1.json\" and \"2.json\" are of different suites");
    other = part(2, 2, {"b"});
    other.plan = "q";
    EXPECT_THAT(merge({part(1, 2, {"a"}), other}, {"1", "2"}).error().message, HasSubstr("different cases"));
    EXPECT_THAT(merge({part(1, 2, {"a"}), part(2, 3, {"b"})}, {"1", "2"}).error().message,
                HasSubstr("different divisions"));
}

} // namespace
} // namespace texplorer::suite::merge_test

#include "tests/core/suite/sample_run.h"
#include "texplorer/suite/record.h"

#include <gmock/gmock.h>

namespace texplorer::suite::record_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

TEST(Record, SaysWhatCameOfItAll) {
    const RunRecord run = samples::sampleRun();
    EXPECT_EQ(summary(run),
              "12 cases: 1 passed, 1 failed, 1 new, 1 without scene, 1 in error, 1 crashed, 1 timed out, "
              "1 skipped, 1 resized, 1 missing, 1 extra, 1 not run");
    EXPECT_THAT(run.missing(), ElementsAre("late/fixed@8x8"));
    const std::string text = asText(run);
    EXPECT_THAT(text, HasSubstr("failed: failed/fixed@8x8\n    it is failed\n"));
    EXPECT_THAT(text, HasSubstr("skipped: skipped/fixed@8x8\n    it is skipped\n"));
    EXPECT_THAT(text, HasSubstr("not run: late/fixed@8x8\n"));
    EXPECT_THAT(text, Not(HasSubstr("passed/fixed")));
    EXPECT_TRUE(text.ends_with("not run\n"));
}

TEST(Record, AReasonForSkippingIsSaidOnce) {
    RunRecord run;
    for (const char* const reason : {"no S3TC", "undefined", "no S3TC", "no S3TC"}) {
        run.names.push_back("case " + std::to_string(run.names.size()));
        run.cases.push_back({.name = run.names.back(), .state = State::Skipped, .sentence = reason});
    }
    EXPECT_EQ(asText(run), "skipped: case 0 and 2 more cases\n    no S3TC\n"
                           "skipped: case 1\n    undefined\n"
                           "4 cases: 4 skipped\n");
}

RunRecord runOf(std::initializer_list<State> states) {
    RunRecord run;
    for (const State state : states) {
        run.names.push_back(std::to_string(run.names.size()));
        run.cases.push_back({.name = run.names.back(), .state = state});
    }
    return run;
}

TEST(Record, ExitStatusIsThatOfTheWorst) {
    EXPECT_EQ(exitStatus(runOf({State::Passed, State::Skipped})), 0);
    for (const State state : {State::Failed, State::New, State::Crashed, State::TimedOut, State::Resized,
                              State::Missing, State::Extra})
        EXPECT_EQ(exitStatus(runOf({State::Passed, state})), 1) << rowOf(state).name;
    EXPECT_EQ(exitStatus(runOf({State::Failed, State::Error})), 2);
    EXPECT_EQ(exitStatus(runOf({State::MissingScene, State::Passed})), 2);
    EXPECT_EQ(exitStatus(runOf({})), 2);
    RunRecord cut = runOf({State::Passed});
    cut.names.emplace_back("another");
    EXPECT_EQ(exitStatus(cut), 2);
}

TEST(Record, RowsStandInTheOrderOfTheStates) {
    for (std::size_t i = 0; i < stateRows.size(); ++i)
        EXPECT_EQ(static_cast<std::size_t>(stateRows[i].state), i);
}

TEST(Record, ShardsAreReadStrictly) {
    EXPECT_EQ(parseShard("2/5"), (Shard{2, 5}));
    for (const char* text : {"", "2", "/5", "2/", "0/5", "6/5", "-1/5", "2/5x", "2 / 5", "1/9999999", "a/b"})
        EXPECT_FALSE(parseShard(text)) << text;
}

} // namespace
} // namespace texplorer::suite::record_test

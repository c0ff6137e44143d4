#include "core/suite/run_page.h"
#include "tests/core/suite/sample_run.h"

#include <gmock/gmock.h>

namespace texplorer::suite::run_page_test {
namespace {

TEST(RunPage, HasEveryCase) {
    const RunRecord run = samples::sampleRun();
    const report::Page page = pageOf(run, {.acceptCommand = "texshot test s.suite.json --accept accept.txt"});
    EXPECT_EQ(page.title, "s");
    EXPECT_EQ(page.verdict, summary(run));
    EXPECT_EQ(page.tone, report::Tone::Bad);
    ASSERT_EQ(page.cases.size(), run.cases.size() + 1);
    EXPECT_EQ(page.cases.back().state, report::State::NotRun);
    const report::Case& failed = page.cases[1];
    EXPECT_EQ(failed.name, "failed/fixed@8x8");
    EXPECT_EQ(failed.group, "failed");
    EXPECT_EQ(failed.state, report::State::Failed);
    ASSERT_TRUE(failed.expected && failed.actual && failed.difference);
    EXPECT_EQ(failed.actual->file, "failed-actual.png");
    EXPECT_TRUE(failed.actual->pixels);
    EXPECT_EQ(failed.worst, (std::array{3, 4}));
    EXPECT_EQ(failed.size, (std::array{8, 8}));
    EXPECT_TRUE(failed.acceptable);
    EXPECT_FALSE(page.cases[0].acceptable);
    EXPECT_FALSE(page.cases[0].expected);
}

TEST(RunPage, WhatTheReferenceSaysCantBeAccepted) {
    CaseRecord record = samples::sampleRun().cases[1];
    EXPECT_TRUE(isAcceptable(record));
    record.golden = "reference";
    EXPECT_FALSE(isAcceptable(record));
}

TEST(RunPage, WithoutProblemsIsGood) {
    RunRecord run = samples::sampleRun();
    run.names.resize(1);
    run.cases.resize(1);
    EXPECT_EQ(pageOf(run).tone, report::Tone::Good);
}

} // namespace
} // namespace texplorer::suite::run_page_test

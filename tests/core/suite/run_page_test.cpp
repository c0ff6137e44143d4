#include "tests/core/suite/sample_run.h"
#include "texplorer/compare/heat_map.h"
#include "texplorer/suite/run_page.h"

#include <gmock/gmock.h>

#include <cctype>

namespace texplorer::suite::run_page_test {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsSupersetOf;
using testing::Not;

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

std::vector<std::string> factsOf(const report::Case& of) {
    std::vector<std::string> lines;
    for (const report::Fact& each : of.facts)
        lines.push_back(each.name + ": " + each.value);
    return lines;
}

report::Case pageCaseOf(const CaseRecord& record) {
    RunRecord run = samples::sampleRun();
    run.cases = {record};
    run.names = {record.name};
    return pageOf(run).cases[0];
}

TEST(RunPage, SaysHowMuchDiffersAndHowMuchMay) {
    CaseRecord record = samples::sampleRun().cases[1];
    EXPECT_THAT(factsOf(pageCaseOf(record)), Contains("Settings: GALLIVM_PERF=nopt"));
    EXPECT_THAT(factsOf(pageCaseOf(record)), IsSupersetOf({"Metric: absolute", "Mean difference: 1.5/255",
                                                           "Over 2/255: 32 (50 %), allowed 12.5 %"}));
    record.metric = "flip";
    record.tolerance = 0.1;
    EXPECT_THAT(factsOf(pageCaseOf(record)),
                IsSupersetOf({"Mean FLIP error: 1.5", "Over 0.1: 32 (50 %), allowed 12.5 %"}));
    record.metric = "rule level-blend";
    record.tolerance = 2;
    record.unexplained = 0;
    EXPECT_THAT(factsOf(pageCaseOf(record)),
                IsSupersetOf(
                    {"Metric: rule level-blend", "Over 2/255: 32 (50 %)", "Unexplained: 0, allowed 12.5 %"}));
    record.unexplained = 16;
    EXPECT_THAT(factsOf(pageCaseOf(record)), Contains("Unexplained: 16 (25 %), allowed 12.5 %"));
    EXPECT_EQ(pageCaseOf(record).distance, 0.25);
    EXPECT_THAT(factsOf(pageCaseOf(samples::sampleRun().cases[8])), Not(Contains(HasSubstr("Over"))));
}

// Black for equal pixels, the colours of the map for others.
TEST(RunPage, SaysWhatTheColorsOfTheMapMean) {
    CaseRecord record = samples::sampleRun().cases[1];
    const std::vector<report::Swatch> legend = pageCaseOf(record).legend;
    ASSERT_EQ(legend.size(), 10U);
    EXPECT_EQ(legend[0].color, (std::array<std::uint8_t, 3>{0, 0, 0}));
    for (const auto& [label, color] : legend) {
        const auto known = heatColor(std::stof(label), {2, 255});
        EXPECT_EQ(color, (std::array{known[0], known[1], known[2]})) << label;
    }
    record.metric = "flip";
    record.tolerance = 0.1;
    EXPECT_EQ(pageCaseOf(record).legend.back().label, "1");
    record.differencePicture.clear();
    EXPECT_TRUE(pageCaseOf(record).legend.empty());
}

TEST(RunPage, SaysHowToRepeatAndToDrawACase) {
    CaseRecord record = samples::sampleRun().cases[1];
    const report::Case failed = pageCaseOf(record);
    ASSERT_EQ(failed.commands.size(), 2U);
    EXPECT_EQ(failed.commands[0].line, "texshot test s.suite.json --only failed/fixed@8x8");
    EXPECT_EQ(failed.commands[1].line,
              "texshot shot failed-actual.png --renderer fixed --size 8x8 --time 1.5 -o again.png");
    ASSERT_EQ(failed.links.size(), 1U);
    EXPECT_EQ(failed.links[0].file, "failed-actual.png");
    record.renderer.clear(); // of --pictures: drawn by any renderer
    EXPECT_EQ(pageCaseOf(record).commands.size(), 1U);
    EXPECT_TRUE(pageCaseOf(record).links.empty());
}

TEST(RunPage, GroupsWhatHasAFolder) {
    CaseRecord record = samples::sampleRun().cases[0];
    record.name = "menus/main.png";
    EXPECT_EQ(pageCaseOf(record).group, "menus");
    record.name = "main.png";
    EXPECT_EQ(pageCaseOf(record).group, "");
}

/// The list and the summary use the same words.
TEST(RunPage, HasTheWordsOfTheSummary) {
    const RunRecord run = samples::sampleRun();
    const report::Page page = pageOf(run);
    EXPECT_EQ(page.madeBy, "texshot 0.1.0 on 2026-11-22 02:30 UTC in 3.5 s");
    for (std::size_t i = 0; i < run.cases.size(); ++i) {
        std::string label(texplorer::rowOf(page.cases[i].state).label);
        label.front() = static_cast<char>(std::tolower(label.front()));
        if (run.cases[i].state == State::MissingScene)
            continue; // an error, distinguished by its message
        EXPECT_EQ(label, rowOf(run.cases[i].state).text);
    }
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

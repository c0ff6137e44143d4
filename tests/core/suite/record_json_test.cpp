#include "tests/core/suite/sample_run.h"
#include "texplorer/suite/record_json.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace texplorer::suite::record_json_test {
namespace {

using testing::HasSubstr;

/// What is no UTF-8 can't stand in JSON.
RunRecord asWritten(RunRecord run) {
    run.cases[1].explanation = "s = 0.5\n<b>&\x01\xEF\xBF\xBD";
    return run;
}

std::string journalOf(const RunRecord& run) {
    std::string text = journalStart(run);
    for (const CaseRecord& each : run.cases)
        text += journalLine(each);
    return text;
}

TEST(RecordJson, AReportIsReadBack) {
    const RunRecord run = samples::sampleRun();
    const Result<RunRecord> read = parseRun(asJson(run));
    ASSERT_TRUE(read) << describe(read.error());
    EXPECT_EQ(*read, asWritten(run));
}

TEST(RecordJson, AReportSaysTheCounts) {
    const nlohmann::json json = nlohmann::json::parse(asJson(samples::sampleRun()));
    EXPECT_EQ(json["counts"]["timed-out"], 1);
    EXPECT_EQ(json["counts"]["not-run"], 1);
    EXPECT_EQ(json["status"], 2);
    EXPECT_EQ(json["cases"][1]["worst"]["actual"], (nlohmann::json{5, 6, 7, 128}));
}

TEST(RecordJson, AJournalIsReadBack) {
    const RunRecord run = samples::sampleRun();
    const std::string text = journalOf(run);
    const Result<Journal> journal = parseJournal(text);
    ASSERT_TRUE(journal) << describe(journal.error());
    EXPECT_EQ(journal->run, asWritten(run));
    EXPECT_EQ(journal->wholeBytes, text.size());
    EXPECT_EQ(journal->note, "");
    EXPECT_EQ(*parseRun(text), asWritten(run));
}

/// Wherever a run was killed: what is whole is there, and the rest is what has to be run.
TEST(RecordJson, AJournalMayEndAnywhere) {
    const RunRecord run = samples::sampleRun();
    const std::string text = journalOf(run);
    const std::size_t head = journalStart(run).size();
    for (std::size_t size = head; size < text.size(); ++size) {
        const std::string_view cut = std::string_view(text).substr(0, size);
        const Result<Journal> journal = parseJournal(cut);
        ASSERT_TRUE(journal) << size << ": " << describe(journal.error());
        const auto lines = static_cast<std::size_t>(std::ranges::count(cut, '\n'));
        EXPECT_EQ(journal->run.cases.size(), lines - 1);
        EXPECT_EQ(journal->note.empty(), cut.ends_with('\n'));
        EXPECT_EQ(cut.substr(0, journal->wholeBytes), cut.substr(0, cut.rfind('\n') + 1));
    }
    const Result<Journal> none = parseJournal(std::string_view(text).substr(0, head - 1));
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().message, "expected the journal of a run, found no complete line");
}

TEST(RecordJson, OfACaseThatWasRunAgainTheLastRecordStays) {
    RunRecord run = samples::sampleRun();
    CaseRecord again = run.cases[1];
    again.state = State::Passed;
    const Result<Journal> journal = parseJournal(journalOf(run) + journalLine(again));
    ASSERT_TRUE(journal) << describe(journal.error());
    EXPECT_EQ(journal->run.cases[1].state, State::Passed);
    EXPECT_EQ(journal->run.cases.size(), run.cases.size());
}

struct Wrong {
    std::string text;
    std::string said;
};

// A report that an earlier version has left is still one: it is replaced, merged and gone on with.
TEST(RecordJson, SettingsOfTheWholeRunAreRead) {
    const RunRecord run = samples::sampleRun();
    std::string text = asJson(run);
    const std::size_t at = text.find("\"planned\"");
    ASSERT_NE(at, std::string::npos);
    text.insert(at, "\"settings\": \"GALLIVM_PERF=nopt\", ");
    const Result<RunRecord> read = parseRun(text);
    ASSERT_TRUE(read) << describe(read.error());
    EXPECT_EQ(asJson(*read), asJson(run));
}

TEST(RecordJson, TheSizeOfAnEarlierVersionIsRead) {
    const Result<CaseRecord> read = parseCaseRecord(R"({"name": "a", "state": "passed", "size": [24, 16]})");
    ASSERT_TRUE(read) << describe(read.error());
    EXPECT_EQ((std::pair(read->width, read->height)), (std::pair(24, 16)));
}

TEST(RecordJson, OfAnErrorHasItsKind) {
    const CaseRecord record = problemOf({.name = "a"}, {ErrorCode::TooLarge, "too large", inFile("b.json")});
    EXPECT_EQ(record.state, State::Error);
    const Result<CaseRecord> read = parseCaseRecord(journalLine(record));
    ASSERT_TRUE(read) << describe(read.error());
    EXPECT_EQ(*read, record);
    EXPECT_EQ(nlohmann::json::parse(journalLine(record))["code"], "TooLarge");
    EXPECT_EQ(record.sentence, "b.json: too large");
}

TEST(RecordJson, WhatIsWrongIsSaidWithItsLine) {
    const std::string head = journalStart(samples::sampleRun());
    const std::array wrongs{
        Wrong{head + "nonsense\n", "line 2: "},
        Wrong{head + "{\"name\": \"late/fixed@8x8\"}\n", "line 2: expected the key \"state\""},
        Wrong{head + R"({"name": "late/fixed@8x8", "state": "pased"})" + "\n", "line 2: /state"},
        Wrong{head + R"({"name": "other", "state": "passed"})" + "\n", "\"other\" is not a case of this run"},
        Wrong{head + R"({"name": "late/fixed@8x8", "state": "failed", "actualPicture": "a\u001b[31m.png"})" +
                  "\n",
              "line 2: /actualPicture: expected a file's name within the folder"},
        Wrong{head + R"({"name": "late/fixed@8x8", "state": "failed", "actualPicture": "../x.png"})" + "\n",
              "line 2: /actualPicture: expected a file's name within the folder"},
        Wrong{head + R"({"name": "late/fixed@8x8", "state": "failed", "worst": {"x": -1}})" + "\n",
              "/worst/x"},
        Wrong{head + R"({"name": "late/fixed@8x8", "state": "failed", "worst": {"actual": [1, 2, 3, 256]}})" +
                  "\n",
              "/worst/actual"},
        Wrong{"{\"run\": 2}\n", "line 1: /run: expected version 1, found 2"},
        Wrong{"{\"run\": 1, \"shard\": [0, 1]}\n", "line 1: /shard"},
    };
    for (const Wrong& each : wrongs) {
        const Result<Journal> journal = parseJournal(each.text);
        ASSERT_FALSE(journal) << each.text;
        EXPECT_THAT(describe(journal.error()), HasSubstr(each.said));
    }
    const Result<RunRecord> report = parseRun("{\n\"run\": 1, \"kases\": []}");
    ASSERT_FALSE(report);
    EXPECT_THAT(describe(report.error()), HasSubstr("/kases: unknown key; did you mean \"cases\"?"));
}

TEST(RecordJson, AJournalOfAnotherRunIsNoticed) {
    const RunRecord now = samples::sampleRun();
    EXPECT_TRUE(checkResumable(now, now));
    RunRecord other = now;
    other.driver = "softpipe";
    EXPECT_THAT(checkResumable(other, now).error().message,
                HasSubstr("the journal has another driver, \"softpipe\""));
    other = now;
    other.shard = {1, 2};
    EXPECT_THAT(checkResumable(other, now).error().message, HasSubstr("another part, \"1/2\""));
    other = now;
    other.plan = "x";
    EXPECT_THAT(checkResumable(other, now).error().message, HasSubstr("the same cases in another order"));
    other = now;
    other.names.pop_back();
    EXPECT_EQ(checkResumable(other, now).error().message,
              "the journal has other cases: \"late/fixed@8x8\" is a new one");
}

} // namespace
} // namespace texplorer::suite::record_json_test

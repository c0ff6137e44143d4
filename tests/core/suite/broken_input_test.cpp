// Suites, journals, reports and durations that were cut off, or changed at random: each is read, or refused
// in one line.

#include "tests/core/suite/sample_run.h"
#include "texplorer/suite/accept_list.h"
#include "texplorer/suite/plan.h"
#include "texplorer/suite/record_json.h"
#include "texplorer/suite/shard.h"

#include <gmock/gmock.h>

#include <random>

namespace texplorer::suite::broken_input_test {
namespace {

constexpr std::string_view sampleSuite = R"({
  "suite": 1, "name": "textures", "about": "A", "defaults": {"size": ["8x8", "9x9"], "golden": "reference"},
  "cases": [
    {"scene": {"lesson": "wrap", "step": 3}, "axis": ["textures[0].wrapS=*", "textures[0].lodBias=0..2/3"]},
    {"name": "n", "scene": [{"example": "checker"}, "a.json"], "set": ["preset:seam", "view.azimuth=3"],
     "time": [0, 1.5], "renderer": "fixed", "rule": "none", "metric": "ssim", "tolerance": 0.25, "share": 0.125},
    {"scene": {"inline": {"version": 1, "view": {"distance": 3}}}, "mask": "m.png", "seconds": 1,
     "golden": {"*": ["g/{case}.png", "g/{picture}@{driver}.png"], "llvmpipe*": "b.png"}}
  ]})";

std::string sampleJournal() {
    const RunRecord run = samples::sampleRun();
    std::string text = journalStart(run);
    for (const CaseRecord& each : run.cases)
        text += journalLine(each);
    return text;
}

/// One to four changes: bytes, digits, brackets and pieces of the text itself, taken away, put in or doubled.
std::string broken(std::string text, std::mt19937& engine) {
    constexpr std::string_view signs = "\"{}[],:0919eE-+.\\/\n\x01\xFF\xC3u*=;x";
    const auto below = [&](std::size_t count) { return static_cast<std::size_t>(engine()) % count; };
    for (std::size_t changes = 1 + below(4); changes > 0 && !text.empty(); --changes) {
        const std::size_t at = below(text.size());
        const std::size_t count = 1 + below(std::min<std::size_t>(40, text.size() - at));
        switch (below(5)) {
        case 0:
            text[at] = signs[below(signs.size())];
            break;
        case 1:
            text.insert(at, 1, signs[below(signs.size())]);
            break;
        case 2:
            text.erase(at, count);
            break;
        case 3:
            text.insert(below(text.size()), text.substr(at, count));
            break;
        default:
            text.resize(at);
        }
    }
    return text;
}

template<class T>
void expectOneLine(const Result<T>& result, std::string_view text) {
    if (result)
        return;
    EXPECT_FALSE(result.error().message.empty()) << text;
    EXPECT_EQ(describe(result.error()).english().find_first_of("\n\r\x1B"), std::string::npos)
        << describe(result.error());
    EXPECT_LT(describe(result.error()).english().size(), 2000U) << text.substr(0, 200);
}

void readSuiteText(const std::string& text) {
    Result<Suite> suite = parseSuite(text);
    expectOneLine(suite, text);
    if (suite)
        expectOneLine(planOf({*std::move(suite)}, {.renderers = {}, .only = {}, .limit = 500}), text);
}

TEST(BrokenSuites, AreReadOrRefusedInALineWithoutACrash) {
    ASSERT_TRUE(parseSuite(sampleSuite)) << describe(parseSuite(sampleSuite).error());
    for (std::size_t size = 0; size < sampleSuite.size(); ++size)
        readSuiteText(std::string(sampleSuite.substr(0, size)));
    std::mt19937 engine(1);
    for (int i = 0; i < 3000; ++i)
        readSuiteText(broken(std::string(sampleSuite), engine));
}

TEST(BrokenRecords, AreReadOrRefusedInALineWithoutACrash) {
    const std::string journal = sampleJournal();
    const std::string report = asJson(samples::sampleRun());
    const std::string durations = writeDurations({{"a", 1}, {"b", 2.5}});
    const std::vector<std::string> known = samples::sampleRun().names;
    std::mt19937 engine(2);
    for (int i = 0; i < 1500; ++i) {
        const std::string ofJournal = broken(journal, engine);
        expectOneLine(parseJournal(ofJournal), ofJournal);
        const std::string ofReport = broken(report, engine);
        expectOneLine(parseRun(ofReport), ofReport);
        const std::string ofDurations = broken(durations, engine);
        expectOneLine(parseDurations(ofDurations), ofDurations);
        const std::string list = broken("# a list\n" + known[0] + "\n" + known[1] + "\n", engine);
        expectOneLine(parseAcceptList(list, known), list);
    }
}

} // namespace
} // namespace texplorer::suite::broken_input_test

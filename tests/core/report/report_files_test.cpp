#include "texplorer/files/file_io.h"
#include "texplorer/report/report_files.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <limits>

namespace texplorer::report_files_test {
namespace {

using nlohmann::json;
using report::Case;
using report::File;
using report::Page;
using report::Picture;
using report::State;
using testing::HasSubstr;
using testing::Not;
using testing::UnorderedElementsAre;

std::string textOf(const Bytes& bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

Bytes bytesOf(std::string_view text) {
    const ByteView view = viewBytes(text);
    return {view.begin(), view.end()};
}

std::string fileOf(const std::vector<File>& files, std::string_view name) {
    const auto found = std::ranges::find(files, name, &File::name);
    EXPECT_NE(found, files.end()) << name;
    return found == files.end() ? std::string() : textOf(found->bytes);
}

std::vector<std::string> namesOf(const std::vector<File>& files) {
    std::vector<std::string> names;
    names.reserve(files.size());
    for (const File& file : files)
        names.push_back(file.name);
    return names;
}

/// The data that the page's scripts get.
json dataOf(const Page& page) {
    const auto files = report::filesOf(page);
    if (!files) {
        ADD_FAILURE() << describe(files.error());
        return {};
    }
    const std::string script = fileOf(*files, "report-data.js");
    constexpr std::string_view begin = "texplorerReport = ";
    EXPECT_TRUE(script.starts_with(begin));
    EXPECT_TRUE(script.ends_with(";\n"));
    return json::parse(script.substr(begin.size(), script.size() - begin.size() - 2));
}

Page pageWith(Case each) {
    Page page;
    page.title = "Pictures";
    page.acceptCommand = "texshot test suite.json --accept accept.txt";
    page.cases.push_back(std::move(each));
    return page;
}

TEST(ReportFiles, EveryPageHasTheNamedFilesAndAnEmptyOneNoOthers) {
    const auto files = report::filesOf({});
    ASSERT_TRUE(files);
    EXPECT_THAT(namesOf(*files), testing::UnorderedElementsAreArray(report::pageFileNames()));
}

TEST(ReportFiles, AnEmptyPageIsAFolderToo) {
    const auto files = report::filesOf({});
    ASSERT_TRUE(files);
    EXPECT_THAT(namesOf(*files),
                UnorderedElementsAre("index.html", "report.css", "report.js", "report-data.js"));
    const json data = dataOf({});
    EXPECT_EQ(data["cases"], json::array());
    EXPECT_EQ(data["tables"], json::array());
    EXPECT_EQ(data["states"].size(), EnumTable<State>::rows.size());
}

TEST(ReportFiles, ThePageAsksForNothingOutsideOfItsFolder) {
    const auto files = *report::filesOf({});
    for (const char* name : {"index.html", "report.css", "report.js"}) {
        const std::string text = fileOf(files, name);
        EXPECT_THAT(text, Not(HasSubstr("http:"))) << name;
        EXPECT_THAT(text, Not(HasSubstr("https:"))) << name;
        EXPECT_THAT(text, Not(HasSubstr("@import"))) << name;
    }
    const std::string script = fileOf(files, "report.js");
    for (const char* parsing : {"innerHTML", "outerHTML", "insertAdjacentHTML", "document.write", "eval("})
        EXPECT_THAT(script, Not(HasSubstr(parsing)));
}

TEST(ReportFiles, SayWhatACaseIs) {
    Case each{.name = "wrap/repeat", .group = "wrap", .state = State::Failed};
    each.message = "3 pixels are over 2.";
    each.expected = {.label = "Expected", .file = "pictures/wrap 1.png"};
    each.actual = {.label = "Actual", .file = "pictures/wrap 2.png", .pixels = true};
    each.legend = {{"4", {1, 2, 255}}};
    each.size = {640, 480};
    each.worst = {{12, 40}};
    each.distance = 0.25;
    each.seconds = 1.5;
    each.facts = {{"Metric", "flip"}};
    each.explanation = "unit 0\n\ttexel 1,2\n";
    each.links = {{"Scene", "scenes/wrap.json"}};
    each.commands = {{"To repeat it", "texshot test --only wrap"}};
    each.acceptable = true;
    const json said = dataOf(pageWith(each))["cases"][0];
    EXPECT_EQ(said, json::parse(R"({
        "name": "wrap/repeat", "group": "wrap", "state": "failed", "message": "3 pixels are over 2.",
        "pictures": [{"role": "expected", "label": "Expected", "file": "pictures/wrap 1.png", "pixels": false},
                     {"role": "actual", "label": "Actual", "file": "pictures/wrap 2.png", "pixels": true}],
        "legend": [{"label": "4", "color": [1, 2, 255]}], "size": [640, 480], "worst": [12, 40], "distance": 0.25,
        "seconds": 1.5, "facts": [["Metric", "flip"]], "explanation": "unit 0\n\ttexel 1,2\n",
        "links": [{"label": "Scene", "file": "scenes/wrap.json"}],
        "commands": [{"label": "To repeat it", "line": "texshot test --only wrap"}],
        "acceptable": true})"));
}

TEST(ReportFiles, SayWhatTheRunWas) {
    Page page;
    page.title = "Title";
    page.verdict = "1 of 1 failed";
    page.tone = report::Tone::Bad;
    page.introduction = {"One.", "Two."};
    page.madeBy = "texshot";
    page.command = "texshot test";
    page.environment = {{"Renderer", "llvmpipe"}};
    page.tables = {{.title = "Sums",
                    .columns = {{"group"}, {"cases", true}},
                    .rows = {{{"wrap", {}, 0}, {"1", State::Crashed}}},
                    .notes = {"A note."}}};
    page.cases = {{.name = "a"}};
    const json data = dataOf(page);
    EXPECT_EQ(data["title"], "Title");
    EXPECT_EQ(data["verdict"], "1 of 1 failed");
    EXPECT_EQ(data["tone"], "bad");
    EXPECT_EQ(data["introduction"], json::parse(R"(["One.", "Two."])"));
    EXPECT_EQ(data["environment"], json::parse(R"([["Renderer", "llvmpipe"]])"));
    EXPECT_EQ(data["tables"], json::parse(R"([{"title": "Sums", "notes": ["A note."],
        "columns": [{"label": "group", "number": false}, {"label": "cases", "number": true}],
        "rows": [[{"text": "wrap", "case": 0}, {"text": "1", "tone": "bad"}]]}])"));
}

// Data that a browser stores for a report, such as accepted cases, does not apply to the next run in the same
// folder.
TEST(ReportFiles, AnotherRunHasAnotherKey) {
    const json first = dataOf(pageWith({.name = "a", .state = State::Failed}));
    EXPECT_EQ(first["key"], dataOf(pageWith({.name = "a", .state = State::Failed}))["key"]);
    EXPECT_NE(first["key"], dataOf(pageWith({.name = "a", .state = State::Crashed}))["key"]);
}

TEST(ReportFiles, TextsFromOutsideStayTexts) {
    struct Row {
        const char* name;
        const char* given;
        const char* shown;
    };
    for (const auto& [name, given, shown] :
         {Row{"the end of a script", "</script><script>alert(1)</script>",
              "</script><script>alert(1)</script>"},
          Row{"a comment", "<!--<script", "<!--<script"}, Row{"quotes", "\"'`${1}\\", "\"'`${1}\\"},
          Row{"a line separator", "a\xE2\x80\xA8z", "a\\u2028z"},
          Row{"bytes that are no UTF-8", "a\xFF\xC3z", "a\xEF\xBF\xBD\xEF\xBF\xBDz"},
          Row{"an escape", "\x1B[31m", "\\u001b[31m"},
          Row{"reversed", "\xE2\x80\xAEgpj.exe", "\\u202egpj.exe"}}) {
        Page page = pageWith({.name = given, .group = given});
        page.title = given;
        page.environment = {{given, given}};
        const auto files = *report::filesOf(page);
        const std::string script = fileOf(files, "report-data.js");
        EXPECT_TRUE(std::ranges::all_of(script, [](char each) {
            return each == '\n' || (each >= ' ' && each < 0x7F);
        })) << name;
        EXPECT_EQ(std::ranges::count(script, '\n'), 1) << name;
        EXPECT_THAT(script, Not(HasSubstr("<"))) << name;
        const json data = dataOf(page);
        EXPECT_EQ(data["title"], shown) << name;
        EXPECT_EQ(data["cases"][0]["name"], shown) << name;
        EXPECT_EQ(data["cases"][0]["group"], shown) << name;
        EXPECT_EQ(data["environment"][0], (json{shown, shown})) << name;
        // The page itself is the same for every report.
        EXPECT_EQ(fileOf(files, "index.html"), fileOf(*report::filesOf({}), "index.html"));
    }
}

TEST(ReportFiles, ANameThatTheListCannotHoldIsNotAccepted) {
    struct Row {
        const char* name;
        bool accepted;
    };
    for (const auto& [name, accepted] :
         {Row{"wrap/repeat 1", true}, Row{"<b>\"&'", true}, Row{"\xC3\xA4", true}, Row{"", false},
          Row{"two\nlines", false}, Row{"carriage\r", false}, Row{"\xFF", false}, Row{" spaced", false},
          Row{"\xE2\x80\xA8", false}}) {
        const json said =
            dataOf(pageWith({.name = name, .state = State::New, .acceptable = true}))["cases"][0];
        EXPECT_EQ(said.contains("acceptable"), accepted) << name;
    }
    Page page = pageWith({.name = "a", .acceptable = true});
    page.acceptCommand.clear();
    EXPECT_FALSE(dataOf(page)["cases"][0].contains("acceptable"));
}

TEST(ReportFiles, PicturesComeWithTheirPixels) {
    Case each{.name = "../../etc/passwd"};
    each.expected = {.label = "Expected", .png = bytesOf("PNG 1")};
    each.actual = {.label = "Actual", .file = "own name.png", .png = bytesOf("PNG 2")};
    const auto files = report::filesOf(pageWith(each));
    ASSERT_TRUE(files);
    EXPECT_THAT(namesOf(*files),
                UnorderedElementsAre("index.html", "report.css", "report.js", "report-data.js",
                                     "0001-expected.png", "0001-expected.png.js", "own name.png",
                                     "own name.png.js"));
    EXPECT_EQ(fileOf(*files, "0001-expected.png"), "PNG 1");
    EXPECT_EQ(fileOf(*files, "0001-expected.png.js"),
              "texplorerPixels(\"0001-expected.png\",\"UE5HIDE=\");\n");
    EXPECT_EQ(fileOf(*files, "own name.png.js"), "texplorerPixels(\"own name.png\",\"UE5HIDI=\");\n");
    const File pixels = report::pixelsOf("a/\"</script>\".png", viewBytes("PNG 1"));
    EXPECT_EQ(pixels.name, "a/\"</script>\".png.js");
    EXPECT_EQ(textOf(pixels.bytes), "texplorerPixels(\"a/\\\"\\u003c/script>\\\".png\",\"UE5HIDE=\");\n");
}

TEST(ReportFiles, NoFileLeavesTheFolder) {
    for (const char* name : {"../a.png", "/etc/a.png", "a/../../b.png", "a//b.png", "./a.png", "a/", "..",
                             "a\\..\\b.png", "C:a.png", "javascript:alert(1)", "a\nb.png", "\xFF.png", ""}) {
        Case shown{.name = "a"};
        shown.expected = {.label = "Expected", .file = name};
        Case written{.name = "a"};
        written.expected = {.label = "Expected", .file = name, .png = bytesOf("PNG")};
        Case linked{.name = "a", .links = {{"Scene", name}}};
        for (const Case& each : {shown, written, linked}) {
            if (*name == '\0' && each.expected && !each.expected->png.empty())
                continue; // the page finds a name
            const auto files = report::filesOf(pageWith(each));
            ASSERT_FALSE(files) << name;
            EXPECT_EQ(files.error().code, ErrorCode::OutOfRange);
            EXPECT_THAT(files.error().message,
                        HasSubstr("expected the name of a file within the report's folder, found \""));
        }
    }
}

TEST(ReportFiles, NoFileIsWrittenTwice) {
    for (const char* name :
         {"index.html", "report.js", "report-data.js", "0002-actual.png", "0002-actual.png.js"}) {
        Page page = pageWith({.name = "a"});
        page.cases[0].expected = {.label = "Expected", .file = name, .png = bytesOf("PNG")};
        page.cases.push_back({.name = "b", .actual = Picture{.label = "Actual", .png = bytesOf("PNG")}});
        const auto files = report::filesOf(page);
        ASSERT_FALSE(files) << name;
        EXPECT_THAT(files.error().message, HasSubstr("for each file of the report, found \""));
    }
}

TEST(ReportFiles, WhatIsNoNumberIsLeftOut) {
    Case each{.name = "a",
              .distance = std::numeric_limits<double>::infinity(),
              .seconds = std::numeric_limits<double>::quiet_NaN()};
    each.size = {-1, 20};
    const json said = dataOf(pageWith(each))["cases"][0];
    EXPECT_TRUE(said["distance"].is_null());
    EXPECT_TRUE(said["seconds"].is_null());
    EXPECT_FALSE(said.contains("size"));
}

TEST(ReportState, WhatIsWrongComesFirst) {
    EXPECT_TRUE(std::ranges::is_sorted(EnumTable<State>::rows, {}, [](const EnumRow& row) {
        return std::min(toneOf(static_cast<State>(row.value)), report::Tone::Quiet);
    }));
    EXPECT_EQ(EnumTable<State>::rows.back().name, "skipped"); // the least interesting state
    EXPECT_EQ(toneOf(State::Crashed), report::Tone::Bad);
    EXPECT_EQ(toneOf(State::Extra), report::Tone::Bad);
    EXPECT_EQ(toneOf(State::New), report::Tone::Look);
    EXPECT_EQ(toneOf(State::Skipped), report::Tone::Quiet);
    EXPECT_EQ(toneOf(State::Agree), report::Tone::Good);
}

} // namespace
} // namespace texplorer::report_files_test

#include "texplorer/codec/dds/dds.h"
#include "texplorer/codec/png/png.h"
#include "texplorer/conform/made_files.h"
#include "texplorer/conform/report.h"
#include "texplorer/s3tc/surface_pixels.h"
#include "texplorer/scene/params/json.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <sstream>

namespace texplorer::conform::report_test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

/// The reference with the wrap modes of s and t exchanged.
class Swapped : public Renderer {
public:
    Result<Frame> draw(const Scene& scene) override {
        Scene changed = scene;
        for (Texture& texture : changed.textures)
            std::swap(texture.wrapS, texture.wrapT);
        return reference_->draw(changed);
    }

private:
    std::unique_ptr<Renderer> reference_ = referenceRenderer();
};

Report reportOf(std::vector<const Feature*> chosen) {
    Swapped swapped;
    SweepOptions options;
    options.selection = {1, 20 * static_cast<int>(chosen.size()), std::move(chosen)};
    options.pairs = {Pair{RendererKind::Reference, RendererKind::Fixed}};
    options.driver = {"llvmpipe <&>\x1B", "4.5", "A=b", {}};
    return *sweep(options, {&swapped, nullptr});
}

TEST(Report, IsATableWhoseColumnsStandBelowEachOther) {
    const Report report =
        reportOf({findFeature("wrap"), findFeature("incomplete"), findFeature("compression")});
    EXPECT_FALSE(report.agrees());
    const std::string text = asText(report);
    EXPECT_THAT(text, HasSubstr("reference against fixed\nfeature"));
    EXPECT_THAT(text, HasSubstr("DIFFER"));
    EXPECT_THAT(text, HasSubstr("agree"));
    EXPECT_THAT(text, HasSubstr("skipped: driver-compression, "));
    EXPECT_THAT(text, HasSubstr("on llvmpipe <&>\x1B, 4.5, with A=b: not all agree\n"));
    EXPECT_THAT(text, HasSubstr("  –  ")); // a cause that no rule explains has no number
    std::istringstream lines(text);
    std::string line;
    std::getline(lines, line);
    std::getline(lines, line);
    const std::size_t column = line.find("verdict");
    for (int row = 0; row < 3; ++row) {
        std::getline(lines, line);
        if (const std::size_t dash = line.find("–"); dash != std::string::npos)
            line.replace(dash, std::string_view("–").size(), "-");
        const std::string verdict = line.substr(column, 5);
        EXPECT_TRUE(verdict == "agree" || verdict == "DIFFE") << line;
    }
}

report::Page pageOf(const Report& report) {
    return *asPage(report);
}

MATCHER_P2(IsFact, name, value, "") {
    return arg.name == name && arg.value == value;
}

TEST(Report, SaysTheSameOfAllInEachForm) {
    struct Row {
        const char* words;
        const char* inPage;
        report::Tone tone;
        bool compared;
        Report report;
    };
    Report none = reportOf({findFeature("wrap")});
    none.pairs[0].outcomes[0].all = {};
    Report some = reportOf({findFeature("incomplete")});
    Report most = some;
    most.pairs[0].outcomes[0].skipped[&skips()[0]] = 4;
    const std::string sum = std::to_string(some.scenes + 4);
    const std::string skipped = "all agree, 4 of " + sum + " comparisons skipped";
    const std::string skippedInPage = "All agree, 4 of " + sum + " comparisons skipped";
    for (const auto& [words, inPage, tone, compared, report] :
         {Row{": nothing was compared\n", "Nothing was compared", report::Tone::Quiet, false, none},
          Row{": all agree\n", "All agree", report::Tone::Good, true, some},
          Row{": not all agree\n", "Not all agree", report::Tone::Bad, true, reportOf({findFeature("wrap")})},
          Row{skipped.c_str(), skippedInPage.c_str(), report::Tone::Good, true, most}}) {
        EXPECT_THAT(asText(report), HasSubstr(words));
        EXPECT_EQ(pageOf(report).verdict, inPage);
        EXPECT_EQ(pageOf(report).tone, tone);
        EXPECT_EQ(nlohmann::json::parse(asJson(report))["compared"], compared) << words;
    }
}

// Row 0 of an image is the bottom one; probe counts from the top. A twentieth of a thousandth is not printed
// as 0.
TEST(Report, SaysWhereHowMuchAndHowToMakeItAgain) {
    Report report = reportOf({findFeature("trilinear")});
    report.origin = {"texshot 9.9", "A=b texshot conform --seed 1", "2026-01-02 03:04 UTC"};
    report.driver.name = "llvmpipe <&>";
    report.seconds = 12.34;
    Outcome& outcome = report.pairs[0].outcomes[0];
    outcome.all.pixels = 1000000;
    outcome.all.over = 20;
    outcome.all.unexplained = 0;
    outcome.worst->judgement.difference.worst = {3, 0};
    outcome.worst->judgement.difference.max = 7;
    const report::Page page = pageOf(report);
    EXPECT_EQ(page.madeBy, "texshot 9.9 on 2026-01-02 03:04 UTC in 12.3 s");
    EXPECT_EQ(page.command, "A=b texshot conform --seed 1");
    EXPECT_THAT(page.environment, ElementsAre(IsFact("Driver", "llvmpipe <&>"), IsFact("Version", "4.5"),
                                              IsFact("Settings", "A=b")));
    EXPECT_EQ(page.tables[0].title, "Reference against fixed function");
    std::vector<std::string> cells;
    for (const report::Cell& cell : page.tables[0].rows[0])
        cells.push_back(cell.text);
    EXPECT_THAT(cells, ElementsAre("trilinear", testing::_, testing::_, "1000000", "<0.01 %", testing::_,
                                   testing::_, testing::_, testing::_, "4 % over 2, 0.05 % unexplained"));
    EXPECT_EQ(page.tables[0].rows[0][0].leadsTo, 0U);
    const report::Case& each = page.cases[0];
    EXPECT_EQ(each.name, "trilinear-reference-fixed");
    EXPECT_EQ(each.group, "Reference against fixed function");
    EXPECT_THAT(each.message, HasSubstr("; the worst by 7 at 3,63, counted from the upper left."));
    EXPECT_EQ(each.worst, (std::array{3, 63}));
    ASSERT_EQ(each.commands.size(), 1U);
    EXPECT_EQ(each.commands[0].line, "texshot probe trilinear-reference-fixed.json --size 64x64 --at 3,63");
    EXPECT_THAT(each.facts, Contains(IsFact("Over 2", "<0.01 %")));
    EXPECT_THAT(each.facts, Contains(IsFact("Rule level-blend", std::string(rules::levelBlend.reason))));
    const std::string text = asText(report);
    for (const char* expected : {"  <0.01 %", "in 12.3 s on llvmpipe <&>, 4.5, with A=b",
                                 "texshot 9.9, to draw them again: A=b texshot conform --seed 1\n"})
        EXPECT_THAT(text, HasSubstr(expected));
    const auto json = nlohmann::json::parse(asJson(report));
    EXPECT_EQ(json["program"], "texshot 9.9");
    EXPECT_EQ(json["command"], "A=b texshot conform --seed 1");
    EXPECT_EQ(json["driver"], "llvmpipe <&>");
    const auto& worst = json["pairs"][0]["features"][0]["worst"];
    EXPECT_EQ(worst["x"], 3);
    EXPECT_EQ(worst["y"], 63);
}

TEST(Report, IsJsonForPrograms) {
    const Report report = reportOf({findFeature("wrap"), findFeature("incomplete")});
    const auto json = nlohmann::json::parse(asJson(report));
    EXPECT_EQ(json["agrees"], false);
    EXPECT_EQ(json["scenes"], report.scenes);
    const auto& wrap = json["pairs"][0]["features"][0];
    EXPECT_EQ(wrap["feature"], "wrap");
    EXPECT_EQ(wrap["agrees"], false);
    EXPECT_GT(wrap["all"]["over"], 0);
    EXPECT_EQ(wrap["all"]["pixels"], wrap["shapes"]["quad"]["pixels"]);
    EXPECT_EQ(wrap["worst"]["files"], "wrap-reference-fixed");
    EXPECT_EQ(json["pairs"][0]["features"][1]["agrees"], true);
}

TEST(Report, IsAFolderWithTheWorstScenes) {
    const Result<std::vector<report::File>> files = asFolder(reportOf({findFeature("wrap")}));
    ASSERT_TRUE(files);
    const auto file = [&](std::string_view name) {
        const auto found = std::ranges::find(*files, name, &report::File::name);
        EXPECT_NE(found, files->end()) << name;
        return found == files->end() ? Bytes() : found->bytes;
    };
    const Bytes scene = file("wrap-reference-fixed.json");
    const auto parsed = parseScene({reinterpret_cast<const char*>(scene.data()), scene.size()});
    ASSERT_TRUE(parsed) << describe(parsed.error());
    // The picture is that of the scene.
    const Result<TextureImage> picture = decodePng(file("wrap-reference-fixed-reference.png"), {});
    ASSERT_TRUE(picture);
    EXPECT_EQ(toImage(picture->surface(0, 0)), referenceRenderer()->draw(*parsed)->image);
    EXPECT_TRUE(decodePng(file("wrap-reference-fixed-fixed.png"), {}));
    // The files that scenes name are in the same folder.
    for (const MadeFile& made : madeFiles)
        EXPECT_TRUE(decodeDds(file(made.name)));
    EXPECT_TRUE(decodePng(file("wrap-reference-fixed-difference.png"), {}));
    EXPECT_FALSE(file("report.json").empty());
    // The page lists them.
    const Bytes data = file("report-data.js");
    const std::string text(reinterpret_cast<const char*>(data.data()), data.size());
    for (const char* expected : {"\"wrap-reference-fixed-reference.png\"", "\"wrap-reference-fixed.json\"",
                                 "llvmpipe \\u003c&>\\\\u001b"})
        EXPECT_THAT(text, HasSubstr(expected));
    EXPECT_FALSE(file("index.html").empty());
    EXPECT_FALSE(file("wrap-reference-fixed-fixed.png.js").empty());
}

// The expected picture is that of the yardstick.
TEST(Report, IsAPageOfCases) {
    const report::Page page =
        pageOf(reportOf({findFeature("wrap"), findFeature("incomplete"), findFeature("compression")}));
    ASSERT_EQ(page.cases.size(), 3U);
    const auto caseOf = [&page](std::string_view name) {
        const auto found = std::ranges::find(page.cases, name, &report::Case::name);
        EXPECT_NE(found, page.cases.end()) << name;
        return found == page.cases.end() ? report::Case() : *found;
    };
    const report::Case wrap = caseOf("wrap-reference-fixed");
    const report::Case incomplete = caseOf("incomplete-reference-fixed");
    EXPECT_EQ(wrap.state, report::State::Differ);
    EXPECT_EQ(incomplete.state, report::State::Agree);
    EXPECT_EQ(wrap.expected->label, "Fixed function");
    EXPECT_EQ(wrap.actual->label, "Reference");
    EXPECT_EQ(wrap.legend.size(), 10U);
    EXPECT_GT(wrap.distance, incomplete.distance);
    EXPECT_THAT(caseOf("compression-reference-fixed").facts,
                Contains(testing::Field(&report::Fact::name, "Skipped, driver-compression")));
    EXPECT_THAT(page.tables[0].notes, Contains(HasSubstr("skipped (driver-compression): ")));
    for (const report::Case& each : page.cases)
        EXPECT_FALSE(each.acceptable) << each.name; // there is no golden
}

TEST(Report, ListsEveryFeatureRuleAndSkip) {
    const std::string text = listing();
    for (const Feature& feature : features()) {
        EXPECT_THAT(text, HasSubstr(std::string(feature.name)));
        EXPECT_THAT(text, HasSubstr(std::string(feature.reference.reason)));
    }
    for (const Skip& skip : skips())
        EXPECT_THAT(text, HasSubstr(std::string(skip.reason)));
    EXPECT_THAT(text, HasSubstr("\nellipse: 2 % over 16; of a single scene 20 % over 16, 5 % over 128. "));
    EXPECT_THAT(
        text,
        HasSubstr("\ntexel-edge: 0.1 % over 2, 0.05 % unexplained; of a single scene 1 % unexplained. "));
}

} // namespace
} // namespace texplorer::conform::report_test

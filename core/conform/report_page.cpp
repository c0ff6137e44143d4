#include "texplorer/base/sentence.h"
#include "texplorer/base/sentence_format.h"
#include "texplorer/codec/png/png.h"
#include "texplorer/compare/heat_map.h"
#include "texplorer/conform/made_files.h"
#include "texplorer/conform/report.h"
#include "texplorer/conform/report_words.h"
#include "texplorer/files/file_io.h"
#include "texplorer/image/convert.h"
#include "texplorer/scene/params/json.h"
#include "texplorer/text/shell_word.h"

#include <fmt/core.h>

#include <array>
#include <cctype>

namespace texplorer::conform {

namespace {

std::vector<report::Swatch> legend(const HeatScale& scale) {
    std::vector<report::Swatch> swatches;
    for (const HeatStep& step : heatSteps(scale))
        swatches.push_back({std::to_string(step.difference), {step.color[0], step.color[1], step.color[2]}});
    return swatches;
}

report::State stateOf(const Outcome& outcome) {
    switch (outcome.verdict()) {
    case Verdict::Agree:
        return report::State::Agree;
    case Verdict::Differ:
        return report::State::Differ;
    case Verdict::TooFewScenes:
    case Verdict::Skipped:
        break;
    }
    return report::State::Skipped;
}

std::string againstWords(const Pair& pair) {
    std::string against(rowOf(pair.against).label);
    against.front() = static_cast<char>(std::tolower(against.front()));
    return fmt::format("{} against {}", rowOf(pair.subject).label, against);
}

std::vector<report::Fact> factsOf(const Outcome& outcome) {
    const Tally& all = outcome.all;
    const Rule& rule = *outcome.rule;
    std::vector<report::Fact> facts{{"Scenes", fmt::format("{}: {}", all.scenes, outcome.feature->sweeps)},
                                    {"Section of OpenGL 2.1", std::string(outcome.feature->section)},
                                    {"Pixels", std::to_string(all.pixels)},
                                    {fmt::format("Over {}", rule.bound), percent(all.shareOver())}};
    if (rule.tolerance != Tolerance::None)
        facts.push_back({"Unexplained", percent(all.shareUnexplained())});
    facts.push_back({"Worst", std::to_string(all.max)});
    facts.push_back({"Mean", fmt::format("{:.3f}", all.mean())});
    facts.push_back({"Allowed", allowed(outcome)});
    if (outcome.verdict() == Verdict::TooFewScenes)
        facts.push_back({"Too few scenes", std::string(rowOf(Verdict::TooFewScenes).help)});
    if (std::string rho = rhoText(outcome); !rho.empty())
        facts.push_back({"rho", std::move(rho)});
    facts.push_back({fmt::format("Rule {}", rule.name), std::string(rule.reason)});
    for (const auto& [skip, count] : outcome.skipped)
        facts.push_back(
            {fmt::format("Skipped, {}", skip->name),
             fmt::format("{}: {}", Sentence::plural("{0} scene", "{0} scenes", count), skip->reason)});
    return facts;
}

/// What the worst scene of a feature shows.
Result<void> addWorst(report::Case& each, const PairReport& pair, const Outcome& outcome) {
    const Worst& worst = *outcome.worst;
    const HeatScale scale{outcome.rule->bound, 255};
    const Result<Image> heat = heatMap(worst.subject, worst.against, scale);
    if (!heat)
        return fail(heat.error());
    Result<Bytes> difference = encodePng(withoutAlpha(*heat));
    if (!difference)
        return fail(difference.error());
    each.difference = {"Where they differ", each.name + "-difference.png", std::move(*difference)};
    each.legend = legend(scale);
    for (const auto& [kind, image, picture] :
         {std::tuple{pair.pair.subject, &worst.subject, &each.actual},
          std::tuple{pair.pair.against, &worst.against, &each.expected}}) {
        Result<Bytes> png = encodePng(*image);
        if (!png)
            return fail(png.error());
        *picture = {std::string(rowOf(kind).label), fmt::format("{}-{}.png", each.name, rowOf(kind).name),
                    std::move(*png)};
    }
    each.size = {extent, extent};
    each.links = {{"The worst scene", each.name + ".json"}};

    const Judgement& judgement = worst.judgement;
    each.message = fmt::format("Its worst scene has {} over {}",
                               Sentence::plural("{0} pixel", "{0} pixels", judgement.difference.over),
                               outcome.rule->bound);
    if (outcome.rule->tolerance != Tolerance::None)
        each.message += fmt::format(", {} of them unexplained", judgement.unexplained);
    if (judgement.difference.max > 0) {
        const auto [x, y] = placeOfWorst(judgement);
        each.worst = {{x, y}};
        each.message += fmt::format("; the worst by {} at {},{}, counted from the upper left",
                                    judgement.difference.max, x, y);
        each.commands = {{"To explain its worst pixel, in the report's folder",
                          fmt::format("texshot probe {} --size {}x{} --at {},{}",
                                      shellWord(each.name + ".json"), extent, extent, x, y)}};
    }
    each.message += ".";
    return {};
}

Result<report::Case> caseOf(const PairReport& pair, const Outcome& outcome) {
    report::Case each;
    each.name = worstName(pair, outcome);
    each.group = againstWords(pair.pair);
    each.state = stateOf(outcome);
    each.distance = outcome.all.shareOver();
    each.facts = factsOf(outcome);
    if (outcome.worst) {
        if (const Result<void> added = addWorst(each, pair, outcome); !added)
            return fail(added.error());
    }
    if (!outcome.problem.empty())
        each.message += (each.message.empty() ? "" : " ") + outcome.problem;
    return each;
}

std::vector<report::Cell> rowOfTable(const Outcome& outcome, std::size_t number) {
    const Tally& all = outcome.all;
    return {{std::string(outcome.feature->name), {}, number},
            {std::to_string(all.scenes)},
            {std::to_string(skippedOf(outcome))},
            {std::to_string(all.pixels)},
            {percent(all.shareOver())},
            {outcome.rule->tolerance == Tolerance::None ? "–" : percent(all.shareUnexplained())},
            {std::to_string(all.max)},
            {fmt::format("{:.3f}", all.mean())},
            {std::string(rowOf(outcome.verdict()).label), stateOf(outcome)},
            {allowed(outcome)}};
}

/// `first` is the number of the case of its first row.
report::Table tableOf(const PairReport& pair, std::size_t first) {
    report::Table table;
    table.title = againstWords(pair.pair);
    for (const char* label : {"feature", "scenes", "skipped", "pixels", "over the bound", "unexplained",
                              "worst", "mean", "verdict", "allowed"}) {
        const std::size_t column = table.columns.size();
        table.columns.push_back({label, column > 0 && column < 8});
    }
    for (const Outcome& outcome : pair.outcomes) {
        table.rows.push_back(rowOfTable(outcome, first + table.rows.size()));
        for (const auto& [skip, count] : outcome.skipped)
            table.notes.push_back(fmt::format("{}: {} skipped ({}): {}.", outcome.feature->name,
                                              Sentence::plural("{0} scene", "{0} scenes", count), skip->name,
                                              skip->reason));
        if (const std::string rho = rhoText(outcome); !rho.empty())
            table.notes.push_back(fmt::format("{}: {}.", outcome.feature->name, rho));
        if (!outcome.problem.empty())
            table.notes.push_back(fmt::format("{}: {}", outcome.feature->name, outcome.problem));
    }
    return table;
}

report::Page introductionOf(const Report& report) {
    report::Page page;
    page.title = "Do the renderers agree?";
    page.verdict = summary(report);
    page.verdict.front() = static_cast<char>(std::toupper(page.verdict.front()));
    page.tone = report.agrees()     ? report::Tone::Good
                : report.compared() ? report::Tone::Bad
                                    : report::Tone::Quiet;
    page.introduction = {
        whatWasDrawn(report) + ". The worst scene is shown for each feature and pair.",
        "A pixel is over the bound if a component differs by more than its rule allows, and unexplained if "
        "the precision that the rule grants to drivers does not explain it either. Differences are in "
        "255ths. Open a scene with texplorer FILE."};
    const Origin& origin = report.origin;
    if (!origin.program.empty()) {
        page.madeBy = fmt::format("{}{} in {:.1f} s", origin.program,
                                  origin.made.empty() ? "" : " on " + origin.made, report.seconds);
        page.command = origin.command;
    }
    for (const auto& [name, value] :
         {std::pair{"Driver", report.driver.name}, std::pair{"Version", report.driver.version},
          std::pair{"Settings", report.driver.settings}}) {
        if (!value.empty())
            page.environment.push_back({name, value});
    }
    return page;
}

Bytes bytesOf(std::string_view text) {
    const ByteView view = viewBytes(text);
    return {view.begin(), view.end()};
}

} // namespace

Result<report::Page> asPage(const Report& report) {
    report::Page page = introductionOf(report);
    for (const PairReport& pair : report.pairs) {
        page.tables.push_back(tableOf(pair, page.cases.size()));
        for (const Outcome& outcome : pair.outcomes) {
            Result<report::Case> each = caseOf(pair, outcome);
            if (!each)
                return fail(each.error());
            page.cases.push_back(std::move(*each));
        }
    }
    return page;
}

Result<std::vector<report::File>> asFolder(const Report& report) {
    const Result<report::Page> page = asPage(report);
    if (!page)
        return fail(page.error());
    Result<std::vector<report::File>> files = report::filesOf(*page);
    if (!files)
        return files;
    for (const PairReport& pair : report.pairs) {
        for (const Outcome& outcome : pair.outcomes) {
            if (outcome.worst)
                files->push_back(
                    {worstName(pair, outcome) + ".json", bytesOf(writeScene(outcome.worst->scene))});
        }
    }
    for (const MadeFile& file : madeFiles)
        files->push_back({std::string(file.name), bytesOf(file)});
    files->push_back({reportName, bytesOf(asJson(report))});
    return files;
}

} // namespace texplorer::conform

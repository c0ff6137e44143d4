#include "texplorer/base/sentence.h"
#include "texplorer/base/sentence_format.h"
#include "texplorer/conform/report.h"
#include "texplorer/conform/report_words.h"

#include <fmt/core.h>

#include <algorithm>

namespace texplorer::conform {

namespace {

using Cells = std::vector<std::string>;

/// How many letters a terminal shows: in UTF-8, 10xxxxxx is never the first byte of one.
std::size_t lettersOf(const std::string& text) {
    return static_cast<std::size_t>(std::ranges::count_if(
        text, [](char each) { return (static_cast<unsigned char>(each) & 0xC0U) != 0x80U; }));
}

/// Columns as wide as their widest cell; the first and the last two to the left, numbers to the right.
std::string aligned(const std::vector<Cells>& lines) {
    std::vector<std::size_t> widths(lines.front().size());
    for (const Cells& line : lines) {
        for (std::size_t i = 0; i < line.size(); ++i)
            widths[i] = std::max(widths[i], lettersOf(line[i]));
    }
    std::string text;
    for (const Cells& line : lines) {
        std::string row;
        for (std::size_t i = 0; i < line.size(); ++i) {
            const std::string padding(widths[i] - lettersOf(line[i]), ' ');
            const bool left = i == 0 || i + 2 >= line.size();
            row += (i == 0 ? "" : "  ") + (left ? line[i] + padding : padding + line[i]);
        }
        row.erase(row.find_last_not_of(' ') + 1);
        text += row + "\n";
    }
    return text;
}

std::string pairText(const PairReport& pair) {
    std::vector<Cells> lines{
        {"feature", "scenes", "skipped", "pixels", "over", "unexplained", "worst", "verdict", "allowed"}};
    std::map<const Skip*, int> skipped;
    for (const Outcome& outcome : pair.outcomes) {
        const Tally& all = outcome.all;
        const bool tolerance = outcome.rule->tolerance != Tolerance::None;
        lines.push_back({std::string(outcome.feature->name), std::to_string(all.scenes),
                         std::to_string(skippedOf(outcome)), std::to_string(all.pixels),
                         percent(all.shareOver()), tolerance ? percent(all.shareUnexplained()) : "–",
                         std::to_string(all.max), std::string(rowOf(outcome.verdict()).label),
                         allowed(outcome)});
        for (const auto& [skip, count] : outcome.skipped)
            skipped[skip] += count;
    }
    std::string text = fmt::format("{} against {}\n{}", rowOf(pair.pair.subject).name,
                                   rowOf(pair.pair.against).name, aligned(lines));
    for (const Skip& skip : skips()) {
        if (const auto found = skipped.find(&skip); found != skipped.end())
            text += fmt::format("skipped: {}, {}: {}\n", skip.name,
                                Sentence::plural("{0} scene", "{0} scenes", found->second), skip.reason);
    }
    for (const Outcome& outcome : pair.outcomes) {
        if (const std::string rho = rhoText(outcome); !rho.empty())
            text += fmt::format("rho: {}: {}\n", outcome.feature->name, rho);
    }
    for (const Outcome& outcome : pair.outcomes) {
        if (!outcome.problem.empty())
            text += fmt::format("differs: {}: {}\n", outcome.feature->name, outcome.problem);
    }
    return text;
}

} // namespace

std::string asText(const Report& report) {
    std::string text;
    for (const PairReport& pair : report.pairs)
        text += pairText(pair) + "\n";
    text += fmt::format("{}, in {:.1f} s{}: {}\n", whatWasDrawn(report), report.seconds,
                        onWhat(report.driver), summary(report));
    if (!report.origin.command.empty())
        text += fmt::format("{}, to draw them again: {}\n", report.origin.program, report.origin.command);
    return text;
}

std::string summary(const Report& report) {
    if (!report.compared())
        return "nothing was compared";
    if (!report.agrees())
        return "not all agree";
    int skipped = 0;
    int all = 0;
    int open = 0;
    for (const PairReport& pair : report.pairs) {
        for (const Outcome& outcome : pair.outcomes) {
            skipped += skippedOf(outcome);
            all += skippedOf(outcome) + outcome.all.scenes;
            open += outcome.verdict() == Verdict::TooFewScenes ? 1 : 0;
        }
    }
    std::string text = "all agree";
    if (open > 0)
        text += fmt::format(", except {} with too few scenes to decide",
                            Sentence::plural("{0} feature", "{0} features", open));
    if (skipped > 0)
        text += fmt::format(", {} of {} comparisons skipped", skipped, all);
    return text;
}

std::string listing() {
    std::vector<Cells> lines{{"feature", "scenes", "section", "reference", "shader", "sweeps"}};
    std::vector<const Rule*> used;
    for (const Feature& feature : features()) {
        lines.push_back({std::string(feature.name), std::to_string(feature.scenes),
                         std::string(feature.section), std::string(feature.reference.name),
                         std::string(feature.shader.name), std::string(feature.sweeps)});
        for (const Rule* rule : {&feature.reference, &feature.shader}) {
            if (std::ranges::find(used, rule) == used.end())
                used.push_back(rule);
        }
    }
    std::string text = aligned(lines) +
                       "\n"
                       "Rules: the share of pixels that may differ over all scenes, and in a single scene "
                       "or a case of \"texshot test\", with reasons\n";
    for (const Rule* rule : used)
        text += fmt::format("{}: {}; of a single scene {}. {}\n", rule->name, allowed(*rule),
                            allowedOfScene(*rule), rule->reason);
    text += "\nNot compared\n";
    for (const Skip& skip : skips())
        text += fmt::format("{}: {}\n", skip.name, skip.reason);
    return text;
}

} // namespace texplorer::conform

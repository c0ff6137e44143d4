#include "core/conform/report.h"
#include "core/conform/report_words.h"

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
        const std::string_view verdict = conform::verdict(outcome);
        lines.push_back({std::string(outcome.feature->name), std::to_string(all.scenes),
                         std::to_string(skippedOf(outcome)), std::to_string(all.pixels),
                         percent(all.shareOver()), tolerance ? percent(all.shareUnexplained()) : "–",
                         std::to_string(all.max), verdict == "differ" ? "DIFFER" : std::string(verdict),
                         allowed(*outcome.rule)});
        for (const auto& [skip, count] : outcome.skipped)
            skipped[skip] += count;
    }
    std::string text = std::string(rowOf(pair.pair.subject).name) + " against " +
                       std::string(rowOf(pair.pair.against).name) + "\n" + aligned(lines);
    for (const Skip& skip : skips()) {
        if (const auto found = skipped.find(&skip); found != skipped.end())
            text += "skipped: " + std::string(skip.name) + ", " + std::to_string(found->second) +
                    (found->second == 1 ? " scene: " : " scenes: ") + std::string(skip.reason) + "\n";
    }
    for (const Outcome& outcome : pair.outcomes) {
        if (!outcome.problem.empty())
            text += "differs: " + std::string(outcome.feature->name) + ": " + outcome.problem + "\n";
    }
    return text;
}

} // namespace

std::string asText(const Report& report) {
    std::string text;
    for (const PairReport& pair : report.pairs)
        text += pairText(pair) + "\n";
    text += whatWasDrawn(report) + ", in " + fixed(report.seconds, 1) + " s" + onWhat(report.driver) + ": " +
            summary(report) + "\n";
    if (!report.origin.command.empty())
        text += report.origin.program + ", to draw them again: " + report.origin.command + "\n";
    return text;
}

std::string summary(const Report& report) {
    if (!report.compared())
        return "nothing was compared";
    if (!report.agrees())
        return "not all agree";
    int skipped = 0;
    int all = 0;
    for (const PairReport& pair : report.pairs) {
        for (const Outcome& outcome : pair.outcomes) {
            skipped += skippedOf(outcome);
            all += skippedOf(outcome) + outcome.all.scenes;
        }
    }
    return skipped == 0 ? "all agree"
                        : "all agree, " + std::to_string(skipped) + " of " + std::to_string(all) +
                              " comparisons skipped";
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
    std::string text = aligned(lines) + "\nRules: what of all pixels may differ, and why\n";
    for (const Rule* rule : used)
        text += std::string(rule->name) + ": " + allowed(*rule) + ". " + std::string(rule->reason) + "\n";
    text += "\nNot compared\n";
    for (const Skip& skip : skips())
        text += std::string(skip.name) + ": " + std::string(skip.reason) + "\n";
    return text;
}

} // namespace texplorer::conform

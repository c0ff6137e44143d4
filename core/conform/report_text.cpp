#include "core/conform/report.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <set>

namespace texplorer::conform {

namespace {

std::string fixed(double value, int decimals) {
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
    return text.data();
}

std::string percent(double share) {
    return share == 0 ? "0" : share < 0.00005 ? "<0.01 %" : fixed(share * 100, 2) + " %";
}

/// "0 over 1", "0.5 % over 2, 0.2 % unexplained"
std::string allowed(const Rule& rule) {
    const auto part = [](double share) {
        std::string number = fixed((1 - share) * 100, 2);
        number.erase(number.find_last_not_of('0') + 1);
        if (number.back() == '.')
            number.pop_back();
        return share == 1 ? "0" : number + " %";
    };
    std::string text = part(rule.share) + " over " + std::to_string(rule.bound);
    if (rule.latitude != Latitude::None)
        text += ", " + part(rule.explained) + " unexplained";
    return text;
}

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

int skippedOf(const Outcome& outcome) {
    int sum = 0;
    for (const auto& [skip, count] : outcome.skipped)
        sum += count;
    return sum;
}

std::string pairText(const PairReport& pair) {
    std::vector<Cells> lines{
        {"feature", "scenes", "skipped", "pixels", "over", "unexplained", "worst", "verdict", "allowed"}};
    std::map<const Skip*, int> skipped;
    for (const Outcome& outcome : pair.outcomes) {
        const Tally& all = outcome.all;
        const bool latitude = outcome.rule->latitude != Latitude::None;
        lines.push_back({std::string(outcome.feature->name), std::to_string(all.scenes),
                         std::to_string(skippedOf(outcome)), std::to_string(all.pixels),
                         percent(all.shareOver()), latitude ? percent(all.shareUnexplained()) : "–",
                         std::to_string(all.max),
                         all.scenes == 0    ? "skipped"
                         : outcome.agrees() ? "agree"
                                            : "DIFFER",
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
    const std::string size = std::to_string(extent);
    return text + std::to_string(report.scenes) + " scenes of " + size + " x " + size + " pixels, seed " +
           std::to_string(report.selection.seed) + ", in " + fixed(report.seconds, 1) + " s" +
           (report.driver.name.empty() ? "" : " on " + report.driver.name) +
           (report.driver.settings.empty() ? "" : " with " + report.driver.settings) + ": " +
           summary(report) + "\n";
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

#include "texplorer/conform/report_words.h"

#include "texplorer/base/sentence_format.h"

#include <fmt/core.h>

namespace texplorer::conform {

std::string percent(double share) {
    return share == 0 ? "0" : share < 0.00005 ? "<0.01 %" : fmt::format("{:.2f} %", share * 100);
}

namespace {

/// What may be where so much of all must not: "0", "0.05 %"
std::string restOf(double share) {
    std::string number = fmt::format("{:.2f}", (1 - share) * 100);
    number.erase(number.find_last_not_of('0') + 1);
    if (number.back() == '.')
        number.pop_back();
    return share == 1 ? "0" : number + " %";
}

/// `byChance` is what so many scenes may have, where they have more than is allowed; else empty.
std::string allowedText(const Rule& rule, const std::string& overByChance,
                        const std::string& unexplainedByChance) {
    std::string text = fmt::format("{} over {}{}", restOf(rule.share), rule.bound, overByChance);
    if (rule.tolerance != Tolerance::None)
        text += fmt::format(", {} unexplained{}", restOf(rule.explained), unexplainedByChance);
    return text;
}

} // namespace

std::string allowed(const Rule& rule) {
    return allowedText(rule, {}, {});
}

std::string allowedOfScene(const Rule& rule) {
    std::string text = restOf(rule.explainedScene);
    text += rule.tolerance == Tolerance::None ? fmt::format(" over {}", rule.bound) : " unexplained";
    if (rule.nearScene < 1)
        text += fmt::format(", {} over {}", restOf(rule.nearScene), rule.farBound);
    return text;
}

std::string allowed(const Outcome& outcome) {
    const Tally& all = outcome.all;
    const Rule& rule = *outcome.rule;
    const auto byChance = [&all](double share, double expected, double limit) {
        return share > expected && expected > 0
                   ? fmt::format(" (of {} {})", Sentence::plural("{0} scene", "{0} scenes", all.scenes),
                                 percent(limit))
                   : std::string();
    };
    return allowedText(rule, byChance(all.shareOver(), 1 - rule.share, all.limitOver(rule)),
                       byChance(all.shareUnexplained(), 1 - rule.explained, all.limitUnexplained(rule)));
}

std::string rhoText(const Outcome& outcome) {
    std::string text;
    const auto add = [&text](const std::string& words) { text += (text.empty() ? "" : ", ") + words; };
    for (const auto& [method, count] : outcome.rho)
        add(fmt::format(
            "{} with rho at its {} (--rho {})", Sentence::plural("{0} scene", "{0} scenes", count),
            method == reference::RhoMethod::Lower ? "lower end" : "upper end", rowOf(method).name));
    if (outcome.all.withinRho > 0)
        add(fmt::format("{} with another rho between its ends",
                        Sentence::plural("{0} pixel", "{0} pixels", outcome.all.withinRho)));
    return text.empty() ? text : text + ", which OpenGL 2.1, section 3.8.8, allows";
}

int skippedOf(const Outcome& outcome) {
    int sum = 0;
    for (const auto& [skip, count] : outcome.skipped)
        sum += count;
    return sum;
}

std::array<int, 2> placeOfWorst(const Judgement& judgement) {
    return {judgement.difference.worst.x, extent - 1 - judgement.difference.worst.y};
}

std::string whatWasDrawn(const Report& report) {
    return fmt::format("{0} scenes of {1} × {1} pixels, seed {2}", report.scenes, extent,
                       report.selection.seed);
}

std::string onWhat(const Driver& driver) {
    if (driver.name.empty())
        return {};
    return fmt::format(" on {}{}{}", driver.name, driver.version.empty() ? "" : ", " + driver.version,
                       driver.settings.empty() ? "" : ", with " + driver.settings);
}

} // namespace texplorer::conform

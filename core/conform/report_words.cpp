#include "core/conform/report_words.h"

#include <fmt/core.h>

namespace texplorer::conform {

std::string percent(double share) {
    return share == 0 ? "0" : share < 0.00005 ? "<0.01 %" : fmt::format("{:.2f} %", share * 100);
}

std::string allowed(const Rule& rule) {
    const auto part = [](double share) {
        std::string number = fmt::format("{:.2f}", (1 - share) * 100);
        number.erase(number.find_last_not_of('0') + 1);
        if (number.back() == '.')
            number.pop_back();
        return share == 1 ? "0" : number + " %";
    };
    std::string text = fmt::format("{} over {}", part(rule.share), rule.bound);
    if (rule.tolerance != Tolerance::None)
        text += fmt::format(", {} unexplained", part(rule.explained));
    return text;
}

std::string_view verdict(const Outcome& outcome) {
    return !outcome.agrees() ? "differ" : outcome.all.scenes == 0 ? "skipped" : "agree";
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
    return fmt::format("{0} scenes of {1} x {1} pixels, seed {2}", report.scenes, extent,
                       report.selection.seed);
}

std::string onWhat(const Driver& driver) {
    if (driver.name.empty())
        return {};
    return fmt::format(" on {}{}{}", driver.name, driver.version.empty() ? "" : ", " + driver.version,
                       driver.settings.empty() ? "" : ", with " + driver.settings);
}

} // namespace texplorer::conform

#include "core/conform/report_words.h"

#include <cstdio>

namespace texplorer::conform {

std::string fixed(double value, int decimals) {
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
    return text.data();
}

std::string percent(double share) {
    return share == 0 ? "0" : share < 0.00005 ? "<0.01 %" : fixed(share * 100, 2) + " %";
}

std::string allowed(const Rule& rule) {
    const auto part = [](double share) {
        std::string number = fixed((1 - share) * 100, 2);
        number.erase(number.find_last_not_of('0') + 1);
        if (number.back() == '.')
            number.pop_back();
        return share == 1 ? "0" : number + " %";
    };
    std::string text = part(rule.share) + " over " + std::to_string(rule.bound);
    if (rule.tolerance != Tolerance::None)
        text += ", " + part(rule.explained) + " unexplained";
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
    const std::string size = std::to_string(extent);
    return std::to_string(report.scenes) + " scenes of " + size + " x " + size + " pixels, seed " +
           std::to_string(report.selection.seed);
}

std::string onWhat(const Driver& driver) {
    if (driver.name.empty())
        return {};
    return " on " + driver.name + (driver.version.empty() ? "" : ", " + driver.version) +
           (driver.settings.empty() ? "" : ", with " + driver.settings);
}

} // namespace texplorer::conform

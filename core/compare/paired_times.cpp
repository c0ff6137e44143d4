#include "texplorer/compare/paired_times.h"

#include <algorithm>
#include <cmath>

namespace texplorer {

Quartiles quartilesOf(std::vector<double> values) {
    if (values.empty())
        return {};
    std::ranges::sort(values);
    const auto at = [&values](double share) {
        const double place = share * static_cast<double>(values.size() - 1);
        const auto below = static_cast<std::size_t>(place);
        const double above = values[std::min(below + 1, values.size() - 1)];
        return std::lerp(values[below], above, place - std::floor(place));
    };
    return {at(0.25), at(0.5), at(0.75)};
}

TimeComparison compareTimes(const PairedTimes& times) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < std::min(times.a.size(), times.b.size()); ++i) {
        if (times.a[i] > 0 && times.b[i] > 0) // the clock may not have moved
            ratios.push_back(times.b[i] / times.a[i]);
    }
    TimeComparison result{quartilesOf(times.a), quartilesOf(times.b), quartilesOf(ratios), ratios.size()};
    result.differs = result.pairs >= minTimePairs && (result.ratio.low > 1 || result.ratio.high < 1);
    return result;
}

} // namespace texplorer

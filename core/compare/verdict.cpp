#include "texplorer/compare/verdict.h"

#include "texplorer/base/sentence_format.h"
#include "texplorer/text/percent.h"

#include <fmt/core.h>

namespace texplorer {

namespace {

std::string colorText(const std::array<std::uint8_t, 4>& color, Compared compared) {
    const std::string text = fmt::format("{} {} {}", color[0], color[1], color[2]);
    return compared == Compared::Rgba ? fmt::format("{} {}", text, color[3]) : text;
}

std::string worstText(const Comparison& comparison) {
    const ComparedPixel& worst = comparison.worst;
    const Compared compared = comparison.criterion.compared;
    return fmt::format("the worst, {:.4g}{}, is at {}, {}: {} was expected, {} found", worst.value,
                       factsOf(comparison.criterion.metric).unit, worst.at.x, worst.at.y,
                       colorText(worst.expected, compared), colorText(worst.actual, compared));
}

std::string overText(const Comparison& comparison) {
    const Criterion& criterion = comparison.criterion;
    const MetricRow& facts = factsOf(criterion.metric);
    const std::string which = criterion.metric == Metric::Absolute && criterion.tolerance == 0
                                  ? std::string(comparison.over == 1 ? "differs" : "differ")
                                  : fmt::format("{} {} above {:g}{}", comparison.over == 1 ? "has" : "have",
                                                facts.value, criterion.tolerance, facts.unit);
    return fmt::format("{} of {} ({}) {}", comparison.over,
                       Sentence::plural("{0} pixel", "{0} pixels", comparison.pixels),
                       percentText(comparison.shareOver()), which);
}

/// Nothing where it is the worst pixel alone, whose place is said.
std::string regionsText(const Comparison& comparison) {
    if (comparison.over == 1)
        return {};
    const PixelRect& bounds = comparison.bounds;
    return fmt::format("; {} within {} × {} pixels at {}, {}",
                       Sentence::plural("{0} region", "{0} regions", comparison.regions), bounds.width,
                       bounds.height, bounds.x, bounds.y);
}

std::string scoreText(const Comparison& comparison) {
    if (comparison.criterion.metric == Metric::Absolute)
        return {};
    return fmt::format("; {} {:.6g}", factsOf(comparison.criterion.metric).score, comparison.score);
}

std::string sizesText(const Comparison& comparison) {
    return fmt::format("the sizes differ: {} × {} pixels were expected, {} × {} found",
                       comparison.expectedSize.x, comparison.expectedSize.y, comparison.actualSize.x,
                       comparison.actualSize.y);
}

} // namespace

std::string verdictOn(const Comparison& comparison) {
    if (!comparison.sameSize())
        return sizesText(comparison);
    const Criterion& criterion = comparison.criterion;
    if (comparison.over == 0 && comparison.difference.max == 0)
        return fmt::format("alike: none of {} differs",
                           Sentence::plural("{0} pixel", "{0} pixels", comparison.pixels));
    if (comparison.over == 0)
        return fmt::format("alike within {:g}{}: {}{}", criterion.tolerance, factsOf(criterion.metric).unit,
                           worstText(comparison), scoreText(comparison));
    const std::string all = fmt::format("{}; {}{}{}", overText(comparison), worstText(comparison),
                                        regionsText(comparison), scoreText(comparison));
    if (comparison.alike)
        return fmt::format("alike, since up to {} may differ: {}", percentText(criterion.share), all);
    return all;
}

} // namespace texplorer

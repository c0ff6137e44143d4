#include "texplorer/compare/verdict.h"

#include "texplorer/base/further.h"
#include "texplorer/text/percent.h"

#include <fmt/core.h>

namespace texplorer {

namespace {

std::string colorText(const std::array<std::uint8_t, 4>& color, Compared compared) {
    const std::string text = fmt::format("{} {} {}", color[0], color[1], color[2]);
    return compared == Compared::Rgba ? fmt::format("{} {}", text, color[3]) : text;
}

Sentence worstText(const Comparison& comparison) {
    const ComparedPixel& worst = comparison.worst;
    const Compared compared = comparison.criterion.compared;
    return Sentence("the worst, {0:.4g}{1}, is at {2}, {3}: {4} was expected, {5} found", worst.value,
                    ProperName{factsOf(comparison.criterion.metric).unit}, worst.at.x, worst.at.y,
                    ProperName{colorText(worst.expected, compared)},
                    ProperName{colorText(worst.actual, compared)});
}

Sentence overText(const Comparison& comparison) {
    const Criterion& criterion = comparison.criterion;
    const MetricRow& facts = factsOf(criterion.metric);
    const Sentence pixels = Sentence::plural("{0} pixel", "{0} pixels", comparison.pixels);
    const std::string share = percentText(comparison.shareOver());
    if (criterion.metric == Metric::Absolute && criterion.tolerance == 0)
        return Sentence::plural("{0} of {1} ({2}) differs", "{0} of {1} ({2}) differ", comparison.over,
                                pixels, ProperName{share});
    return Sentence::plural("{0} of {1} ({2}) has {3} above {4:g}{5}",
                            "{0} of {1} ({2}) have {3} above {4:g}{5}", comparison.over, pixels,
                            ProperName{share}, facts.value, criterion.tolerance, ProperName{facts.unit});
}

/// Where they are, if it isn't the worst pixel alone, whose place is said; and the score.
void addMore(std::vector<Sentence>& parts, const Comparison& comparison) {
    const PixelRect& bounds = comparison.bounds;
    if (comparison.over > 1)
        parts.push_back(Sentence("{0} within {1} × {2} pixels at {3}, {4}",
                                 Sentence::plural("{0} region", "{0} regions", comparison.regions),
                                 bounds.width, bounds.height, bounds.x, bounds.y));
    if (comparison.criterion.metric != Metric::Absolute)
        parts.push_back(
            Sentence("{0} {1:.6g}", factsOf(comparison.criterion.metric).score, comparison.score));
}

} // namespace

Sentence verdictOn(const Comparison& comparison) {
    if (!comparison.sameSize())
        return Sentence("the sizes differ: {0} × {1} pixels were expected, {2} × {3} found",
                        comparison.expectedSize.x, comparison.expectedSize.y, comparison.actualSize.x,
                        comparison.actualSize.y);
    const Criterion& criterion = comparison.criterion;
    if (comparison.over == 0 && comparison.difference.max == 0)
        return Sentence("alike: none of {0} differs",
                        Sentence::plural("{0} pixel", "{0} pixels", comparison.pixels));
    std::vector<Sentence> parts;
    if (comparison.over > 0)
        parts.push_back(overText(comparison));
    parts.push_back(worstText(comparison));
    addMore(parts, comparison);
    const Sentence all = Sentence::joined(furtherKey, parts);
    if (comparison.over == 0)
        return Sentence("alike within {0:g}{1}: {2}", criterion.tolerance,
                        ProperName{factsOf(criterion.metric).unit}, all);
    return comparison.alike ? Sentence("alike, since up to {0} may differ: {1}",
                                       ProperName{percentText(criterion.share)}, all)
                            : all;
}

} // namespace texplorer

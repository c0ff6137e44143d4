#include "texplorer/compare/criterion.h"

#include <charconv>
#include <cmath>

namespace texplorer {

namespace {

/// Nothing for what is no number, or more than a number.
std::optional<double> numberOf(std::string_view text) {
    double number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    const bool whole = error == std::errc() && end == text.data() + text.size();
    return whole && std::isfinite(number) ? std::optional(number) : std::nullopt;
}

Result<void> checkRange(std::string_view name, double number, double low, double high) {
    if (number >= low && number <= high) // not of NaN
        return {};
    return fail(ErrorCode::OutOfRange,
                Sentence("expected a number from {0} to {1}, found {2}", low, high, number),
                std::string(name));
}

} // namespace

Criterion criterionOf(Metric metric) {
    Criterion criterion;
    criterion.metric = metric;
    criterion.tolerance = factsOf(metric).tolerance;
    return criterion;
}

Result<void> checkCriterion(const Criterion& criterion) {
    if (Result<void> good =
            checkRange("tolerance", criterion.tolerance, 0, factsOf(criterion.metric).maxValue);
        !good)
        return good;
    if (Result<void> good = checkRange("share", criterion.share, 0, 1); !good)
        return good;
    return checkRange("pixelsPerDegree", criterion.pixelsPerDegree, minPixelsPerDegree, maxPixelsPerDegree);
}

Result<double> parseShare(std::string_view text) {
    std::string_view digits = text;
    const bool percent = digits.ends_with('%');
    if (percent)
        digits.remove_suffix(1);
    while (percent && digits.ends_with(' '))
        digits.remove_suffix(1);
    const std::optional<double> number = numberOf(digits);
    const double share = number.value_or(-1) / (percent ? 100 : 1);
    if (share >= 0 && share <= 1)
        return share;
    return fail(ErrorCode::OutOfRange,
                Sentence("expected a share of the pixels, 0 to 1 or 0% to 100%, found \"{0}\"", text));
}

Result<double> parseTolerance(std::string_view text, Metric metric) {
    const double max = factsOf(metric).maxValue;
    const std::optional<double> number = numberOf(text);
    if (number && *number >= 0 && *number <= max)
        return *number;
    return fail(ErrorCode::OutOfRange,
                Sentence("expected a number from 0 to {0} for the metric {1}, found \"{2}\"", max,
                         rowOf(metric).name, text));
}

} // namespace texplorer

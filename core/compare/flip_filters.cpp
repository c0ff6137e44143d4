#include "texplorer/compare/flip_filters.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace texplorer {

namespace {

/// a * sqrt(pi / b) * exp(-pi^2 x^2 / b), x in degrees: equation 3 and table 1.
struct Sensitivity {
    double a;
    double b;

    [[nodiscard]] double sigma() const { return std::sqrt(b / 2) / std::numbers::pi; }
    [[nodiscard]] double weight() const { return a * std::sqrt(std::numbers::pi / b); }
};

constexpr Sensitivity achromaticCurve{1, 0.0047};
constexpr Sensitivity redGreenCurve{1, 0.0053};
constexpr Sensitivity blueYellowCurves[2]{{34.1, 0.04}, {13.5, 0.025}};
constexpr double featureWidth = 0.082; ///< degrees; its half is the standard deviation

using Numbers = std::vector<double>;

int contrastReach(double pixelsPerDegree) {
    return static_cast<int>(std::ceil(3 * blueYellowCurves[0].sigma() * pixelsPerDegree));
}

/// Not divided by its sum.
Numbers bellCurve(double sigma, int reach) {
    Numbers numbers;
    for (int x = -reach; x <= reach; ++x)
        numbers.push_back(std::exp(-x * x / (2 * sigma * sigma)));
    return numbers;
}

double sumOf(std::span<const double> numbers) {
    double sum = 0;
    for (const double each : numbers)
        sum += each;
    return sum;
}

FilterTaps tapsOf(const Numbers& numbers, double divisor) {
    FilterTaps filter{static_cast<int>(numbers.size() / 2), {}};
    for (const double each : numbers)
        filter.taps.push_back(static_cast<float>(each / divisor));
    return filter;
}

/// A Gaussian that sums up to 1 over the paper's window, without the ends that no float of the sum shows.
FilterTaps gaussian(double sigma, int reach) {
    constexpr double unseen = 1e-9;
    Numbers numbers = bellCurve(sigma, reach);
    const double sum = sumOf(numbers);
    while (numbers.size() > 1 && numbers.front() < unseen * sum) {
        numbers.erase(numbers.begin());
        numbers.pop_back();
    }
    return tapsOf(numbers, sum);
}

/// Positive ones sum up to 1 and negative ones to -1.
FilterTaps balanced(Numbers numbers) {
    double above = 0;
    double below = 0;
    for (const double each : numbers)
        (each > 0 ? above : below) += std::abs(each);
    for (double& each : numbers)
        each /= each > 0 ? above : std::max(below, 1e-300);
    return tapsOf(numbers, 1);
}

} // namespace

ContrastFilters contrastFilters(double pixelsPerDegree) {
    const int reach = contrastReach(pixelsPerDegree);
    const auto filterOf = [&](const Sensitivity& each) {
        return gaussian(each.sigma() * pixelsPerDegree, reach);
    };
    // Of the sum over the whole window, in two dimensions.
    const auto amountOf = [&](const Sensitivity& each) {
        const double across = sumOf(bellCurve(each.sigma() * pixelsPerDegree, reach));
        return each.weight() * across * across;
    };
    const double wide = amountOf(blueYellowCurves[0]);
    const double narrow = amountOf(blueYellowCurves[1]);
    return {filterOf(achromaticCurve),
            filterOf(redGreenCurve),
            {filterOf(blueYellowCurves[0]), filterOf(blueYellowCurves[1])},
            {static_cast<float>(wide / (wide + narrow)), static_cast<float>(narrow / (wide + narrow))}};
}

FeatureFilters featureFilters(double pixelsPerDegree) {
    const double sigma = featureWidth / 2 * pixelsPerDegree;
    const int reach = static_cast<int>(std::ceil(3 * sigma));
    const Numbers bell = bellCurve(sigma, reach);
    Numbers first = bell;
    Numbers second = bell;
    for (int x = -reach; x <= reach; ++x) {
        const auto i = static_cast<std::size_t>(x + reach);
        first[i] *= -x;
        second[i] *= x * x / (sigma * sigma) - 1;
    }
    return {tapsOf(bell, sumOf(bell)), balanced(std::move(first)), balanced(std::move(second))};
}

int flipReach(double pixelsPerDegree) {
    const int features = static_cast<int>(std::ceil(3 * featureWidth / 2 * pixelsPerDegree));
    return std::max(contrastReach(pixelsPerDegree), features);
}

} // namespace texplorer

#include "texplorer/conform/sample_limit.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace texplorer::conform {

namespace {

const double exponent = -std::log(falseAlarms);

double hoeffdingsLimit(double allowed, const Sample& sample) {
    const double p = allowed / sample.max;
    const auto exceeds = [&](double q) {
        return sample.scenes * (q * std::log(q / p) + (1 - q) * std::log((1 - q) / (1 - p))) > exponent;
    };
    double low = p;
    double high = 1;
    for (int i = 0; i < 50; ++i) {
        const double middle = (low + high) / 2;
        (exceeds(middle) ? high : low) = middle;
    }
    return high * sample.max;
}

double efronsLimit(double allowed, const Sample& sample) {
    return areFewScenes(sample.scenes)
               ? std::numeric_limits<double>::infinity()
               : allowed + sample.deviation * std::sqrt(2 * exponent / (sample.scenes - 2 * exponent));
}

} // namespace

double sampleLimit(double allowed, const Sample& sample) {
    return allowed == 0 ? 0 : std::min(hoeffdingsLimit(allowed, sample), efronsLimit(allowed, sample));
}

bool areFewScenes(int scenes) {
    return scenes <= 2 * exponent;
}

} // namespace texplorer::conform

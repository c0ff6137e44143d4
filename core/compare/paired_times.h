#pragma once

#include <cstddef>
#include <vector>

namespace texplorer {

/// Times of two variants, A and B, in seconds. They are measured in turns, so that what disturbs the one
/// disturbs the other as well; a[i] and b[i] are a pair.
struct PairedTimes {
    std::vector<double> a;
    std::vector<double> b;

    bool operator==(const PairedTimes&) const = default;
};

/// The middle half of some numbers is between `low` and `high`.
struct Quartiles {
    double low = 0;
    double median = 0;
    double high = 0;

    bool operator==(const Quartiles&) const = default;
};

/// Interpolated between neighbours, as by percentile() of NumPy. Of no numbers: zeros.
[[nodiscard]] Quartiles quartilesOf(std::vector<double> values);

/// With equal variants, B is slower in half of the pairs. That it is in three quarters of 20 pairs, or faster
/// in as many, is chance in 4 of 100 measurements (sign test); with fewer pairs it is more often.
inline constexpr std::size_t minTimePairs = 20;

struct TimeComparison {
    Quartiles a;
    Quartiles b;
    Quartiles ratio;       ///< of B's time to A's, in each pair
    std::size_t pairs = 0; ///< that have both times, above 0
    bool differs = false;  ///< there are enough pairs, and 1 is outside of the ratio's quartiles
};

[[nodiscard]] TimeComparison compareTimes(const PairedTimes& times);

} // namespace texplorer

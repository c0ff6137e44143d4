#pragma once

// The metrics that pictures are compared by.

#include "texplorer/gl/enum_row.h"

namespace texplorer {

/// Each metric gives every pixel a value, 0 if the pictures are alike there, and the whole comparison a
/// score.
enum class Metric : std::uint8_t { Absolute, Ssim, Flip };

inline constexpr std::array metricNameRows{
    row(Metric::Absolute, "absolute", "Absolute difference",
        "The difference of a pixel's worst component from the expected one, in 255ths."),
    row(Metric::Ssim, "ssim", "Structural similarity",
        "1 - SSIM: the difference of brightness, contrast and structure around a pixel."),
    row(Metric::Flip, "flip", "FLIP",
        "The visible difference when flipping between the two pictures at a usual distance from the screen."),
};

template<>
struct EnumTable<Metric> {
    static constexpr std::span<const EnumRow> rows = metricNameRows;
};

static_assert(metricNameRows.size() == 3);

/// The properties of a metric's numbers.
struct MetricRow {
    Metric metric;
    std::string_view citation; ///< its definition; empty if it needs no source
    std::string_view value;    ///< a pixel's value, for a sentence: "a difference"
    std::string_view score;    ///< the name of the score: "mean SSIM"
    std::string_view unit;     ///< written after each number: "/255"
    double alikeScore;         ///< the score of two equal pictures
    double maxValue;           ///< the largest possible value of a pixel; values and tolerances begin at 0
    double tolerance;          ///< the default
    std::string_view choice;   ///< the reason for that default, as a sentence
};

inline constexpr std::array metricRows{
    MetricRow{Metric::Absolute, "", "a difference", "mean difference", "/255", 0, 255, 0,
              "0: every difference counts by default."},
    MetricRow{Metric::Ssim,
              "Z. Wang, A. C. Bovik, H. R. Sheikh, E. P. Simoncelli: Image Quality Assessment: From Error "
              "Visibility to Structural Similarity. IEEE Transactions on Image Processing 13(4), 2004",
              "1 - SSIM", "mean SSIM", "", 1, 2, 0.05,
              "0.05: noise of 2/255 in an even grey stays below it."},
    MetricRow{
        Metric::Flip,
        "P. Andersson, J. Nilsson, T. Akenine-Möller, M. Oskarsson, K. Åström, M. D. Fairchild: FLIP: A "
        "Difference Evaluator for Alternating Images. Proceedings of the ACM on Computer Graphics and "
        "Interactive Techniques 3(2), 2020",
        "a FLIP error", "mean FLIP error", "", 0, 1, 0.1,
        "0.1: a step of 2 in CIE lightness, which is just visible, stays below it."},
};

static_assert(metricRows.size() == metricNameRows.size());

/// The rows are in the order of the enumerators.
[[nodiscard]] constexpr const MetricRow& factsOf(Metric metric) {
    return metricRows[static_cast<std::size_t>(metric)];
}

} // namespace texplorer

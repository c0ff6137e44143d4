#pragma once

// What "alike" is measured in.

#include "core/gl/enum_row.h"

namespace texplorer {

/// Each metric gives every pixel a value, 0 where the pictures are alike there, and the whole comparison a
/// score.
enum class Metric : std::uint8_t { Absolute, Ssim, Flip };

inline constexpr std::array metricNameRows{
    row(Metric::Absolute, "absolute", "Absolute difference",
        "How far the worst component of a pixel is from what was expected, in 255ths."),
    row(Metric::Ssim, "ssim", "Structural similarity",
        "1 - SSIM: whether brightness, contrast and structure around a pixel are alike."),
    row(Metric::Flip, "flip", "FLIP",
        "What one sees who flips between the two pictures at a usual distance from the screen."),
};

template<>
struct EnumTable<Metric> {
    static constexpr std::span<const EnumRow> rows = metricNameRows;
};

static_assert(metricNameRows.size() == 3);

/// What a metric's numbers are.
struct MetricRow {
    Metric metric;
    std::string_view citation; ///< where it is defined; empty where it needs no source
    std::string_view value;    ///< what a pixel has, for a sentence: "a difference"
    std::string_view score;    ///< what the score is: "mean SSIM"
    std::string_view unit;     ///< behind each of its numbers: "/255"
    double alikeScore;         ///< the score of two equal pictures
    double largest;            ///< what a pixel's value can be at most; values and tolerances begin at 0
    double tolerance;          ///< what a pixel may have unless one says otherwise
    std::string_view choice;   ///< why that tolerance, as a sentence
};

inline constexpr std::array metricRows{
    MetricRow{Metric::Absolute, "", "a difference", "mean difference", "/255", 0, 255, 0,
              "0: what nobody asked to be tolerated is a difference."},
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
        "0.1: a step of 2 in CIE lightness, which one just sees, stays below it."},
};

static_assert(metricRows.size() == metricNameRows.size());

/// The rows stand in the order of the enumerators.
[[nodiscard]] constexpr const MetricRow& factsOf(Metric metric) {
    return metricRows[static_cast<std::size_t>(metric)];
}

} // namespace texplorer

#include "texplorer/compare/criterion.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

namespace texplorer::criterion_test {
namespace {

using testing::HasSubstr;

TEST(MetricRows, StandInTheOrderOfTheMetrics) {
    for (const EnumRow& row : EnumTable<Metric>::rows) {
        const auto metric = static_cast<Metric>(row.value);
        EXPECT_EQ(factsOf(metric).metric, metric);
        EXPECT_FALSE(row.name.empty() || row.label.empty() || row.help.empty()) << row.name;
        EXPECT_TRUE(checkCriterion(criterionOf(metric))) << row.name;
        EXPECT_EQ(factsOf(metric).citation.empty(), metric == Metric::Absolute);
    }
    EXPECT_EQ(criterionOf(Metric::Absolute), Criterion{});
}

TEST(Criterion, ShareIsANumberOrPercent) {
    EXPECT_DOUBLE_EQ(parseShare("0.25").value(), 0.25);
    EXPECT_DOUBLE_EQ(parseShare("25%").value(), 0.25);
    EXPECT_DOUBLE_EQ(parseShare("0.1 %").value(), 0.001);
    EXPECT_EQ(parseShare("1").value(), 1);
    EXPECT_EQ(parseShare("100%").value(), 1);
    EXPECT_EQ(parseShare("1e-3").value(), 0.001);
    for (const char* wrong : {"", "%", "2", "-1", "101%", "-0.1%", "nan", "inf", "1e999", "0.5x", "1 2",
                              "0x1", " 0.1", "0,1", "-nan", "5%%"}) {
        const Result<double> share = parseShare(wrong);
        ASSERT_FALSE(share) << wrong;
        EXPECT_EQ(share.error().code, ErrorCode::OutOfRange);
        EXPECT_THAT(share.error().message, HasSubstr(std::string("found \"") + wrong + "\""));
    }
}

TEST(Criterion, ToleranceIsOneOfTheMetric) {
    EXPECT_EQ(parseTolerance("255", Metric::Absolute).value(), 255);
    EXPECT_EQ(parseTolerance("2", Metric::Ssim).value(), 2);
    EXPECT_EQ(parseTolerance("1", Metric::Flip).value(), 1);
    EXPECT_EQ(parseTolerance("0.5", Metric::Absolute).value(), 0.5);
    EXPECT_FALSE(parseTolerance("256", Metric::Absolute));
    EXPECT_FALSE(parseTolerance("2.1", Metric::Ssim));
    EXPECT_EQ(parseTolerance("1.01", Metric::Flip).error().message,
              "expected a number from 0 to 1 for the metric flip, found \"1.01\"");
    for (const char* wrong : {"nan", "-1", "1e999", "", "5%", "1/255", "+1", "inf"})
        EXPECT_FALSE(parseTolerance(wrong, Metric::Absolute)) << wrong;
}

TEST(Criterion, IsCheckedWhereNoTextWas) {
    Criterion criterion;
    for (const double wrong : {-0.1, 255.5, std::nan(""), std::numeric_limits<double>::infinity()}) {
        criterion.tolerance = wrong;
        EXPECT_EQ(checkCriterion(criterion).error().where, "tolerance");
    }
    criterion = {};
    for (const double wrong : {-0.1, 1.5, std::nan("")}) {
        criterion.share = wrong;
        EXPECT_EQ(checkCriterion(criterion).error().where, "share");
    }
    criterion = {};
    for (const double wrong : {0.0, 513.0, std::nan("")}) {
        criterion.pixelsPerDegree = wrong;
        EXPECT_EQ(checkCriterion(criterion).error().where, "pixelsPerDegree");
    }
}

} // namespace
} // namespace texplorer::criterion_test

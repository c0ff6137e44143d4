#include "texplorer/text/percent.h"

#include <gtest/gtest.h>

namespace texplorer {
namespace {

TEST(PercentText, HasThreeDigits) {
    EXPECT_EQ(percentText(0), "0 %");
    EXPECT_EQ(percentText(0.5), "50 %");
    EXPECT_EQ(percentText(0.12345), "12.3 %");
    EXPECT_EQ(percentText(1), "100 %");
}

TEST(PercentText, SaysAHundredOfAllAlone) {
    EXPECT_EQ(percentText(0.9995), "99.95 %");
    EXPECT_EQ(percentText(9997.0 / 10000), "99.97 %");
    EXPECT_EQ(percentText(999999.0 / 1000000), "99.9999 %");
    EXPECT_EQ(percentText((268435456.0 - 1) / 268435456), "99.9999996 %");
}

TEST(PercentText, SaysNoneOfNothingAloneAndWritesNoExponent) {
    EXPECT_EQ(percentText(6.25e-8), "0.00000625 %");
    EXPECT_EQ(percentText(1.0 / 268435456), "0.000000373 %");
}

} // namespace
} // namespace texplorer

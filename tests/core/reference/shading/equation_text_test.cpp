// Equations with numbers instead of symbols, and their results.

#include "texplorer/reference/shading/equation_text.h"

#include <gtest/gtest.h>

namespace texplorer::reference::equation_text_test {
namespace {

TEST(EquationText, SaysTheClampOnlyWhereItTakesEffect) {
    EXPECT_EQ(withResult("0.5 * 0.4", 0.2F), "0.5 * 0.4 = 0.2");
    EXPECT_EQ(withResult("0.5 + 0.5", 1), "0.5 + 0.5 = 1");
    EXPECT_EQ(withResult("0.6 + 0.8", 1.4F), "0.6 + 0.8 = 1.4, clamped to 1");
    EXPECT_EQ(withResult("0.25 - 0.5", -0.25F), "0.25 - 0.5 = -0.25, clamped to 0");
}

TEST(EquationText, ReplacesSymbolsThatStandAlone) {
    EXPECT_EQ(inNumbers("Cp * (1 - Cs) + Cs0", {{"Cp", 0.5F}, {"Cs", 0.25F}}), "0.5 * (1 - 0.25) + Cs0");
}

TEST(EquationText, IsWrittenWithTheSignsOfHand) {
    EXPECT_EQ(withHandSigns("Cv = Cp * (1 - Cs) + Cc * Cs"), "Cv = Cp × (1 − Cs) + Cc × Cs");
}

} // namespace
} // namespace texplorer::reference::equation_text_test

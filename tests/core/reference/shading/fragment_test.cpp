#include "texplorer/reference/shading/fragment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace texplorer::reference::fragment_test {
namespace {

// OpenGL 2.1, section 4.1.4: the reference is converted to fixed point, and alpha is rounded for the test,
// too.
struct AlphaCase {
    const char* name;
    CompareFunc function;
    float alpha;
    float reference;
    bool passes;
};
class AlphaTest : public testing::TestWithParam<AlphaCase> {};

TEST_P(AlphaTest, ComparesFixedPointNumbers) {
    EXPECT_EQ(passes(GetParam().function, GetParam().alpha, GetParam().reference), GetParam().passes);
}

INSTANTIATE_TEST_SUITE_P(
    All, AlphaTest,
    testing::Values(AlphaCase{"HalfIs128", CompareFunc::Equal, 128.0F / 255, 0.5F, true},
                    AlphaCase{"HalfIsNot127", CompareFunc::Less, 127.0F / 255, 0.5F, true},
                    AlphaCase{"WithinAStepIsEqual", CompareFunc::Equal, 100.2F / 255, 99.8F / 255, true},
                    AlphaCase{"WithinAStepIsNotLess", CompareFunc::Less, 99.8F / 255, 100.2F / 255, false},
                    AlphaCase{"OneIsAll", CompareFunc::GreaterEqual, 1, 1, true},
                    AlphaCase{"AlmostOneIsOne", CompareFunc::GreaterEqual, 254.6F / 255, 1, true},
                    AlphaCase{"AboveOneIsOne", CompareFunc::Equal, 1, 3, true},
                    AlphaCase{"BelowZeroIsZero", CompareFunc::Equal, -1, 0, true},
                    AlphaCase{"NotANumberIsZero", CompareFunc::LessEqual, NAN, 0, true}),
    [](const auto& test) { return std::string(test.param.name); });

} // namespace
} // namespace texplorer::reference::fragment_test

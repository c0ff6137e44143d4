#include "texplorer/base/bytes.h"
#include "texplorer/codec/common/swizzle.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace texplorer::swizzle_test {
namespace {

struct Swap {
    const char* name;
    std::size_t pixelBytes;
    void (*fast)(const std::byte*, std::byte*, std::size_t);
    void (*scalar)(const std::byte*, std::byte*, std::size_t);
};

class Swizzle : public testing::TestWithParam<Swap> {};

TEST_P(Swizzle, AgreesWithItsScalarTwinForEveryLengthAndStaysInside) {
    const Swap& swap = GetParam();
    for (std::size_t count = 0; count < 70; ++count) {
        Bytes from(swap.pixelBytes * count);
        for (std::size_t i = 0; i < from.size(); ++i)
            from[i] = static_cast<std::byte>(i * 37 + 11);
        Bytes expected(from.size());
        swap.scalar(from.data(), expected.data(), count);
        for (std::size_t i = 0; i < from.size(); ++i) {
            const std::size_t c = i % swap.pixelBytes;
            ASSERT_EQ(expected[i], from[c < 3 ? i - c + 2 - c : i]);
        }

        Bytes to(from.size() + 16, std::byte{0x5A});
        swap.fast(from.data(), to.data(), count);
        EXPECT_TRUE(std::equal(expected.begin(), expected.end(), to.begin())) << count << " pixels";
        for (std::size_t i = from.size(); i < to.size(); ++i)
            ASSERT_EQ(to[i], std::byte{0x5A}) << "written after the end of " << count << " pixels";
    }
}

INSTANTIATE_TEST_SUITE_P(All, Swizzle,
                         testing::Values(Swap{"ThreeBytes", 3, swapRedBlue, swapRedBlueScalar},
                                         Swap{"FourBytes", 4, swapRedBlueAlpha, swapRedBlueAlphaScalar}),
                         [](const auto& test) { return std::string(test.param.name); });

} // namespace
} // namespace texplorer::swizzle_test

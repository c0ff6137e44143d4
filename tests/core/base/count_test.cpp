#include "texplorer/base/count.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>

namespace texplorer::count_test {
namespace {

TEST(Count, OneAloneHasNoS) {
    EXPECT_EQ(countOf(0, "byte"), "0 bytes");
    EXPECT_EQ(countOf(1, "byte"), "1 byte");
    EXPECT_EQ(countOf(2U, "level"), "2 levels");
    EXPECT_EQ(countOf(std::uint8_t{65}, "bit"), "65 bits");
    EXPECT_EQ(countOf(std::numeric_limits<std::uint64_t>::max(), "texel"), "18446744073709551615 texels");
}

} // namespace
} // namespace texplorer::count_test

#include "texplorer/codec/png/png_chunks.h"

#include <gtest/gtest.h>

namespace texplorer::png_chunks_test {
namespace {

struct Filtered {
    const char* name;
    PngHeader header;
    std::uint64_t bytes; // by hand: each row of each pass, with its filter byte
};

class FilteredBytes : public testing::TestWithParam<Filtered> {};

TEST_P(FilteredBytes, CountEveryRowOfEveryPass) {
    EXPECT_EQ(GetParam().header.filteredBytes(), GetParam().bytes);
}

// Adam7 of 5 x 5: passes of 1x1, 1x1, 2x1, 1x2, 3x1, 2x3 and 5x2 pixels; of 1 x 1 only the first has any.
INSTANTIATE_TEST_SUITE_P(All, FilteredBytes,
                         testing::Values(Filtered{"Rgb", {3, 2, 8, 2}, 2 * 10},
                                         Filtered{"Bits", {9, 4, 1, 0}, 4 * 3},
                                         Filtered{"Rgba16", {2, 2, 16, 6}, 2 * 17},
                                         Filtered{"Adam7", {5, 5, 8, 0, 0, 0, 1}, 25 + 11},
                                         Filtered{"Adam7OnePixel", {1, 1, 8, 4, 0, 0, 1}, 3}),
                         [](const auto& test) { return std::string(test.param.name); });

} // namespace
} // namespace texplorer::png_chunks_test

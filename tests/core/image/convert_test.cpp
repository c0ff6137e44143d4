#include "texplorer/image/convert.h"

#include <gtest/gtest.h>

namespace texplorer::convert_test {
namespace {

Bytes bytes(std::initializer_list<int> values) {
    Bytes result;
    for (const int value : values)
        result.push_back(static_cast<std::byte>(value));
    return result;
}

TEST(WithoutAlpha, KeepsTheColoursAndTheOrder) {
    const Image image{PixelFormat::Rgba8, 2, 2, 1,
                      bytes({1, 2, 3, 0, 4, 5, 6, 255, 7, 8, 9, 128, 10, 11, 12, 1})};
    EXPECT_EQ(withoutAlpha(image),
              (Image{PixelFormat::Rgb8, 2, 2, 1, bytes({1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12})}));
}

TEST(WithoutAlpha, LeavesOtherFormatsAlone) {
    const Image grey{PixelFormat::LuminanceAlpha8, 1, 2, 1, bytes({1, 2, 3, 4})};
    EXPECT_EQ(withoutAlpha(grey), grey);
}

} // namespace
} // namespace texplorer::convert_test

#include "texplorer/image/mean_color.h"

#include <gtest/gtest.h>

#include <array>

namespace texplorer::mean_color_test {
namespace {

TEST(MeanColor, IsThatOfEveryComponent) {
    Image image = Image::uninitialised(PixelFormat::Rgba8, 2, 1);
    const std::array bytes{0, 51, 102, 255, 255, 153, 102, 0};
    for (std::size_t i = 0; i < bytes.size(); ++i)
        image.pixels[i] = static_cast<std::byte>(bytes.at(i));
    const glm::vec4 mean = meanColor(image); // (0 + 255) / 2 of 255, (51 + 153) / 2 of 255 …
    EXPECT_FLOAT_EQ(mean.r, 0.5F);
    EXPECT_FLOAT_EQ(mean.g, 0.4F);
    EXPECT_FLOAT_EQ(mean.b, 0.4F);
    EXPECT_FLOAT_EQ(mean.a, 0.5F);
    EXPECT_EQ(meanColor({}), glm::vec4(0));
}

} // namespace
} // namespace texplorer::mean_color_test

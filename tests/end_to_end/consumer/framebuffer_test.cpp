// A test of another project: is its framebuffer the golden? GOLDENS is the folder of it.

#include <gtest/gtest.h>

#include <texplorer/golden/gtest.h>
#include <vector>

namespace {

constexpr int width = 5;
constexpr int height = 4;

/// As glReadPixels gives it: the bottom row first. Red grows to the right, green upwards.
std::vector<std::byte> framebuffer() {
    std::vector<std::byte> rgba;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (const int component : {x * 50, y * 60, 7, 255})
                rgba.push_back(static_cast<std::byte>(component));
    return rgba;
}

TEST(Framebuffer, IsTheGolden) {
    EXPECT_TRUE(texplorer::matchesGolden(width, height, framebuffer(), GOLDENS "/framebuffer.png"));
}

TEST(Framebuffer, IsNotUpsideDown) {
    texplorer::GoldenOptions options{.failures = "upside_down", .rowsTopFirst = true};
    options.criterion.tolerance = 59;
    EXPECT_FALSE(texplorer::matchesGolden(width, height, framebuffer(), GOLDENS "/framebuffer.png", options));
}

} // namespace

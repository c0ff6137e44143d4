#include "texplorer/compare/heat_map.h"
#include "texplorer/sheet/changes.h"

#include <gtest/gtest.h>

namespace texplorer::picture_changes_test {
namespace {

Image pixels(std::initializer_list<int> greys, int alpha) {
    Image image = Image::uninitialised(PixelFormat::Rgba8, static_cast<int>(greys.size()), 1);
    int x = 0;
    for (const int grey : greys) {
        const std::span<std::byte> pixel = image.at(x++, 0);
        for (std::size_t i = 0; i < 3; ++i)
            pixel[i] = std::byte(grey);
        pixel[3] = std::byte(alpha);
    }
    return image;
}

TEST(PictureChanges, AreWhatOneSees) {
    const auto changes = sheet::changesAgainst(pixels({0, 10, 20, 255}, 255), pixels({0, 11, 20, 0}, 7));
    ASSERT_TRUE(changes);
    EXPECT_EQ(changes->pixels, 2U) << "alpha isn't seen";
    const auto color = [&](int x) {
        std::array<std::uint8_t, 4> found{};
        for (std::size_t i = 0; i < 4; ++i)
            found[i] = std::to_integer<std::uint8_t>(changes->map.at(x, 0)[i]);
        return found;
    };
    using Color = std::array<std::uint8_t, 4>;
    EXPECT_EQ(color(0), (Color{0, 0, 0, 255}));
    EXPECT_EQ(color(1), (Color{112, 32, 130, 255})) << "the least that differs is no longer dark blue";
    EXPECT_EQ(color(2), color(0));
    EXPECT_EQ(color(3), (Color{255, 255, 226, 255}));
}

TEST(PictureChanges, OfTwoExtentsAreNone) {
    const auto changes = sheet::changesAgainst(pixels({0, 1}, 255), pixels({0}, 255));
    ASSERT_FALSE(changes);
    EXPECT_EQ(changes.error().code, ErrorCode::OutOfRange);
}

} // namespace
} // namespace texplorer::picture_changes_test

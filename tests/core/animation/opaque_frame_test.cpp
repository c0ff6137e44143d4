#include "texplorer/animation/opaque_frame.h"

#include <gtest/gtest.h>

namespace texplorer::animation::opaque_frame_test {
namespace {

TEST(OpaqueFrame, HasTheTopRowFirstAndNoAlpha) {
    Image image{PixelFormat::Rgba8, 1, 2, 1, {}};
    for (const int byte : {1, 2, 3, 0, 4, 5, 6, 128})
        image.pixels.push_back(static_cast<std::byte>(byte));
    EXPECT_EQ(opaqueFrame(image), (OpaqueFrame{1, 2, {0xFF040506, 0xFF010203}}));
    Image plain{PixelFormat::Rgb8, 2, 1, 1, {}};
    for (const int byte : {255, 0, 1, 2, 3, 4})
        plain.pixels.push_back(static_cast<std::byte>(byte));
    EXPECT_EQ(opaqueFrame(plain), (OpaqueFrame{2, 1, {0xFFFF0001, 0xFF020304}}));
}

TEST(ChangedRect, HoldsEveryPixelThatDiffersAndNoMore) {
    const OpaqueFrame before{5, 4, std::vector<std::uint32_t>(20, 7)};
    EXPECT_EQ(changedRect(before, before), std::nullopt);
    OpaqueFrame now = before;
    now.pixels[1 * 5 + 3] = 8;
    EXPECT_EQ(changedRect(before, now), (FrameRect{3, 1, 1, 1}));
    now.pixels[3 * 5 + 1] = 8;
    EXPECT_EQ(changedRect(before, now), (FrameRect{1, 1, 3, 3}));
    now.pixels[0] = now.pixels[19] = 8;
    EXPECT_EQ(changedRect(before, now), (FrameRect{0, 0, 5, 4}));
}

} // namespace
} // namespace texplorer::animation::opaque_frame_test

#include "texplorer/texture/target_image.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>

namespace texplorer::target_image_test {
namespace {

/// One byte a pixel, in memory order: row by row from the bottom, slice by slice.
Image letters(int width, int height, int depth, std::string_view text) {
    Image image = Image::uninitialised(PixelFormat::Luminance8, width, height, depth);
    const ByteView bytes = std::as_bytes(std::span(text));
    std::copy(bytes.begin(), bytes.end(), image.pixels.begin());
    return image;
}

struct Case {
    const char* name;
    Target target;
    Image image;
    Image expected;
};

class TargetImage : public testing::TestWithParam<Case> {};

TEST_P(TargetImage, TakesThisPart) {
    EXPECT_EQ(imageForTarget(GetParam().image, GetParam().target), GetParam().expected);
}

INSTANTIATE_TEST_SUITE_P(
    All, TargetImage,
    testing::Values(
        Case{"LineAs1D", Target::Texture1D, letters(3, 1, 1, "abc"), letters(3, 1, 1, "abc")},
        Case{"ThreeRowsAs1D", Target::Texture1D, letters(2, 3, 1, "abcdef"), letters(2, 1, 1, "cd")},
        Case{"FourRowsAs1D", Target::Texture1D, letters(1, 4, 1, "abcd"), letters(1, 1, 1, "c")},
        Case{"VolumeAs1D", Target::Texture1D, letters(1, 2, 3, "abcdef"), letters(1, 1, 1, "d")},
        Case{"PictureAs2D", Target::Texture2D, letters(2, 2, 1, "abcd"), letters(2, 2, 1, "abcd")},
        Case{"VolumeAs2D", Target::Texture2D, letters(1, 2, 3, "abcdef"), letters(1, 2, 1, "cd")},
        Case{"TwoSlicesAs2D", Target::Texture2D, letters(2, 1, 2, "abcd"), letters(2, 1, 1, "cd")},
        Case{"PictureAs3D", Target::Texture3D, letters(2, 2, 1, "abcd"), letters(2, 2, 1, "abcd")},
        Case{"VolumeAs3D", Target::Texture3D, letters(1, 2, 2, "abcd"), letters(1, 2, 2, "abcd")},
        Case{"Nothing", Target::Texture2D, Image{}, Image{}}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(TargetImagePixels, OfSeveralBytesStayWhole) {
    Image image = Image::uninitialised(PixelFormat::Rgb8, 1, 3);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        image.pixels[i] = static_cast<std::byte>(i);
    const Image row = imageForTarget(image, Target::Texture1D);
    EXPECT_EQ(row.pixels, (Bytes{std::byte{3}, std::byte{4}, std::byte{5}}));
}

} // namespace
} // namespace texplorer::target_image_test

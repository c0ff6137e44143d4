// Pictures whose texels are letters, cut into faces.

#include "texplorer/image/cube_faces.h"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <string_view>

namespace texplorer::cube_faces_test {
namespace {

/// One byte a texel, the first row first.
Image letters(int width, int height, std::string_view texels) {
    Image image = Image::uninitialised(PixelFormat::Luminance8, width, height);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        image.pixels[i] = static_cast<std::byte>(texels[i]);
    return image;
}

std::string textOf(const Image& image) {
    std::string text;
    for (const std::byte each : image.pixels)
        text += static_cast<char>(each);
    return text;
}

struct Case {
    const char* name;
    Image picture;
    std::array<const char*, 6> faces; ///< +x, -x, +y, -y, +z, -z
};
class CubeFaces : public testing::TestWithParam<Case> {};

TEST_P(CubeFaces, AreCutOut) {
    for (int face = 0; face < cubeFaceCount; ++face)
        EXPECT_EQ(textOf(cubeFace(GetParam().picture, face)),
                  GetParam().faces[static_cast<std::size_t>(face)])
            << face;
}

INSTANTIATE_TEST_SUITE_P(
    All, CubeFaces,
    testing::Values(Case{"RowStrip",
                         letters(12, 2,
                                 "xX__yY__zZ__"
                                 "12__34__56__"),
                         {"xX12", "____", "yY34", "____", "zZ56", "____"}},
                    Case{"ColumnStrip", letters(1, 6, "XxYyZz"), {"X", "x", "Y", "y", "Z", "z"}},
                    Case{"RowCross",
                         letters(8, 6,
                                 "..YU...."
                                 "..yu...."
                                 "LMZWXVBC"
                                 "lmzwxvbc"
                                 "..ND...."
                                 "..nd...."),
                         {"XVxv", "LMlm", "YUyu", "NDnd", "ZWzw", "BCbc"}},
                    // -z hangs below -y, so that it stands on its head.
                    Case{"ColumnCross",
                         letters(6, 8,
                                 "..YU.."
                                 "..yu.."
                                 "LMZWXV"
                                 "lmzwxv"
                                 "..ND.."
                                 "..nd.."
                                 "..cb.."
                                 "..CB.."),
                         {"XVxv", "LMlm", "YUyu", "NDnd", "ZWzw", "BCbc"}},
                    Case{"AnyOther", letters(2, 2, "abcd"), {"abcd", "abcd", "abcd", "abcd", "abcd", "abcd"}},
                    Case{
                        "NotSquareEither", letters(3, 1, "abc"), {"abc", "abc", "abc", "abc", "abc", "abc"}}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(CubeCross, IsWhatCutsIntoTheSameFaces) {
    std::array<Image, cubeFaceCount> faces;
    for (std::size_t i = 0; i < faces.size(); ++i)
        faces[i] = letters(2, 2, std::string(1, static_cast<char>('a' + i)) + "123");
    const Image cross = cubeCross(faces);
    EXPECT_EQ(cross.width, 8);
    EXPECT_EQ(cross.height, 6);
    for (std::size_t i = 0; i < faces.size(); ++i)
        EXPECT_EQ(cubeFace(cross, static_cast<int>(i)), faces[i]);
}

TEST(CubeFaceExtents, AreThoseOfOneFace) {
    EXPECT_EQ(cubeFaceExtents(384, 64).width, 64);
    EXPECT_EQ(cubeFaceExtents(64, 384).height, 64);
    EXPECT_EQ(cubeFaceExtents(512, 384).width, 128);
    EXPECT_EQ(cubeFaceExtents(384, 512).width, 128);
    EXPECT_EQ(cubeFaceExtents(200, 100).width, 200);
    EXPECT_EQ(cubeFaceExtents(200, 100).height, 100);
}

} // namespace
} // namespace texplorer::cube_faces_test

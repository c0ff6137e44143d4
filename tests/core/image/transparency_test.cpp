#include "texplorer/image/transparency.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

namespace texplorer::transparency_test {
namespace {

Image imageOf(PixelFormat format, std::initializer_list<int> bytes) {
    Image image{format, static_cast<int>(bytes.size()) / bytesPerPixel(format), 1, 1, {}};
    for (const int byte : bytes)
        image.pixels.push_back(static_cast<std::byte>(byte));
    return image;
}

struct Formula {
    const char* name;
    Transparency choice;
    std::vector<int> alphas; // of black, (1, 2, 3), (10, 20, 30), (16, 0, 0), (100, 100, 100), white
};

class Formulas : public testing::TestWithParam<Formula> {};

// The numbers were worked out by hand from the formulas next to the constants in glpng.h.
TEST_P(Formulas, GiveTheAlphaThatGlpngGives) {
    const Image colors =
        imageOf(PixelFormat::Rgb8, {0, 0, 0, 1, 2, 3, 10, 20, 30, 16, 0, 0, 100, 100, 100, 255, 255, 255});
    const Image result = applyTransparency(colors, GetParam().choice);
    ASSERT_EQ(result.format, PixelFormat::Rgba8);
    ASSERT_EQ(result.pixels.size(), 24U);
    for (int x = 0; x < 6; ++x) {
        EXPECT_TRUE(std::ranges::equal(result.at(x, 0).first(3), colors.at(x, 0))) << x;
        EXPECT_EQ(std::to_integer<int>(result.at(x, 0)[3]), GetParam().alphas[static_cast<std::size_t>(x)])
            << x;
    }
}

using enum Transparency;

INSTANTIATE_TEST_SUITE_P(All, Formulas,
                         testing::Values(Formula{"Alpha", Alpha, {255, 255, 255, 255, 255, 255}},
                                         Formula{"StencilBlack", Stencil, {0, 255, 255, 255, 255, 255}},
                                         Formula{"Blend1", Blend1, {0, 6, 60, 16, 255, 255}},
                                         Formula{"Blend2", Blend2, {0, 3, 30, 8, 150, 255}},
                                         Formula{"Blend3", Blend3, {0, 2, 20, 5, 100, 255}},
                                         Formula{"Blend4", Blend4, {0, 14, 255, 255, 255, 255}},
                                         Formula{"Blend5", Blend5, {0, 7, 255, 128, 255, 255}},
                                         Formula{"Blend6", Blend6, {0, 4, 255, 85, 255, 255}},
                                         Formula{"Blend7", Blend7, {0, 3, 255, 64, 255, 255}},
                                         Formula{"Blend8", Blend8, {0, 3, 37, 16, 173, 255}}),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(TransparencyChoices, AreRowsWithNamesOfTheirOwn) {
    std::set<std::string_view> names;
    for (const EnumRow& row : EnumTable<Transparency>::rows)
        EXPECT_TRUE(names.insert(row.name).second && !row.help.empty()) << row.name;
    EXPECT_EQ(rowOf(Transparency::Blend8).name, "blend8");
}

TEST(TransparencyChoices, StencilTakesExactlyTheChosenColor) {
    const Image colors = imageOf(PixelFormat::Rgba8, {255, 0, 255, 7, 255, 0, 254, 0, 255, 0, 255, 255});
    EXPECT_EQ(applyTransparency(colors, Stencil, {255, 0, 255}),
              imageOf(PixelFormat::Rgba8, {255, 0, 255, 0, 255, 0, 254, 255, 255, 0, 255, 0}));
}

TEST(TransparencyChoices, FileChangesNothing) {
    for (const Image& image :
         {imageOf(PixelFormat::Rgba8, {1, 2, 3, 4}), imageOf(PixelFormat::Rgb8, {1, 2, 3}),
          imageOf(PixelFormat::Luminance8, {9}), imageOf(PixelFormat::LuminanceAlpha8, {9, 8})})
        EXPECT_EQ(applyTransparency(image, File), image);
}

TEST(TransparencyChoices, SolidLeavesTheAlphaOut) {
    EXPECT_EQ(applyTransparency(imageOf(PixelFormat::Rgba8, {1, 2, 3, 4, 5, 6, 7, 8}), Solid),
              imageOf(PixelFormat::Rgb8, {1, 2, 3, 5, 6, 7}));
    EXPECT_EQ(applyTransparency(imageOf(PixelFormat::LuminanceAlpha8, {1, 2, 3, 4}), Solid),
              imageOf(PixelFormat::Luminance8, {1, 3}));
    EXPECT_EQ(applyTransparency(imageOf(PixelFormat::Rgb8, {1, 2, 3}), Solid),
              imageOf(PixelFormat::Rgb8, {1, 2, 3}));
}

TEST(TransparencyChoices, AlphaKeepsTheAlphaOfTheFile) {
    const Image image = imageOf(PixelFormat::Rgba8, {1, 2, 3, 4});
    EXPECT_EQ(applyTransparency(image, Alpha), image);
}

TEST(TransparencyChoices, GreyIsAColorOfThreeEqualComponents) {
    const Image grey = imageOf(PixelFormat::Luminance8, {0, 10, 100});
    EXPECT_EQ(applyTransparency(grey, Blend1),
              imageOf(PixelFormat::LuminanceAlpha8, {0, 0, 10, 30, 100, 255}));
    EXPECT_EQ(applyTransparency(grey, Stencil, {10, 10, 10}),
              imageOf(PixelFormat::LuminanceAlpha8, {0, 255, 10, 0, 100, 255}));
    EXPECT_EQ(applyTransparency(grey, Stencil, {10, 10, 11}),
              imageOf(PixelFormat::LuminanceAlpha8, {0, 255, 10, 255, 100, 255}));
}

TEST(TransparencyChoices, AlphaAloneStaysAsItIs) {
    const Image image = imageOf(PixelFormat::Alpha8, {1, 2, 3});
    for (const EnumRow& row : EnumTable<Transparency>::rows)
        EXPECT_EQ(applyTransparency(image, static_cast<Transparency>(row.value)), image) << row.name;
}

TEST(TransparencyChoices, EverySliceOfAVolumeIsChanged) {
    Image volume{PixelFormat::Luminance8, 1, 1, 3, {}};
    volume.pixels.assign(3, std::byte{5});
    const Image result = applyTransparency(volume, Blend1);
    EXPECT_EQ(result.depth, 3);
    EXPECT_EQ(std::to_integer<int>(result.at(0, 0, 2)[1]), 15);
}

} // namespace
} // namespace texplorer::transparency_test

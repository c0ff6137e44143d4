// Numbers by hand, from the tables of OpenGL 2.1: 3.6 for the pixel, 3.15 and 3.20 for the internal format.

#include "texplorer/reference/sampling/level_picture.h"

#include <gmock/gmock.h>

namespace texplorer::reference::source_colors_test {
namespace {

using testing::ElementsAre;

std::vector<int> numbersOf(const Image& image) {
    std::vector<int> numbers;
    for (const std::byte each : image.pixels)
        numbers.push_back(std::to_integer<int>(each));
    return numbers;
}

Image pixel(PixelFormat format, std::initializer_list<int> values) {
    Image image = Image::uninitialised(format, 1, 1);
    std::ranges::transform(values, image.pixels.begin(),
                           [](int value) { return static_cast<std::byte>(value); });
    return image;
}

TEST(SourceColors, AFormatKeepsItsPartOfAColour) {
    const Image color = pixel(PixelFormat::Rgba8, {10, 20, 30, 40});
    EXPECT_THAT(numbersOf(sourceColors(color, BaseFormat::Rgba)), ElementsAre(10, 20, 30, 40));
    EXPECT_THAT(numbersOf(sourceColors(color, BaseFormat::Rgb)), ElementsAre(10, 20, 30, 255));
    EXPECT_THAT(numbersOf(sourceColors(color, BaseFormat::Alpha)), ElementsAre(0, 0, 0, 40));
    EXPECT_THAT(numbersOf(sourceColors(color, BaseFormat::Luminance)), ElementsAre(10, 10, 10, 255));
    EXPECT_THAT(numbersOf(sourceColors(color, BaseFormat::LuminanceAlpha)), ElementsAre(10, 10, 10, 40));
    EXPECT_THAT(numbersOf(sourceColors(color, BaseFormat::Intensity)), ElementsAre(10, 10, 10, 10));
}

TEST(SourceColors, EveryPixelFormatIsAColour) {
    EXPECT_THAT(numbersOf(sourceColors(pixel(PixelFormat::Alpha8, {7}), BaseFormat::Rgba)),
                ElementsAre(0, 0, 0, 7));
    EXPECT_THAT(numbersOf(sourceColors(pixel(PixelFormat::Luminance8, {7}), BaseFormat::Rgba)),
                ElementsAre(7, 7, 7, 255));
    EXPECT_THAT(numbersOf(sourceColors(pixel(PixelFormat::LuminanceAlpha8, {7, 8}), BaseFormat::Rgba)),
                ElementsAre(7, 7, 7, 8));
    EXPECT_THAT(numbersOf(sourceColors(pixel(PixelFormat::Rgb8, {1, 2, 3}), BaseFormat::Rgba)),
                ElementsAre(1, 2, 3, 255));
}

TEST(SourceColors, RowsStayInTheirOrder) {
    Image image = Image::uninitialised(PixelFormat::Luminance8, 1, 3);
    for (int y = 0; y < 3; ++y)
        image.at(0, y)[0] = static_cast<std::byte>(y);
    EXPECT_THAT(numbersOf(sourceColors(image, BaseFormat::Rgb)),
                ElementsAre(0, 0, 0, 255, 1, 1, 1, 255, 2, 2, 2, 255));
}

} // namespace
} // namespace texplorer::reference::source_colors_test

#include "texplorer/image/stored_numbers.h"

#include <gtest/gtest.h>

#include <cmath>

namespace texplorer::stored_numbers_test {
namespace {

std::vector<int> bytesOf(const Image& image) {
    std::vector<int> bytes;
    for (const std::byte each : image.pixels)
        bytes.push_back(std::to_integer<int>(each));
    return bytes;
}

Image pixel(PixelFormat format, std::initializer_list<int> values) {
    Image image{format, 1, 1, 1, {}};
    for (const int value : values)
        image.pixels.push_back(static_cast<std::byte>(value));
    return image;
}

// OpenGL 2.1, section 2.14.9, in floating point: half a step is the most that is lost.
TEST(StoredNumber, IsTheNearestOfEveryByte) {
    for (int bits = 1; bits <= 8; ++bits) {
        const double largest = std::pow(2.0, bits) - 1;
        for (int byte = 0; byte < 256; ++byte) {
            EXPECT_EQ(storedNumber(byte, bits), static_cast<int>(std::floor(byte * largest / 255 + 0.5)))
                << byte << " in " << bits;
        }
        EXPECT_EQ(storedNumber(0, bits), 0);
        EXPECT_EQ(storedNumber(255, bits), (1 << bits) - 1);
    }
}

TEST(StoredNumber, ComesBackFromItsByte) {
    for (int bits = 1; bits <= 8; ++bits) {
        for (int number = 0; number < 1 << bits; ++number) {
            const int byte = byteOf(number, bits);
            EXPECT_EQ(storedNumber(byte, bits), number) << bits;
            EXPECT_NEAR(byte, 255.0 * number / ((1 << bits) - 1), 0.5) << bits;
        }
    }
}

struct Case {
    const char* name;
    InternalFormat format;
    Image given;
    std::vector<int> expected;
};

std::ostream& operator<<(std::ostream& out, const Case& given) {
    return out << given.name;
}

class StoredNumbers : public testing::TestWithParam<Case> {};

TEST_P(StoredNumbers, AreThoseOfTheFormatsBits) {
    const Image stored = withStoredNumbers(GetParam().given, GetParam().format);
    EXPECT_EQ(stored.format, PixelFormat::Rgba8);
    EXPECT_EQ(bytesOf(stored), GetParam().expected);
}

// n of 15 is 17 n; n of 31 is 8.23 n, n of 7 is 36.4 n, n of 3 is 85 n. What a format doesn't keep stays.
INSTANTIATE_TEST_SUITE_P(
    All, StoredNumbers,
    testing::Values(
        Case{"Rgba4", InternalFormat::Rgba4, pixel(PixelFormat::Rgba8, {8, 9, 127, 128}), {0, 17, 119, 136}},
        Case{"Rgb5A1", InternalFormat::Rgb5A1, pixel(PixelFormat::Rgba8, {4, 5, 250, 128}), {0, 8, 247, 255}},
        Case{"R3G3B2", InternalFormat::R3G3B2, pixel(PixelFormat::Rgb8, {18, 19, 42}), {0, 36, 0, 255}},
        Case{"GreyAsR3G3B2",
             InternalFormat::R3G3B2,
             pixel(PixelFormat::Luminance8, {100}),
             {109, 109, 85, 255}},
        Case{"Luminance4",
             InternalFormat::Luminance4,
             pixel(PixelFormat::Rgb8, {100, 3, 5}),
             {102, 3, 5, 255}},
        Case{"Alpha4", InternalFormat::Alpha4, pixel(PixelFormat::Alpha8, {100}), {0, 0, 0, 102}},
        Case{"GreyAndAlpha",
             InternalFormat::Luminance4Alpha4,
             pixel(PixelFormat::LuminanceAlpha8, {100, 200}),
             {102, 100, 100, 204}}),
    [](const auto& test) { return test.param.name; });

TEST(StoredNumbersOfEightBits, AreTheImageItself) {
    const Image image = pixel(PixelFormat::Rgb8, {1, 2, 3});
    for (const InternalFormat format : {InternalFormat::Rgba, InternalFormat::Srgb8, InternalFormat::Alpha,
                                        InternalFormat::DepthComponent16})
        EXPECT_EQ(withStoredNumbers(image, format), image) << rowOf(format).name;
}

} // namespace
} // namespace texplorer::stored_numbers_test

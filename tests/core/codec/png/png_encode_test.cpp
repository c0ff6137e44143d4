#include "tests/support/python.h"
#include "tests/support/raw_file.h"
#include "tests/support/temp_dir.h"
#include "texplorer/codec/png/png.h"
#include "texplorer/image/patterns/pattern.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace texplorer::png_encode_test {
namespace {

struct Mode {
    PixelFormat format;
    const char* pillow;
};

constexpr Mode modes[] = {
    {PixelFormat::Alpha8, "L"}, {PixelFormat::Luminance8, "L"}, {PixelFormat::LuminanceAlpha8, "LA"},
    {PixelFormat::Rgb8, "RGB"}, {PixelFormat::Rgba8, "RGBA"},
};

Image noise(PixelFormat format, int width, int height, int depth = 1) {
    Image image = Image::uninitialised(format, width, height, depth);
    std::mt19937 random(3); // NOLINT: the same picture each time
    std::ranges::generate(image.pixels, [&] { return static_cast<std::byte>(random() >> 24); });
    return image;
}

void put(const test::TempDir& folder, int number, const char* mode, const Image& image) {
    const Result<Bytes> png = encodePng(image);
    ASSERT_TRUE(png) << png.error().message;
    const std::string stem = std::to_string(number) + "_" + mode + "_" + std::to_string(image.width) + "x" +
                             std::to_string(image.height);
    test::writeRaw(folder / (stem + ".png"), *png);
    test::writeRaw(folder / (stem + ".raw"),
                   ByteView(image.pixels).first(image.rowBytes() * static_cast<std::size_t>(image.height)));
}

TEST(Png, PillowReadsWhatWasWritten) {
    const test::TempDir folder;
    int number = 0;
    for (const Mode& mode : modes)
        for (const auto& [width, height] : {std::pair{1, 1}, {3, 2}, {64, 5}, {257, 129}})
            put(folder, number++, mode.pillow, noise(mode.format, width, height));
    put(folder, number++, "RGBA", drawPattern(Pattern::UvTemplate));
    put(folder, number++, "RGBA", drawPattern(Pattern::Tree));
    put(folder, number++, "RGB", noise(PixelFormat::Rgb8, 4, 3, 2)); // a volume: its first slice
    EXPECT_TRUE(test::runPython("core/codec/png/png_against_pillow.py", folder.path()));
}

TEST(Png, TheSameImageGivesTheSameBytes) {
    const Image image = drawPattern(Pattern::Brick);
    EXPECT_EQ(encodePng(image), encodePng(image));
}

TEST(Png, AnImageWithoutPixelsIsRefused) {
    const Result<Bytes> png = encodePng({});
    ASSERT_FALSE(png);
    EXPECT_EQ(png.error().code, ErrorCode::OutOfRange);
    EXPECT_EQ(png.error().message, "PNG: a picture has at least 1 × 1 pixels, this one has 0 × 0");
}

TEST(Png, AnImageWhosePixelsAreMissingIsRefused) {
    Image image = noise(PixelFormat::Rgb8, 10, 10);
    image.pixels.resize(299);
    const Result<Bytes> png = encodePng(image);
    ASSERT_FALSE(png);
    EXPECT_EQ(png.error().message, "PNG: the picture needs 300 bytes, it has 299");
}

} // namespace
} // namespace texplorer::png_encode_test

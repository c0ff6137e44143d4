#include "tests/support/python.h"
#include "tests/support/raw_file.h"
#include "tests/support/temp_dir.h"
#include "texplorer/codec/bmp/bmp.h"
#include "texplorer/codec/registry.h"

#include <gtest/gtest.h>

namespace texplorer::bmp_encode_test {
namespace {

Image noise(PixelFormat format, int width, int height) {
    Image image = Image::uninitialised(format, width, height);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        image.pixels[i] = static_cast<std::byte>(i * 73 + i / 5 + 29);
    return image;
}

/// As OpenGL 2.1 expands a format for its environment (section 3.8.13), top row first.
Bytes asRgba(const Image& image) {
    Bytes rgba;
    for (int y = image.height - 1; y >= 0; --y)
        for (int x = 0; x < image.width; ++x) {
            const ByteView p = image.at(x, y);
            constexpr std::byte zero{0};
            constexpr std::byte one{255};
            switch (image.format) {
            case PixelFormat::Alpha8:
                rgba.insert(rgba.end(), {zero, zero, zero, p[0]});
                break;
            case PixelFormat::Luminance8:
                rgba.insert(rgba.end(), {p[0], p[0], p[0], one});
                break;
            case PixelFormat::LuminanceAlpha8:
                rgba.insert(rgba.end(), {p[0], p[0], p[0], p[1]});
                break;
            case PixelFormat::Rgb8:
                rgba.insert(rgba.end(), {p[0], p[1], p[2], one});
                break;
            case PixelFormat::Rgba8:
            case PixelFormat::Depth32:
            case PixelFormat::RgbaFloat:
                rgba.insert(rgba.end(), {p[0], p[1], p[2], p[3]});
                break;
            }
        }
    return rgba;
}

TEST(BmpEncode, OthersReadWhatWasWritten) {
    const test::TempDir folder;
    for (const PixelFormatRow& row : colorFormatRows)
        for (const auto& [width, height] : {std::pair{5, 3}, {8, 4}}) {
            const Image image = noise(row.format, width, height);
            const Result<Bytes> file = encodeBmp(textureOf(image, "BMP"), {});
            ASSERT_TRUE(file) << file.error().message;
            const std::string name =
                std::to_string(static_cast<int>(row.format)) + "_" + std::to_string(width);
            test::writeRaw(folder.path() / (name + ".bmp"), *file);
            test::writeRaw(folder.path() / (name + ".raw"), asRgba(image));
        }
    EXPECT_TRUE(test::runPython("fixtures/read_bmp.py", folder.path()));
}

TEST(BmpEncode, WhatWasWrittenIsReadAsItWas) {
    for (const PixelFormat format : {PixelFormat::Luminance8, PixelFormat::Rgb8, PixelFormat::Rgba8})
        for (int width = 1; width < 20; ++width) {
            const Image image = noise(format, width, 3);
            const Result<Bytes> file = encodeBmp(textureOf(image, "BMP"), {});
            ASSERT_TRUE(file);
            const Result<TextureImage> back = decodeBmp(*file);
            ASSERT_TRUE(back) << back.error().message;
            EXPECT_EQ(std::get<Image>(back->surface(0, 0)), image) << width;
            EXPECT_TRUE(back->notes.empty());
            const Anatomy anatomy = dissectBmp(*file);
            EXPECT_EQ(anatomy.damage, "");
            for (const Field& field : anatomy.fields)
                EXPECT_EQ(field.wrong, "") << field.name;
        }
}

TEST(BmpEncode, APictureWhoseTopRowComesFirstIsTurnedAround) {
    TextureImage texture = textureOf(noise(PixelFormat::Rgb8, 3, 4), "DDS");
    const Result<Bytes> upright = encodeBmp(texture, {});
    flipVertically(std::get<Image>(texture.surfaces.front()));
    texture.topFirst = true;
    EXPECT_EQ(encodeBmp(texture, {}), upright);
}

TEST(BmpEncode, NothingIsRefused) {
    EXPECT_FALSE(encodeBmp({}, {}));
    EXPECT_FALSE(encodeBmp(textureOf({}, "BMP"), {}));
}

} // namespace
} // namespace texplorer::bmp_encode_test

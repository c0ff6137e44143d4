#include "tests/support/python.h"
#include "tests/support/raw_file.h"
#include "tests/support/temp_dir.h"
#include "texplorer/codec/dds/dds.h"
#include "texplorer/image/mipmaps.h"
#include "texplorer/s3tc/flip.h"
#include "texplorer/s3tc/surface_pixels.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace texplorer::dds_encode_test {
namespace {

/// A texture of noise; compressed if `format` is a block format.
TextureImage noise(std::variant<PixelFormat, BlockFormat> format, int width, int height, int depth = 1,
                   int levels = 1, int faces = 1) {
    static std::mt19937 random(5); // NOLINT: the same textures each time
    const auto fill = [](Bytes& bytes) {
        std::ranges::generate(bytes, [] { return static_cast<std::byte>(random() >> 24); });
    };
    TextureImage texture;
    texture.format = "DDS";
    texture.faces = faces;
    texture.levels = levels;
    texture.topFirst = true;
    for (int face = 0; face < faces; ++face)
        for (int level = 0; level < levels; ++level) {
            const auto extent = [&](int base) { return std::max(1, base >> level); };
            if (const PixelFormat* pixels = std::get_if<PixelFormat>(&format)) {
                Image image = Image::uninitialised(*pixels, extent(width), extent(height), extent(depth));
                fill(image.pixels);
                texture.surfaces.emplace_back(std::move(image));
                continue;
            }
            BlockImage image = BlockImage::uninitialised(std::get<BlockFormat>(format), extent(width),
                                                         extent(height), extent(depth));
            fill(image.blocks);
            texture.surfaces.emplace_back(std::move(image));
        }
    return texture;
}

bool hasAlpha(const Surface& surface) {
    if (const Image* image = std::get_if<Image>(&surface))
        return image->format != PixelFormat::Luminance8 && image->format != PixelFormat::Rgb8;
    const BlockFormat format = std::get<BlockImage>(surface).format;
    return format == BlockFormat::Dxt1Alpha || format == BlockFormat::Dxt3 || format == BlockFormat::Dxt5;
}

bool isExtended(const Bytes& file) {
    return std::ranges::equal(ByteView(file).subspan(84, 4), std::as_bytes(std::span("DX10", 4)));
}

void expectRoundTrip(const TextureImage& texture) {
    const Result<Bytes> file = encodeDds(texture);
    ASSERT_TRUE(file) << file.error().message;
    const Result<TextureImage> again = decodeDds(*file);
    ASSERT_TRUE(again) << again.error().message;
    EXPECT_EQ(again->surfaces, texture.surfaces);
    EXPECT_EQ(again->faces, texture.faces);
    EXPECT_EQ(again->levels, texture.levels);
    EXPECT_EQ(again->srgb, texture.srgb);
    EXPECT_EQ(again->alpha, texture.alpha);
    const bool premultiplied = texture.alpha == AlphaMeaning::Premultiplied;
    EXPECT_THAT(again->notes, testing::IsEmpty());
    EXPECT_THAT(again->remarks, testing::SizeIs(premultiplied && !isExtended(*file) ? 1 : 0))
        << "nothing odd but what DXT2 and DXT4 say";
    for (const Field& field : dissectDds(*file).fields)
        EXPECT_TRUE(field.wrong.empty() || premultiplied) << field.name << ": " << field.wrong;
}

TEST(DdsEncode, WritesEveryLayerOfAnArray) {
    for (const PixelFormat format : {PixelFormat::Alpha8, PixelFormat::Luminance8,
                                     PixelFormat::LuminanceAlpha8, PixelFormat::Rgb8, PixelFormat::Rgba8}) {
        TextureImage texture;
        texture.layers = 3;
        texture.faces = 6;
        texture.topFirst = true;
        for (int i = 0; i < 18; ++i) {
            Image image = Image::uninitialised(format, 2, 2);
            std::ranges::fill(image.pixels, static_cast<std::byte>(10 * i));
            texture.surfaces.emplace_back(std::move(image));
        }
        const Result<Bytes> file = encodeDds(texture);
        ASSERT_TRUE(file) << file.error().message;
        EXPECT_EQ((*file)[140], std::byte{3}) << "arraySize counts cube maps";
        const Result<TextureImage> again = decodeDds(*file, {.everything = true});
        ASSERT_TRUE(again) << again.error().message;
        EXPECT_EQ(again->layers, 3);
        EXPECT_EQ(again->faces, 6);
        ASSERT_EQ(again->surfaces.size(), 18U);
        for (std::size_t i = 0; i < 18; ++i)
            EXPECT_EQ(std::get<Image>(again->surfaces[i]).pixels.front(), static_cast<std::byte>(10 * i));
    }
}

TEST(DdsEncode, RefusesLayersThatAreVolumes) {
    TextureImage texture;
    texture.layers = 2;
    for (int i = 0; i < 2; ++i)
        texture.surfaces.emplace_back(Image{PixelFormat::Luminance8, 1, 1, 2, Bytes(2)});
    EXPECT_EQ(encodeDds(texture).error().message,
              "DDS: the layers of an array are no volumes, these are 1 × 1 × 2");
}

TEST(DdsEncode, WhatIsReadAgainIsWhatWasWritten) {
    std::vector<std::variant<PixelFormat, BlockFormat>> formats;
    for (const PixelFormatRow& row : colorFormatRows)
        formats.emplace_back(row.format);
    for (const EnumRow& row : blockFormatRows)
        formats.emplace_back(static_cast<BlockFormat>(row.value));
    for (const auto& format : formats)
        for (TextureImage texture : {noise(format, 1, 1), noise(format, 13, 7, 1, 4),
                                     noise(format, 12, 12, 1, 2, 6), noise(format, 9, 6, 5, 3)}) {
            SCOPED_TRACE(testing::Message() << format.index() << " of " << widthOf(texture.surfaces.front()));
            texture.alpha = hasAlpha(texture.surfaces.front()) ? AlphaMeaning::Straight : AlphaMeaning::None;
            expectRoundTrip(texture);
        }
}

TEST(DdsEncode, SrgbAndPremultipliedAlphaAreKept) {
    for (const auto meaning : {AlphaMeaning::Straight, AlphaMeaning::Premultiplied, AlphaMeaning::Unknown})
        for (const auto format : {BlockFormat::Dxt3, BlockFormat::Dxt5, BlockFormat::Dxt1Alpha}) {
            TextureImage texture = noise(format, 8, 8, 1, 2, 6);
            texture.alpha = meaning;
            texture.srgb = true;
            if (format != BlockFormat::Dxt1Alpha || meaning != AlphaMeaning::Unknown)
                expectRoundTrip(texture);
            texture.srgb = false;
            if (meaning != AlphaMeaning::Unknown)
                expectRoundTrip(texture);
        }
    TextureImage texture = noise(PixelFormat::Rgba8, 5, 3, 2, 2);
    texture.alpha = AlphaMeaning::Premultiplied;
    expectRoundTrip(texture);
    texture.srgb = true;
    expectRoundTrip(texture);
    texture = noise(PixelFormat::Rgb8, 5, 3);
    texture.srgb = true;
    expectRoundTrip(texture);
    texture = noise(BlockFormat::Dxt1, 8, 8);
    texture.srgb = true;
    expectRoundTrip(texture);
}

TEST(DdsEncode, GreyWithSrgbBecomesColors) {
    TextureImage texture = noise(PixelFormat::LuminanceAlpha8, 3, 2);
    texture.srgb = true;
    texture.alpha = AlphaMeaning::Straight;
    const Result<Bytes> file = encodeDds(texture);
    ASSERT_TRUE(file);
    const Result<TextureImage> again = decodeDds(*file);
    ASSERT_TRUE(again);
    EXPECT_TRUE(again->srgb);
    const Image& grey = std::get<Image>(texture.surfaces.front());
    const Image& colors = std::get<Image>(again->surfaces.front());
    ASSERT_EQ(colors.format, PixelFormat::Rgba8);
    for (std::size_t i = 0; i < 6; ++i)
        for (std::size_t c = 0; c < 4; ++c)
            EXPECT_EQ(colors.pixels[4 * i + c], grey.pixels[2 * i + (c == 3 ? 1 : 0)]);
}

TEST(DdsEncode, TheOldHeaderIsTakenWhereItCanSayIt) {
    TextureImage opaque = noise(BlockFormat::Dxt1, 4, 4);
    BlockImage& blocks = std::get<BlockImage>(opaque.surfaces.front());
    const auto colors = [&](int first, int second) {
        blocks.blocks[0] = static_cast<std::byte>(first);
        blocks.blocks[2] = static_cast<std::byte>(second);
        blocks.blocks[1] = blocks.blocks[3] = std::byte{0};
        blocks.blocks[4] = std::byte{0x03};
    };
    colors(2, 1);
    EXPECT_FALSE(isExtended(*encodeDds(opaque)));
    colors(1, 2); // a code that an old header would make transparent
    EXPECT_TRUE(isExtended(*encodeDds(opaque)));
    EXPECT_FALSE(isExtended(*encodeDds(noise(BlockFormat::Dxt1Alpha, 4, 4))));
    EXPECT_FALSE(isExtended(*encodeDds(noise(PixelFormat::Rgba8, 4, 4))));
}

TEST(DdsEncode, ATextureWhoseBottomRowIsFirstIsTurnedOver) {
    for (const int height : {1, 2, 3, 8, 12}) {
        TextureImage texture = noise(BlockFormat::Dxt5, 8, height);
        texture.alpha = AlphaMeaning::Straight;
        texture.topFirst = false;
        const Image upright = uprightImage(texture);
        EXPECT_EQ(uprightImage(*decodeDds(*encodeDds(texture))), upright) << height << " rows";
    }
    TextureImage pixels = noise(PixelFormat::Rgb8, 3, 5, 2, 2);
    pixels.topFirst = false;
    EXPECT_EQ(uprightImage(*decodeDds(*encodeDds(pixels))), uprightImage(pixels));
}

TEST(DdsEncode, BlocksThatCannotBeTurnedAreRefused) {
    TextureImage texture = noise(BlockFormat::Dxt1, 8, 12, 1, 3);
    texture.topFirst = false;
    const Result<Bytes> file = encodeDds(texture);
    ASSERT_FALSE(file);
    EXPECT_EQ(file.error().code, ErrorCode::Unsupported);
    EXPECT_EQ(
        file.error().message,
        "DDS: the top row comes first in a file; level 1 has 6 rows, bottom row first, and blocks are turned "
        "without loss where there are 1, 2, 3 or a multiple of 4");
}

struct BadTexture {
    const char* name;
    void (*spoil)(TextureImage&); // 8 x 8 texels of RGB8 with two levels
    const char* message;
};

class DdsEncodeRefusals : public testing::TestWithParam<BadTexture> {};

TEST_P(DdsEncodeRefusals, SayWhatDoesNotFit) {
    TextureImage texture = noise(PixelFormat::Rgb8, 8, 8, 1, 2);
    GetParam().spoil(texture);
    const Result<Bytes> file = encodeDds(texture);
    ASSERT_FALSE(file);
    EXPECT_EQ(file.error().message, GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    All, DdsEncodeRefusals,
    testing::Values(
        BadTexture{"Faces", [](TextureImage& texture) { texture.faces = 2; },
                   "DDS: a texture has 1 or 6 faces, this one has 2"},
        BadTexture{"Nothing", [](TextureImage& texture) { texture = {}; },
                   "DDS: 1 layer of 1 faces with 1 levels are expected, there are 0 surfaces"},
        BadTexture{"Empty", [](TextureImage& texture) { texture = textureOf({}, "BMP"); },
                   "DDS: a texture has at least 1 × 1 × 1 texels, this one has 0 × 0 × 1"},
        BadTexture{"Extents", [](TextureImage& texture) { std::get<Image>(texture.surfaces[1]).width = 3; },
                   "DDS: level 1 of 3 × 4 × 1 texels is no mip level of 8 × 8 × 1"},
        BadTexture{
            "Format",
            [](TextureImage& texture) { std::get<Image>(texture.surfaces[1]).format = PixelFormat::Rgba8; },
            "DDS: level 1 has another format than level 0"},
        BadTexture{"Bytes",
                   [](TextureImage& texture) { std::get<Image>(texture.surfaces[1]).pixels.pop_back(); },
                   "DDS: level 1 needs 48 bytes, it has 47"},
        BadTexture{"TooManyLevels",
                   [](TextureImage& texture) { texture = noise(PixelFormat::Rgb8, 2, 1, 1, 3); },
                   "DDS: a mip chain of 2 × 1 × 1 texels has at most 2 levels, this one has 3"},
        BadTexture{"Oblong", [](TextureImage& texture) { texture = noise(PixelFormat::Rgb8, 8, 4, 1, 1, 6); },
                   "DDS: the faces of a cube map are square, these are 8 × 4 × 1"}),
    [](const auto& test) { return std::string(test.param.name); });

/// What Pillow and ImageMagick read: NAME_WxH.dds, NAME_WxH.raw as RGBA with the top row first.
TEST(DdsEncode, PillowAndImageMagickReadWhatWasWritten) {
    const test::TempDir folder;
    int number = 0;
    const auto put = [&](const std::string& who, const TextureImage& texture) {
        const Result<Bytes> file = encodeDds(texture);
        ASSERT_TRUE(file) << file.error().message;
        const Surface& base = texture.surfaces.front();
        const std::string stem = who + std::to_string(number++) + "_" + std::to_string(widthOf(base)) + "x" +
                                 std::to_string(heightOf(base));
        test::writeRaw(folder / (stem + ".dds"), *file);
        Image image = toImage(base);
        if (image.format == PixelFormat::Rgb8 || image.format == PixelFormat::Rgba8)
            test::writeRaw(folder / (stem + (image.format == PixelFormat::Rgb8 ? ".rgb" : ".rgba")),
                           image.pixels);
        else
            test::writeRaw(folder / (stem + (image.format == PixelFormat::Luminance8 ? ".l" : ".la")),
                           image.pixels);
    };
    for (const auto& [width, height] : {std::pair{1, 1}, {4, 4}, {7, 5}, {32, 20}}) {
        const int levels = mipLevelCount(width, height);
        for (const auto format : {BlockFormat::Dxt1Alpha, BlockFormat::Dxt3, BlockFormat::Dxt5})
            put("both", noise(format, width, height, 1, levels));
        for (const auto format : {BlockFormat::Bc4, BlockFormat::Bc5})
            put("pillow", noise(format, width, height, 1, levels));
        for (const auto format : {PixelFormat::Rgb8, PixelFormat::Rgba8})
            put("both", noise(format, width, height, 1, levels));
        for (const auto format : {PixelFormat::Luminance8, PixelFormat::LuminanceAlpha8})
            put("pillow", noise(format, width, height, 1, levels));
        TextureImage srgb = noise(PixelFormat::Rgba8, width, height);
        srgb.srgb = true;
        put("pillow", srgb);
    }
    EXPECT_TRUE(test::runPython("core/codec/dds/dds_against_pillow.py", folder.path()));
}

} // namespace
} // namespace texplorer::dds_encode_test

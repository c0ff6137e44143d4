#include "tests/core/codec/dds/dds_files.h"
#include "tests/support/python.h"
#include "tests/support/raw_file.h"
#include "tests/support/temp_dir.h"
#include "texplorer/codec/dds/dds.h"
#include "texplorer/codec/dds/dds_header.h"
#include "texplorer/s3tc/surface_pixels.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <random>

namespace texplorer::dds_test {
namespace {

using dds::fourCC;
using dds::Header;
using test::ddsFile;
using test::legacyDds;
using enum ErrorCode;

/// As Pillow's convert("RGBA") and ImageMagick's rgba: show a surface.
Bytes asRgba(const Surface& surface) {
    const Image image = toImage(surface);
    Bytes rgba;
    const auto components = static_cast<std::size_t>(bytesPerPixel(image.format));
    for (std::size_t i = 0; i < image.pixels.size(); i += components) {
        const std::byte* p = image.pixels.data() + i;
        const bool grey = components < 3;
        const std::byte alpha = components % 2 == 0 ? p[components - 1] : std::byte{255};
        rgba.insert(rgba.end(), {p[0], grey ? p[0] : p[1], grey ? p[0] : p[2], alpha});
    }
    return rgba;
}

TEST(Dds, PillowAndImageMagickSeeTheSamePixels) {
    const test::TempDir folder;
    ASSERT_TRUE(test::runPython("fixtures/make_dds.py", folder.path()));
    int compared = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
        if (entry.path().extension() != ".dds")
            continue;
        SCOPED_TRACE(entry.path().filename());
        int width = 0;
        int height = 0;
        ASSERT_EQ(std::sscanf(entry.path().stem().c_str(), "%*[a-z0-9]_%dx%d", &width, &height), 2);
        const Bytes file = test::readRaw(entry.path());
        const Result<TextureImage> texture = decodeDds(file);
        ASSERT_TRUE(texture) << texture.error().message;
        EXPECT_TRUE(texture->topFirst);
        EXPECT_TRUE(texture->fileTopFirst);
        EXPECT_EQ(texture->faces, 1);
        ASSERT_EQ(texture->surfaces.size(), static_cast<std::size_t>(texture->levels));
        EXPECT_EQ(dissectDds(file).damage, "");
        for (int level = 0; level < texture->levels; ++level) {
            const Surface& surface = texture->surface(0, level);
            EXPECT_EQ(widthOf(surface), std::max(1, width >> level));
            EXPECT_EQ(heightOf(surface), std::max(1, height >> level));
            const auto raw =
                std::filesystem::path(entry.path()).replace_extension("." + std::to_string(level) + ".raw");
            ASSERT_TRUE(std::filesystem::exists(raw)) << raw;
            EXPECT_EQ(asRgba(surface), test::readRaw(raw)) << "level " << level;
            ++compared;
        }
    }
    EXPECT_EQ(compared, 8 * 15 + 2 + 3 * (1 + 5 + 4 + 7));
}

TEST(Dds, OfAnArrayTheFirstElementIsReadWithItsFacesAndLevels) {
    Header header = test::dxgi(61); // a byte a texel
    header.width = header.height = 2;
    header.mipMapCount = 2;
    header.flags |= dds::flagMipMapCount;
    header.arraySize = 3;
    header.miscFlag = 4; // cube maps
    std::vector<int> texels;
    for (int i = 0; i < 3 * 6 * 5; ++i)
        texels.push_back(i);
    const Bytes file = ddsFile(header, texels);
    const Result<TextureImage> texture = decodeDds(file);
    ASSERT_TRUE(texture) << texture.error().message;
    ASSERT_EQ(texture->faces, 6);
    ASSERT_EQ(texture->levels, 2);
    for (int face = 0; face < 6; ++face)
        for (int level = 0; level < 2; ++level)
            EXPECT_EQ(std::get<Image>(texture->surface(face, level)).pixels.front(),
                      static_cast<std::byte>(5 * face + 4 * level));
    const Anatomy anatomy = dissectDds(file);
    EXPECT_EQ(anatomy.damage, "");
    const Field& others = anatomy.fields.back();
    EXPECT_EQ(others.name, "other elements");
    EXPECT_EQ(others.value, "2 of the array");
    EXPECT_EQ(others.meaning, "scenes show only the first");
    EXPECT_EQ(others.offset, 148U + 30);
    EXPECT_EQ(others.size, 60U);
}

struct PixelCase {
    const char* name;
    Header header; // 1 x 1 texel
    std::vector<int> bytes;
    PixelFormat format;
    std::vector<int> expected;
};

class DdsPixels : public testing::TestWithParam<PixelCase> {};

TEST_P(DdsPixels, AreWhatTheMasksSay) {
    const PixelCase& row = GetParam();
    const Result<TextureImage> texture = decodeDds(ddsFile(row.header, row.bytes));
    ASSERT_TRUE(texture) << texture.error().message;
    const Image& image = std::get<Image>(texture->surfaces.front());
    EXPECT_EQ(image.format, row.format);
    std::vector<int> found;
    for (const std::byte byte : image.pixels)
        found.push_back(std::to_integer<int>(byte));
    EXPECT_EQ(found, row.expected);
    EXPECT_THAT(texture->notes, testing::IsEmpty());
}

using enum PixelFormat;
using test::dxgi;
using test::masked;

// 5 bits: 3 becomes 3 * 255 / 31 = 24.7, 6 bits: 21 becomes 85, 10 bits: 512 becomes 127.6.
INSTANTIATE_TEST_SUITE_P(
    All, DdsPixels,
    testing::Values(
        PixelCase{"R5G6B5", masked(0x40, 16, 0xF800, 0x7E0, 0x1F), {0xA3, 0xFA}, Rgb8, {255, 85, 25}},
        PixelCase{
            "A1R5G5B5", masked(0x41, 16, 0x7C00, 0x3E0, 0x1F, 0x8000), {0x1F, 0x80}, Rgba8, {0, 0, 255, 255}},
        PixelCase{"X1R5G5B5", masked(0x40, 16, 0x7C00, 0x3E0, 0x1F), {0x1F, 0x80}, Rgb8, {0, 0, 255}},
        PixelCase{
            "A4R4G4B4", masked(0x41, 16, 0xF00, 0xF0, 0xF, 0xF000), {0x21, 0x43}, Rgba8, {51, 34, 17, 68}},
        PixelCase{"R3G3B2", masked(0x40, 8, 0xE0, 0x1C, 3), {0xE6}, Rgb8, {255, 36, 170}},
        PixelCase{"A8R3G3B2", masked(0x41, 16, 0xE0, 0x1C, 3, 0xFF00), {0xE6, 9}, Rgba8, {255, 36, 170, 9}},
        PixelCase{"A2B10G10R10",
                  masked(0x41, 32, 0x3FF, 0xFFC00, 0x3FF00000, 0xC0000000),
                  {0x00, 0x02, 0xF0, 0x7F},
                  Rgba8,
                  {128, 0, 255, 85}},
        PixelCase{"D16", masked(0x400, 16, 0, 0xFFFF, 0), {0x22, 0x22}, Luminance8, {34}},
        PixelCase{"D24S8", masked(0x4400, 32, 8, 0xFFFFFF00, 0xFF), {7, 0, 0, 0x80}, Luminance8, {128}},
        PixelCase{
            "G16R16", masked(0x40, 32, 0xFFFF, 0xFFFF0000, 0), {0xFF, 0xFF, 0x00, 0x80}, Rgb8, {255, 128, 0}},
        PixelCase{"AnyOrder",
                  masked(0x41, 32, 0xFF00, 0xFF000000, 0xFF, 0xFF0000),
                  {1, 2, 3, 4},
                  Rgba8,
                  {2, 4, 1, 3}},
        PixelCase{"X8R8G8B8", masked(0x40, 32, 0xFF0000, 0xFF00, 0xFF), {1, 2, 3, 4}, Rgb8, {3, 2, 1}},
        PixelCase{
            "AllBitsOneChannel", masked(0x40, 32, 0xFFFFFFFF, 0, 0), {0, 0, 0, 0x80}, Rgb8, {128, 0, 0}},
        PixelCase{"HoleInMask", masked(0x40, 8, 0x5, 0, 0), {0x5}, Rgb8, {255, 0, 0}},
        PixelCase{"L8", masked(0x20000, 8, 0xFF, 0, 0), {77}, Luminance8, {77}},
        PixelCase{"L8Repeated", masked(0x20000, 8, 0xFF, 0xFF, 0xFF), {77}, Luminance8, {77}},
        PixelCase{"L16", masked(0x20000, 16, 0xFFFF, 0, 0), {0xFF, 0x7F}, Luminance8, {127}},
        PixelCase{"A8L8", masked(0x20001, 16, 0xFF, 0, 0, 0xFF00), {77, 5}, LuminanceAlpha8, {77, 5}},
        PixelCase{"A4L4", masked(0x20001, 8, 0xF, 0, 0, 0xF0), {0x21}, LuminanceAlpha8, {17, 34}},
        PixelCase{"A8", masked(0x2, 8, 0, 0, 0, 0xFF), {9}, Alpha8, {9}},
        PixelCase{"DxgiRgba", dxgi(28), {1, 2, 3, 4}, Rgba8, {1, 2, 3, 4}},
        PixelCase{"DxgiBgra", dxgi(87), {1, 2, 3, 4}, Rgba8, {3, 2, 1, 4}},
        PixelCase{"DxgiBgrx", dxgi(88), {1, 2, 3, 4}, Rgb8, {3, 2, 1}},
        PixelCase{"DxgiR8", dxgi(61), {7}, Luminance8, {7}},
        PixelCase{"DxgiRg8", dxgi(49), {7, 8}, Rgb8, {7, 8, 0}},
        PixelCase{"DxgiA8", dxgi(65), {7}, Alpha8, {7}},
        PixelCase{"DxgiR16", dxgi(56), {0xFF, 0x7F}, Luminance8, {127}},
        PixelCase{"DxgiRg16", dxgi(35), {0xFF, 0xFF, 0x00, 0x80}, Rgb8, {255, 128, 0}},
        PixelCase{"DxgiB5G6R5", dxgi(85), {0xA3, 0xFA}, Rgb8, {255, 85, 25}},
        PixelCase{"DxgiB5G5R5A1", dxgi(86), {0x1F, 0x80}, Rgba8, {0, 0, 255, 255}},
        PixelCase{"DxgiB4G4R4A4", dxgi(115), {0x21, 0x43}, Rgba8, {51, 34, 17, 68}},
        PixelCase{"DxgiA4B4G4R4", dxgi(191), {0x21, 0x43}, Rgba8, {68, 51, 34, 17}},
        PixelCase{"DxgiR10G10B10A2", dxgi(24), {0x00, 0x02, 0xF0, 0x7F}, Rgba8, {128, 0, 255, 85}}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(DdsPixels, AreWhatD3dxMeansWhereItsMasksSayTheOpposite) {
    const Header header = masked(0x41, 32, 0x3FF00000, 0xFFC00, 0x3FF, 0xC0000000);
    const Result<TextureImage> texture = decodeDds(ddsFile(header, {0xFF, 0x03, 0x00, 0xC0}));
    ASSERT_TRUE(texture) << texture.error().message;
    const std::vector<std::byte> red{std::byte{255}, std::byte{0}, std::byte{0}, std::byte{255}};
    EXPECT_THAT(std::get<Image>(texture->surfaces.front()).pixels, testing::ElementsAreArray(red));
    EXPECT_EQ(texture->componentBits, 10);
    EXPECT_THAT(texture->notes,
                testing::ElementsAre(testing::HasSubstr("as D3DX writes them for 10:10:10:2")));
}

TEST(DdsPixels, OfDepthSayHowManyBitsItHas) {
    const Header header = masked(0x400, 16, 0, 0xFFFF, 0);
    EXPECT_EQ(decodeDds(ddsFile(header, {0, 0}))->componentBits, 16);
}

TEST(DdsPixels, AreMultipliedByAlphaWhereDirectDrawSaysSo) {
    const Header header = masked(0x8041, 32, 0xFF0000, 0xFF00, 0xFF, 0xFF000000);
    EXPECT_EQ(decodeDds(ddsFile(header, {1, 2, 3, 4}))->alpha, AlphaMeaning::Premultiplied);
}

TEST(Dds, OfAnArrayEveryElementIsReadWhereAllIsAsked) {
    Header header = dxgi(61); // a byte a texel
    header.width = header.height = 2;
    header.mipMapCount = 2;
    header.flags |= dds::flagMipMapCount;
    header.arraySize = 3;
    header.miscFlag = 4; // cube maps
    std::vector<int> texels;
    for (int i = 0; i < 3 * 6 * 5; ++i)
        texels.push_back(i);
    DecodeLimits limits;
    limits.everything = true;
    const Bytes file = ddsFile(header, texels);
    const Result<TextureImage> texture = decodeDds(file, limits);
    ASSERT_TRUE(texture) << texture.error().message;
    EXPECT_EQ(texture->layers, 3);
    EXPECT_EQ(texture->faces, 6);
    ASSERT_EQ(texture->surfaces.size(), 36U);
    for (int face = 0; face < 18; ++face)
        for (int level = 0; level < 2; ++level)
            EXPECT_EQ(std::get<Image>(texture->surface(face, level)).pixels.front(),
                      static_cast<std::byte>(5 * face + 4 * level));
    EXPECT_THAT(texture->remarks, testing::IsEmpty());
    limits.maxBytes = 3 * 6 * 5 - 1;
    EXPECT_EQ(decodeDds(file, limits).error().code, ErrorCode::TooLarge);
    header.arraySize = 2049;
    EXPECT_EQ(
        decodeDds(ddsFile(header, std::vector<int>(2049 * 6 * 5, 0)), {.everything = true}).error().message,
        "DDS: arrays of at most 2048 elements are read, this one has 2049");
}

struct BlockCase {
    const char* name;
    Header header;
    BlockFormat format;
    bool srgb;
    AlphaMeaning alpha;
};

class DdsBlocks : public testing::TestWithParam<BlockCase> {};

TEST_P(DdsBlocks, AreKeptAsTheyAre) {
    const BlockCase& row = GetParam();
    std::vector<int> bytes(bytesPerBlock(row.format));
    for (std::size_t i = 0; i < bytes.size(); ++i)
        bytes[i] = 200 - static_cast<int>(i) * 9; // as a DXT1 block: four colours
    const Result<TextureImage> texture = decodeDds(ddsFile(row.header, bytes));
    ASSERT_TRUE(texture) << texture.error().message;
    const BlockImage& image = std::get<BlockImage>(texture->surfaces.front());
    EXPECT_EQ(image.format, row.format);
    EXPECT_EQ(texture->srgb, row.srgb);
    EXPECT_EQ(texture->alpha, row.alpha);
    for (std::size_t i = 0; i < bytes.size(); ++i)
        EXPECT_EQ(std::to_integer<int>(image.blocks.at(i)), bytes[i]);
}

using enum AlphaMeaning;
using enum BlockFormat;

Header withAlphaPixels(Header header) {
    header.formatFlags |= dds::formatAlphaPixels;
    return header;
}

INSTANTIATE_TEST_SUITE_P(
    All, DdsBlocks,
    testing::Values(BlockCase{"DXT1", legacyDds("DXT1"), Dxt1, false, None},
                    BlockCase{"DXT1Flagged", withAlphaPixels(legacyDds("DXT1")), Dxt1Alpha, false, Straight},
                    BlockCase{"DXT2", legacyDds("DXT2"), Dxt3, false, Premultiplied},
                    BlockCase{"DXT3", legacyDds("DXT3"), Dxt3, false, Straight},
                    BlockCase{"DXT4", legacyDds("DXT4"), Dxt5, false, Premultiplied},
                    BlockCase{"DXT5", legacyDds("DXT5"), Dxt5, false, Straight},
                    BlockCase{"ATI1", legacyDds("ATI1"), Bc4, false, None},
                    BlockCase{"BC4U", legacyDds("BC4U"), Bc4, false, None},
                    BlockCase{"BC4S", legacyDds("BC4S"), Bc4Signed, false, None},
                    BlockCase{"ATI2", legacyDds("ATI2"), Bc5, false, None},
                    BlockCase{"BC5U", legacyDds("BC5U"), Bc5, false, None},
                    BlockCase{"BC5S", legacyDds("BC5S"), Bc5Signed, false, None},
                    BlockCase{"DxgiBc1", dxgi(71), Dxt1, false, None},
                    BlockCase{"DxgiBc1Srgb", dxgi(72), Dxt1, true, None},
                    BlockCase{"DxgiBc1Straight", dxgi(71, 1), Dxt1Alpha, false, Straight},
                    BlockCase{"DxgiBc1Premultiplied", dxgi(71, 2), Dxt1Alpha, false, Premultiplied},
                    BlockCase{"DxgiBc2", dxgi(74), Dxt3, false, Unknown},
                    BlockCase{"DxgiBc2Srgb", dxgi(75, 1), Dxt3, true, Straight},
                    BlockCase{"DxgiBc3", dxgi(77, 2), Dxt5, false, Premultiplied},
                    BlockCase{"DxgiBc3Srgb", dxgi(78, 3), Dxt5, true, None},
                    BlockCase{"DxgiBc3Custom", dxgi(77, 4), Dxt5, false, Unknown},
                    BlockCase{"DxgiBc4", dxgi(80), Bc4, false, None},
                    BlockCase{"DxgiBc4Signed", dxgi(81), Bc4Signed, false, None},
                    BlockCase{"DxgiBc5", dxgi(83), Bc5, false, None},
                    BlockCase{"DxgiBc5Signed", dxgi(84), Bc5Signed, false, None}),
    [](const auto& test) { return std::string(test.param.name); });

struct HoleCase {
    const char* name;
    int width;
    int height;
    std::vector<int> block;
    int alphaMode; // -1: an old header
    BlockFormat format;
};

class DdsDxt1 : public testing::TestWithParam<HoleCase> {};

TEST_P(DdsDxt1, HasAlphaWhereATexelThatOneSeesIsTransparent) {
    const HoleCase& row = GetParam();
    Header header = row.alphaMode < 0 ? legacyDds("DXT1") : dxgi(71, static_cast<unsigned>(row.alphaMode));
    header.width = static_cast<unsigned>(row.width);
    header.height = static_cast<unsigned>(row.height);
    const Result<TextureImage> texture = decodeDds(ddsFile(header, row.block));
    ASSERT_TRUE(texture);
    EXPECT_EQ(std::get<BlockImage>(texture->surfaces.front()).format, row.format);
    EXPECT_EQ(texture->alpha == None, row.format == Dxt1);
}

// Colours 1 and 2: three colours and a hole; colours 2 and 1: four colours. The last byte holds the bottom
// row, its two lowest bits the left texel.
INSTANTIATE_TEST_SUITE_P(
    All, DdsDxt1,
    testing::Values(HoleCase{"NoHole", 4, 4, {1, 0, 2, 0, 0xAA, 0x55, 0, 0xAA}, -1, Dxt1},
                    HoleCase{"TwoNeighboursAreNoHole", 4, 4, {1, 0, 2, 0, 0x06, 0, 0, 0x60}, -1, Dxt1},
                    HoleCase{"LastTexel", 4, 4, {1, 0, 2, 0, 0, 0, 0, 0xC0}, -1, Dxt1Alpha},
                    HoleCase{"EqualColors", 4, 4, {1, 0, 1, 0, 0x03, 0, 0, 0}, -1, Dxt1Alpha},
                    HoleCase{"FourColors", 4, 4, {2, 0, 1, 0, 0xFF, 0xFF, 0xFF, 0xFF}, -1, Dxt1},
                    HoleCase{"OutsideToTheRight", 3, 4, {1, 0, 2, 0, 0xC0, 0xC0, 0xC0, 0xC0}, -1, Dxt1},
                    HoleCase{"OutsideBelow", 4, 3, {1, 0, 2, 0, 0, 0, 0, 0xFF}, -1, Dxt1},
                    HoleCase{"InsideTheCorner", 1, 1, {1, 0, 2, 0, 0x03, 0, 0, 0}, -1, Dxt1Alpha},
                    HoleCase{"Dx10Detected", 4, 4, {1, 0, 2, 0, 0x03, 0, 0, 0}, 0, Dxt1Alpha},
                    HoleCase{"Dx10Opaque", 4, 4, {1, 0, 2, 0, 0x03, 0, 0, 0}, 3, Dxt1}),
    [](const auto& test) { return std::string(test.param.name); });

} // namespace
} // namespace texplorer::dds_test

#include "tests/core/codec/dds/dds_files.h"
#include "texplorer/codec/losses.h"
#include "texplorer/codec/registry.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace texplorer::losses_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TextureImage readDds(const dds::Header& header, std::size_t bytes) {
    return decodeTexture(test::ddsFile(header, std::vector<int>(bytes, 7)), {.everything = true}).value();
}

/// {"layers", "levels"}
std::vector<std::string_view> lostIn(const TextureImage& texture, std::string_view format) {
    std::vector<std::string_view> names;
    for (const Loss& loss : lossesIn(texture, format))
        names.push_back(loss.what);
    return names;
}

TEST(LossesIn, NameWhatAFormatOfOnePictureCantHold) {
    dds::Header array = test::dxgi(61);
    array.width = array.height = 2;
    array.mipMapCount = 2;
    array.flags |= 0x20000;
    array.arraySize = 3;
    array.miscFlag = 4;
    const TextureImage cubes = readDds(array, 3 * 6 * 5);
    for (const std::string_view format : {"BMP", "PNG", "TGA"})
        EXPECT_THAT(lostIn(cubes, format), ElementsAre("layers", "faces", "levels"));
    EXPECT_THAT(lostIn(cubes, "DDS"), IsEmpty());
    EXPECT_EQ(pixelsLost(lossesIn(cubes, "PNG")),
              "2 of the array's 3 layers; 5 of the cube map's 6 faces; 1 of the texture's 2 mip levels");

    dds::Header volume = test::dxgi(61);
    volume.dimension = 4;
    volume.flags |= 0x800000;
    volume.depth = 4;
    EXPECT_THAT(lostIn(readDds(volume, 4), "PNG"), ElementsAre("slices"));
    EXPECT_THAT(lostIn(readDds(volume, 4), "DDS"), IsEmpty());
}

TEST(LossesIn, NameBitsThatNothingKeeps) {
    for (const dds::Header& header :
         {test::dxgi(24), test::dxgi(35), test::masked(0x20000, 16, 0xFFFF, 0, 0)})
        for (const std::string_view format : {"BMP", "DDS", "PNG", "TGA"})
            EXPECT_THAT(lostIn(readDds(header, header.bitCount == 16 ? 2 : 4), format),
                        ElementsAre("componentBits"));
    EXPECT_THAT(lostIn(readDds(test::masked(0x40, 16, 0xF800, 0x7E0, 0x1F), 2), "PNG"), IsEmpty())
        << "5 and 6 bits";
}

TEST(LossesIn, NameWhatAlphaMeans) {
    dds::Header premultiplied = test::dxgi(28, 2);
    EXPECT_THAT(lostIn(readDds(premultiplied, 4), "PNG"), ElementsAre("alpha"));
    EXPECT_THAT(lostIn(readDds(premultiplied, 4), "TGA"), IsEmpty()) << "its attributes type says so";
    EXPECT_THAT(lostIn(readDds(premultiplied, 4), "DDS"), IsEmpty());
    EXPECT_THAT(lostIn(readDds(test::dxgi(65), 1), "PNG"), ElementsAre("alpha"));
    EXPECT_THAT(lostIn(readDds(test::dxgi(65), 1), "BMP"), IsEmpty()) << "0, 0, 0, A";
    EXPECT_EQ(pixelsLost(lossesIn(readDds(premultiplied, 4), "PNG")), "") << "every number stays";
}

TEST(LossesIn, NameWhatStandsBesideThePicture) {
    TextureImage texture = textureOf(Image{PixelFormat::Rgb8, 1, 1, 1, Bytes(3)}, "PNG");
    texture.parts = {{"iCCP", {}}, {"tEXt", {}}};
    EXPECT_THAT(lostIn(texture, "PNG"), IsEmpty());
    EXPECT_THAT(lostIn(texture, "BMP"), ElementsAre("colorProfile", "metadata"));
    EXPECT_EQ(allLost(lossesIn(texture, "BMP")), "the ICC profile; its texts");
    texture.parts = {{"gAMA", {}}};
    EXPECT_THAT(lostIn(texture, "TGA"), ElementsAre("colorProfile"));
    texture.parts = {{"gAMA", {}}, {"sRGB", {}}};
    EXPECT_THAT(lostIn(texture, "TGA"), IsEmpty()) << "what all of them mean where they say nothing";
}

Image filled(PixelFormat format, std::initializer_list<int> pixel) {
    Image image = Image::uninitialised(format, 2, 2);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        image.pixels[i] = static_cast<std::byte>(pixel.begin()[i % pixel.size()]);
    return image;
}

struct KeptCase {
    Image picture;
    BlockFormat format;
    const char* lost;
};

// BC1 has no alpha, BC4 red alone, BC5 red and green.
TEST(LossesIn, NameTheComponentsThatBlocksKeepNothingOf) {
    const Image colors = filled(PixelFormat::Rgb8, {10, 20, 30});
    const Image clear = filled(PixelFormat::Rgba8, {10, 20, 30, 7});
    const Image opaque = filled(PixelFormat::Rgba8, {10, 20, 30, 255});
    for (const KeptCase& each : {
             KeptCase{clear, BlockFormat::Dxt1, "alpha (DXT1 keeps only red, green and blue)"},
             KeptCase{clear, BlockFormat::Bc4, "green, blue and alpha (BC4 keeps only red)"},
             KeptCase{clear, BlockFormat::Bc5, "blue and alpha (BC5 keeps only red and green)"},
             KeptCase{colors, BlockFormat::Bc4, "green and blue (BC4 keeps only red)"},
             KeptCase{opaque, BlockFormat::Dxt1, ""},
             KeptCase{clear, BlockFormat::Dxt1Alpha, ""},
             KeptCase{clear, BlockFormat::Dxt3, ""},
             KeptCase{clear, BlockFormat::Dxt5, ""},
             KeptCase{filled(PixelFormat::Rgb8, {10, 20, 0}), BlockFormat::Bc5, ""},
             KeptCase{filled(PixelFormat::Rgb8, {10, 0, 0}), BlockFormat::Bc4, ""},
             KeptCase{filled(PixelFormat::Rgb8, {9, 9, 9}), BlockFormat::Bc4, ""},
             KeptCase{filled(PixelFormat::Luminance8, {9}), BlockFormat::Bc4, ""},
             KeptCase{filled(PixelFormat::LuminanceAlpha8, {9, 8}), BlockFormat::Bc5,
                      "alpha (BC5 keeps only red and green)"},
         })
        EXPECT_EQ(pixelsLost(lossesIn({each.picture}, each.format)), each.lost) << rowOf(each.format).label;
    EXPECT_EQ(pixelsLost(lossesIn({opaque, clear}, BlockFormat::Dxt1)),
              pixelsLost(lossesIn({clear}, BlockFormat::Dxt1)))
        << "of any level and face";
    EXPECT_EQ(lossesIn({clear}, BlockFormat::Dxt1).front().what, "components");
}

} // namespace
} // namespace texplorer::losses_test

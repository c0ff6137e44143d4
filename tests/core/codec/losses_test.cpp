#include "core/codec/losses.h"
#include "core/codec/registry.h"
#include "tests/core/codec/dds/dds_files.h"

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
    texture.parts = {{"gAMA", {}}};
    EXPECT_THAT(lostIn(texture, "TGA"), ElementsAre("colorProfile"));
    texture.parts = {{"gAMA", {}}, {"sRGB", {}}};
    EXPECT_THAT(lostIn(texture, "TGA"), IsEmpty()) << "what all of them mean where they say nothing";
}

} // namespace
} // namespace texplorer::losses_test

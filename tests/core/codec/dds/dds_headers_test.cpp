// Wrong headers that are accepted, headers that are refused, and files that end too early.

#include "tests/core/codec/dds/dds_files.h"
#include "texplorer/codec/dds/dds.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace texplorer::dds_headers_test {
namespace {

using dds::Header;
using test::ddsFile;
using test::dxgi;
using test::legacyDds;
using test::masked;
using enum ErrorCode;

Header sized(Header header, unsigned width, unsigned height, unsigned mips = 0) {
    header.width = width;
    header.height = height;
    header.mipMapCount = mips;
    if (mips > 0)
        header.flags |= 0x20000;
    return header;
}

/// A header with one field changed.
Header with(Header header, std::uint32_t Header::*field, std::uint32_t value) {
    header.*field = value;
    return header;
}

Header cube(Header header, std::uint32_t faces = 0xFC00) {
    header.caps2 |= 0x200 | faces;
    return header;
}

Header volume(Header header, std::uint32_t depth) {
    header.caps2 |= 0x200000;
    header.flags |= 0x800000;
    header.depth = depth;
    return header;
}

struct Survival {
    const char* name;
    Header header;
    std::size_t pixelBytes;
    int faces;
    int levels;
    int depth;
    std::vector<std::string> notes;
};

class DdsLies : public testing::TestWithParam<Survival> {};

TEST_P(DdsLies, AreSurvivedAndSaid) {
    const Survival& row = GetParam();
    const Bytes file = ddsFile(row.header, std::vector<int>(row.pixelBytes, 1));
    const Result<TextureImage> texture = decodeDds(file);
    ASSERT_TRUE(texture) << texture.error().message;
    EXPECT_EQ(texture->faces, row.faces);
    EXPECT_EQ(texture->levels, row.levels);
    EXPECT_EQ(depthOf(texture->surfaces.front()), row.depth);
    std::vector<Sentence> said = texture->notes;
    said.insert(said.end(), texture->remarks.begin(), texture->remarks.end());
    EXPECT_THAT(said, testing::UnorderedElementsAreArray(row.notes));

    std::string wrong;
    for (const Field& field : dissectDds(file).fields)
        wrong += field.meaning.english() + field.wrong.english() + "\n"; // by whether it is odd
    for (const std::string& note : row.notes)
        EXPECT_THAT(wrong, testing::HasSubstr(note)) << "the anatomy says it next to the field";
}

const Header dxt1 = legacyDds("DXT1");
const Header rgb = masked(0x40, 24, 0xFF0000, 0xFF00, 0xFF);
using Notes = std::vector<std::string>;

// 8 x 8 texels of DXT1: levels of 32, 8, 8 and 8 bytes.
INSTANTIATE_TEST_SUITE_P(
    All, DdsLies,
    testing::Values(
        Survival{"Nothing", sized(dxt1, 8, 8), 32, 1, 1, 1, {}},
        Survival{"FullChain", sized(dxt1, 8, 8, 4), 56, 1, 4, 1, {}},
        Survival{"PartialChain", sized(dxt1, 8, 8, 2), 40, 1, 2, 1, {}},
        Survival{"CubeMap", cube(sized(dxt1, 8, 8, 4)), 6 * 56, 6, 4, 1, {}},
        Survival{"CubeMapDx10", with(sized(dxgi(71), 8, 8), &Header::miscFlag, 4), 6 * 32, 6, 1, 1, {}},
        // 8 x 8 x 4, 4 x 4 x 2, 2 x 2 x 1, 1 x 1 x 1: 128, 16, 8 and 8 bytes.
        Survival{"Volume", volume(sized(dxt1, 8, 8, 4), 4), 160, 1, 4, 4, {}},
        Survival{
            "VolumeDx10", with(volume(sized(dxgi(71), 8, 8), 4), &Header::dimension, 4), 128, 1, 1, 4, {}},
        Survival{"LineDx10", with(sized(dxgi(28), 8, 1), &Header::dimension, 2), 32, 1, 1, 1, {}},
        Survival{"LineOfSomeHeight",
                 with(sized(dxgi(28), 8, 0), &Header::dimension, 2),
                 32,
                 1,
                 1,
                 1,
                 {"dwHeight of a line is 0 where 1 is expected; it is read as 1"}},
        Survival{"LinearSizeRight",
                 with(with(sized(dxt1, 8, 8), &Header::flags, 0x81007), &Header::pitchOrLinearSize, 32),
                 32,
                 1,
                 1,
                 1,
                 {}},
        Survival{"LinearSizeWrong",
                 with(with(sized(dxt1, 8, 8), &Header::flags, 0x81007), &Header::pitchOrLinearSize, 64),
                 32,
                 1,
                 1,
                 1,
                 {"dwPitchOrLinearSize is 64, but level 0 has 32 bytes; it is ignored"}},
        Survival{"PitchWrong",
                 with(with(sized(rgb, 3, 2), &Header::flags, 0x100F), &Header::pitchOrLinearSize, 12),
                 18,
                 1,
                 1,
                 1,
                 {"dwPitchOrLinearSize is 12, but a row has 9 bytes; it is ignored"}},
        Survival{"MipCountZero",
                 with(sized(dxt1, 8, 8), &Header::flags, 0x21007),
                 32,
                 1,
                 1,
                 1,
                 {"dwMipMapCount is 0 although DDSD_MIPMAPCOUNT is set; one level is read"}},
        Survival{"MipCountWithoutFlag",
                 with(sized(dxt1, 8, 8, 4), &Header::flags, 0x1007),
                 56,
                 1,
                 4,
                 1,
                 {"DDSD_MIPMAPCOUNT is not set although dwMipMapCount is 4; the count is used"}},
        Survival{"MipCountBeyondTheChain",
                 sized(dxt1, 8, 8, 4000000000),
                 56,
                 1,
                 4,
                 1,
                 {"dwMipMapCount is 4000000000, but the chain ends after 4 levels; the others are ignored"}},
        Survival{
            "MipCountBeyondTheFile",
            sized(dxt1, 8, 8, 4),
            47,
            1,
            2,
            1,
            {"dwMipMapCount is 4, which needs 184 bytes; the file has 175 and only levels 0 to 1 are whole"}},
        Survival{"OnlyTheBase",
                 sized(dxt1, 8, 8, 4),
                 32,
                 1,
                 1,
                 1,
                 {"dwMipMapCount is 4, which needs 184 bytes; the file has 160 and only level 0 is whole"}},
        Survival{
            "LastFaceCut",
            cube(sized(dxt1, 8, 8, 4)),
            5 * 56 + 48,
            6,
            3,
            1,
            {"dwMipMapCount is 4, which needs 464 bytes; the file has 456 and only levels 0 to 2 are whole"}},
        Survival{"CubeMapWithFewerLevelsThanItSays",
                 cube(sized(dxt1, 8, 8, 4)),
                 6 * 32,
                 6,
                 1,
                 1,
                 {"dwMipMapCount is 4, but the file holds exactly six faces of 1 level"}},
        Survival{"CubeMapWithoutFaces",
                 cube(sized(dxt1, 8, 8), 0),
                 6 * 32,
                 6,
                 1,
                 1,
                 {"DDSCAPS2_CUBEMAP is set, but no face; it is read as all six"}},
        Survival{"FacesWithoutCubeMap",
                 with(sized(dxt1, 8, 8), &Header::caps2, 0x400),
                 32,
                 1,
                 1,
                 1,
                 {"faces are set although DDSCAPS2_CUBEMAP is not; it is read as one picture"}},
        Survival{"VolumeWithoutDepth",
                 volume(sized(dxt1, 8, 8), 0),
                 32,
                 1,
                 1,
                 1,
                 {"dwDepth of a volume is 0; it is read as one slice"}},
        Survival{
            "VolumeWithoutItsCap",
            with(volume(sized(dxt1, 8, 8), 2), &Header::caps2, 0),
            64,
            1,
            1,
            2,
            {"DDSCAPS2_VOLUME is not set although DDSD_DEPTH is, with 2 slices; it is read as a volume"}},
        Survival{"VolumeWithoutItsFlag",
                 with(volume(sized(dxt1, 8, 8), 2), &Header::flags, 0x1007),
                 64,
                 1,
                 1,
                 2,
                 {"DDSD_DEPTH is not set although it is a volume"}},
        Survival{"DepthOfAPicture",
                 with(sized(dxt1, 8, 8), &Header::depth, 9),
                 32,
                 1,
                 1,
                 1,
                 {"dwDepth is 9 although it is not marked as a volume; it is ignored"}},
        Survival{"NoFlags",
                 with(sized(dxt1, 8, 8), &Header::flags, 0),
                 32,
                 1,
                 1,
                 1,
                 {"dwFlags lacks DDSD_CAPS | DDSD_HEIGHT | DDSD_WIDTH | DDSD_PIXELFORMAT; the fields are "
                  "used anyway"}},
        Survival{"FormatSize",
                 with(sized(dxt1, 8, 8), &Header::formatSize, 24),
                 32,
                 1,
                 1,
                 1,
                 {"ddspf.dwSize is 24 where 32 is expected; it is ignored"}},
        Survival{"FourCCWithoutItsFlag",
                 with(sized(dxt1, 8, 8), &Header::formatFlags, 0),
                 32,
                 1,
                 1,
                 1,
                 {"DDPF_FOURCC is not set although dwFourCC is \"DXT1\"; dwFourCC is used"}},
        Survival{"FlagWithoutFourCC",
                 with(sized(rgb, 1, 1), &Header::formatFlags, 0x44),
                 3,
                 1,
                 1,
                 1,
                 {"DDPF_FOURCC is set, but dwFourCC is 0; the masks are used instead"}},
        Survival{"NoKindOfPixel",
                 with(sized(rgb, 1, 1), &Header::formatFlags, 0),
                 3,
                 1,
                 1,
                 1,
                 {"neither DDPF_RGB nor another kind of pixel is set; the masks are used as RGB"}},
        Survival{"AlphaFlagWithoutMask",
                 with(sized(rgb, 1, 1), &Header::formatFlags, 0x41),
                 3,
                 1,
                 1,
                 1,
                 {"DDPF_ALPHAPIXELS is set, but dwABitMask is 0; read without alpha"}},
        Survival{"MaskWithoutAlphaFlag",
                 masked(0x40, 32, 0xFF0000, 0xFF00, 0xFF, 0xFF000000),
                 4,
                 1,
                 1,
                 1,
                 {"DDPF_ALPHAPIXELS is not set although dwABitMask is 0xFF000000; read without alpha"}},
        Survival{"MaskBeyondThePixel",
                 masked(0x40, 16, 0xFF0000, 0xFF00, 0xFF),
                 2,
                 1,
                 1,
                 1,
                 {"dwRBitMask is 0x00FF0000, beyond the 16 bits of a pixel; those bits are ignored"}},
        Survival{"LuminanceWithoutMask",
                 masked(0x20000, 8, 0, 0, 0),
                 1,
                 1,
                 1,
                 1,
                 {"dwRBitMask is 0; all bits but alpha's are the luminance"}},
        Survival{"AlphaWithoutMask",
                 masked(0x2, 8, 0, 0, 0),
                 1,
                 1,
                 1,
                 1,
                 {"dwABitMask is 0; all bits of a pixel are its alpha"}},
        Survival{"Premultiplied",
                 sized(legacyDds("DXT4"), 4, 4),
                 16,
                 1,
                 1,
                 1,
                 {"DXT4: the colours are multiplied by alpha"}},
        Survival{"Typeless",
                 sized(dxgi(27), 1, 1),
                 4,
                 1,
                 1,
                 1,
                 {"DXGI_FORMAT_R8G8B8A8_TYPELESS does not define its bits; read as UNORM"}},
        Survival{"ArrayOfNone",
                 with(dxgi(28), &Header::arraySize, 0),
                 4,
                 1,
                 1,
                 1,
                 {"arraySize is 0; it is read as 1"}},
        Survival{"Array",
                 with(dxgi(28), &Header::arraySize, 3),
                 12,
                 1,
                 1,
                 1,
                 {"it is an array of 3 textures; scenes show the first"}},
        Survival{
            "ArrayWithABitMore",
            with(dxgi(28), &Header::arraySize, 3),
            13,
            1,
            1,
            1,
            {"it is an array of 3 textures; scenes show the first", "1 byte after the last level: ignored"}},
        Survival{"ArrayWithoutADimension",
                 with(with(dxgi(28), &Header::dimension, 0), &Header::arraySize, 2),
                 8,
                 1,
                 1,
                 1,
                 {"resourceDimension is 0, which is not a texture; dwCaps2 is used instead",
                  "it is an array of 2 textures; scenes show the first"}},
        Survival{"ArrayOfCubeMaps",
                 with(with(dxgi(28), &Header::miscFlag, 4), &Header::arraySize, 2),
                 48,
                 6,
                 1,
                 1,
                 {"it is an array of 2 cube maps; scenes show the first"}},
        Survival{"NoDimension",
                 with(dxgi(28), &Header::dimension, 0),
                 4,
                 1,
                 1,
                 1,
                 {"resourceDimension is 0, which is not a texture; dwCaps2 is used instead"}},
        Survival{"AlphaMode",
                 dxgi(28, 7),
                 4,
                 1,
                 1,
                 1,
                 {"miscFlags2 has alpha mode 7, which doesn't exist; the meaning of alpha is unknown"}},
        Survival{"Tail", sized(dxt1, 8, 8), 33, 1, 1, 1, {"1 byte after the last level: ignored"}}),
    [](const auto& test) { return std::string(test.param.name); });

struct Refusal {
    const char* name;
    Header header;
    std::size_t pixelBytes;
    ErrorCode code;
    const char* message;
};

class DdsRefusals : public testing::TestWithParam<Refusal> {};

TEST_P(DdsRefusals, SayWhatWasExpectedAndWhatWasFound) {
    const Refusal& row = GetParam();
    const Bytes file = ddsFile(row.header, std::vector<int>(row.pixelBytes, 1));
    const Result<TextureImage> texture = decodeDds(file);
    ASSERT_FALSE(texture);
    EXPECT_EQ(texture.error().message, row.message);
    EXPECT_EQ(texture.error().code, row.code);
    const bool isWhole = std::string_view(row.name) == "Bc7"; // and known, so that its anatomy has its levels
    EXPECT_EQ(dissectDds(file).damage, isWhole ? "" : row.message);
}

INSTANTIATE_TEST_SUITE_P(
    All, DdsRefusals,
    testing::Values(
        Refusal{"HeaderSize", with(dxt1, &Header::size, 100), 8, Malformed,
                "DDS: a header has 124 bytes, dwSize is 100"},
        Refusal{"BaseCut", sized(dxt1, 8, 8, 4), 31, Malformed,
                "DDS: level 0 needs 32 bytes from offset 128, the file has 159"},
        // Six chains of 1431655764 bytes: modulo 2^32 they would end before the header does.
        Refusal{"MoreThan32Bits", cube(sized(masked(0x40, 32, 0xFF0000, 0xFF00, 0xFF), 16384, 16384, 15)), 0,
                Malformed,
                "DDS: level 0 of face +x needs 1073741824 bytes from offset 128, the file has 128"},
        Refusal{"FaceCut", cube(sized(dxt1, 8, 8, 4)), 5 * 56 + 31, Malformed,
                "DDS: level 0 of face -z needs 32 bytes from offset 408, the file has 439"},
        Refusal{"SecondFaceMissing", cube(sized(dxt1, 8, 8)), 32, Malformed,
                "DDS: level 0 of face -x needs 32 bytes from offset 160, the file has 160"},
        Refusal{"VolumeCut", volume(sized(dxt1, 8, 8), 3), 95, Malformed,
                "DDS: level 0 needs 96 bytes from offset 128, the file has 223"},
        Refusal{"NoWidth", sized(dxt1, 0, 8), 8, Malformed,
                "DDS: a picture has at least 1 × 1 texels, this one says 0 × 8"},
        Refusal{"TooWide", sized(dxt1, 4294967295, 1), 8, TooLarge,
                "DDS: at most 16384 texels along each axis are read, the file has 4294967295 × 1"},
        Refusal{"TooDeep", volume(sized(dxt1, 16384, 16384), 2), 8, TooLarge,
                "DDS: at most 268435456 texels are read, the file has 16384 × 16384 × 2"},
        Refusal{"Lying", sized(dxt1, 16384, 16384), 8, Malformed,
                "DDS: level 0 needs 134217728 bytes from offset 128, the file has 136"},
        Refusal{"PartialCubeMap", cube(sized(dxt1, 8, 8), 0x1400), 64, Unsupported,
                "DDS: cube maps with all six faces are read, this one has 2: DDSCAPS2_CUBEMAP_POSITIVEX | "
                "DDSCAPS2_CUBEMAP_POSITIVEY"},
        Refusal{"OblongCubeMap", cube(sized(dxt1, 8, 4)), 96, Malformed,
                "DDS: the faces of a cube map are square, these are 8 × 4"},
        Refusal{"CubeMapOfVolumes", with(with(dxgi(28), &Header::miscFlag, 4), &Header::dimension, 4), 24,
                Malformed, "DDS: miscFlag means a cube map, but resourceDimension does not"},
        Refusal{"ArrayCutInItsFirst", with(sized(dxgi(28), 2, 2), &Header::arraySize, 3), 15, Malformed,
                "DDS: an array of 3 textures needs 196 bytes, the file has 163"},
        Refusal{"ArrayCutBehindItsFirst", with(dxgi(28), &Header::arraySize, 3), 11, Malformed,
                "DDS: an array of 3 textures needs 160 bytes, the file has 159"},
        Refusal{"ArrayOfMany", with(sized(dxgi(28), 16384, 1), &Header::arraySize, 0xFFFFFFFF), 65536,
                Malformed,
                "DDS: an array of 4294967295 textures needs 281474976645268 bytes, the file has 65684"},
        // 6 * 715827883 is 2 more than 32 bits hold.
        Refusal{"CubeMapsOfMany", with(with(dxgi(28), &Header::miscFlag, 4), &Header::arraySize, 715827883),
                24, Malformed,
                "DDS: an array of 715827883 cube maps needs 17179869340 bytes, the file has 172"},
        Refusal{"DepthWithoutAMask", masked(0x400, 16, 0, 0, 0), 2, Malformed,
                "DDS: DDPF_ZBUFFER is set, but the mask of the depth, dwGBitMask, is 0"},
        Refusal{"CutBc7", sized(dxgi(98), 4, 4), 15, Malformed,
                "DDS: level 0 needs 16 bytes from offset 148, the file has 163"},
        Refusal{
            "FourCC", legacyDds("BC7L"), 16, Unsupported,
            "DDS: dwFourCC is \"BC7L\"; DXT1, DXT2, DXT3, DXT4, DXT5, ATI1, BC4U, BC4S, ATI2, BC5U, BC5S, "
            "DX10 are read"},
        Refusal{
            "FloatingPoint", with(dxt1, &Header::fourCC, 113), 16, Unsupported,
            "DDS: dwFourCC is 0x00000071; DXT1, DXT2, DXT3, DXT4, DXT5, ATI1, BC4U, BC4S, ATI2, BC5U, BC5S, "
            "DX10 are read"},
        Refusal{
            "Bc7", dxgi(98), 16, Unsupported,
            "DDS: DXGI_FORMAT_BC7_UNORM is not read; BC1 to BC5 and unsigned formats of at most 32 bits a "
            "pixel are"},
        Refusal{"NoDxgi", dxgi(500), 16, Malformed, "DDS: DXGI formats are 1 to 191, dxgiFormat is 500"},
        Refusal{"Dxgi", dxgi(3), 16, Unsupported,
                "DDS: DXGI format 3 is not read; BC1 to BC5 and unsigned formats of at most 32 bits a pixel "
                "are"},
        Refusal{
            "Palette", masked(0x20, 8, 0, 0, 0), 2000, Unsupported,
            "DDS: pixels with DDPF_PALETTEINDEXED8 are not read; RGB, luminance, alpha, depth and compressed ones "
            "are"},
        Refusal{"Bits", masked(0x40, 64, 0xFF, 0xFF00, 0xFF0000), 8, Unsupported,
                "DDS: 8, 16, 24 or 32 bits a pixel are read, dwRGBBitCount is 64"},
        Refusal{"NoMasks", masked(0x40, 24, 0, 0, 0), 3, Malformed,
                "DDS: the masks of red, green and blue are all 0"}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(DdsHeaders, AreNeededWhole) {
    const Bytes file = ddsFile(dxgi(28), {1, 2, 3, 4});
    const auto messageOf = [&](std::size_t size) {
        const Result<TextureImage> texture =
            decodeDds(Bytes(file.begin(), file.begin() + std::ptrdiff_t(size)));
        return texture ? "" : texture.error().message;
    };
    EXPECT_EQ(messageOf(0), "DDS: the file is empty");
    EXPECT_EQ(messageOf(3), "DDS: the file does not begin with \"DDS \"");
    EXPECT_EQ(messageOf(4), "DDS: the headers need 128 bytes, the file has 4");
    EXPECT_EQ(messageOf(127), "DDS: the headers need 128 bytes, the file has 127");
    EXPECT_EQ(messageOf(128), "DDS: the headers need 148 bytes with the DX10 one, the file has 128");
    EXPECT_EQ(messageOf(151), "DDS: level 0 needs 4 bytes from offset 148, the file has 151");
    EXPECT_EQ(messageOf(152), "");
}

TEST(DdsHeaders, LimitsAreTheCallersToSay) {
    const Bytes file = ddsFile(cube(sized(masked(0x20000, 8, 0xFF, 0, 0), 2, 2, 2)), std::vector<int>(30, 1));
    EXPECT_TRUE(decodeDds(file, {.maxExtent = 2, .maxPixels = 4, .maxBytes = 30}));
    for (const DecodeLimits limits : {DecodeLimits{.maxExtent = 1}, DecodeLimits{.maxPixels = 3},
                                      DecodeLimits{.maxBytes = 29}, DecodeLimits{.maxExtent = -1}}) {
        const Result<TextureImage> refused = decodeDds(file, limits);
        ASSERT_FALSE(refused);
        EXPECT_EQ(refused.error().code, TooLarge);
    }
}

TEST(DdsHeaders, NoLimitAtAllIsNoOverflow) {
    const Bytes file = ddsFile(volume(sized(dxt1, 0x7FFFFFFF, 0x7FFFFFFF), 0x7FFFFFFF), {});
    const DecodeLimits none{.maxExtent = 0x7FFFFFFF, .maxPixels = SIZE_MAX, .maxBytes = SIZE_MAX};
    const Result<TextureImage> refused = decodeDds(file, none);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, TooLarge);
}

} // namespace
} // namespace texplorer::dds_headers_test

#include "tests/core/codec/dds/dds_files.h"
#include "texplorer/codec/dds/dds.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace texplorer::dds_anatomy_test {
namespace {

using test::ddsFile;

/// A cube map of 8 x 8 texels with all levels: as the DirectX SDK's texture tool writes it.
dds::Header cubeHeader() {
    dds::Header header = test::legacyDds("DXT1");
    header.flags = 0xA1007;
    header.width = header.height = 8;
    header.pitchOrLinearSize = 32;
    header.mipMapCount = 4;
    header.caps = 0x401008;
    header.caps2 = 0xFE00;
    return header;
}

const Field& fieldOf(const Anatomy& anatomy, std::string_view name) {
    const auto found = std::ranges::find(anatomy.fields, Sentence(name), &Field::name);
    if (found == anatomy.fields.end())
        throw std::out_of_range(std::string(name));
    return *found;
}

struct FieldCase {
    const char* name;
    const char* field;
    std::size_t offset;
    std::size_t size;
    const char* value;
};

class DdsFields : public testing::TestWithParam<FieldCase> {};

// The offsets are those of DDS_HEADER, DDS_PIXELFORMAT and DDS_HEADER_DXT10 in Microsoft's documentation.
TEST_P(DdsFields, AreWhereTheSpecificationPutsThem) {
    const FieldCase& row = GetParam();
    const bool extended = row.offset >= 128 && row.size == 4;
    dds::Header dx10 = test::dxgi(72, 1);
    dx10.miscFlag = 4;
    const Anatomy anatomy = extended ? dissectDds(ddsFile(dx10, std::vector<int>(48)))
                                     : dissectDds(ddsFile(cubeHeader(), std::vector<int>(6 * 56)));
    const Field& field = fieldOf(anatomy, row.field);
    EXPECT_EQ(field.offset, row.offset);
    EXPECT_EQ(field.size, row.size);
    EXPECT_EQ(field.value, row.value);
    EXPECT_NE(field.meaning, "");
    EXPECT_EQ(field.wrong, "");
    EXPECT_EQ(anatomy.damage, "");
    EXPECT_EQ(anatomy.format, "DDS");
}

INSTANTIATE_TEST_SUITE_P(
    All, DdsFields,
    testing::Values(
        FieldCase{"Magic", "dwMagic", 0, 4, "\"DDS \""}, FieldCase{"Header", "DDS_HEADER", 4, 124, ""},
        FieldCase{"Size", "dwSize", 4, 4, "124"},
        FieldCase{"Flags", "dwFlags", 8, 4,
                  "0x000A1007: DDSD_CAPS | DDSD_HEIGHT | DDSD_WIDTH | DDSD_PIXELFORMAT | DDSD_MIPMAPCOUNT | "
                  "DDSD_LINEARSIZE"},
        FieldCase{"Height", "dwHeight", 12, 4, "8"}, FieldCase{"Width", "dwWidth", 16, 4, "8"},
        FieldCase{"LinearSize", "dwPitchOrLinearSize", 20, 4, "32"},
        FieldCase{"Depth", "dwDepth", 24, 4, "0"}, FieldCase{"Levels", "dwMipMapCount", 28, 4, "4"},
        FieldCase{"Reserved", "dwReserved1", 32, 44, "zeros"},
        FieldCase{"PixelFormat", "DDS_PIXELFORMAT", 76, 32, ""},
        FieldCase{"FormatSize", "ddspf.dwSize", 76, 4, "32"},
        FieldCase{"FormatFlags", "ddspf.dwFlags", 80, 4, "0x00000004: DDPF_FOURCC"},
        FieldCase{"FourCC", "ddspf.dwFourCC", 84, 4, "\"DXT1\""},
        FieldCase{"BitCount", "ddspf.dwRGBBitCount", 88, 4, "0"},
        FieldCase{"Red", "ddspf.dwRBitMask", 92, 4, "0x00000000"},
        FieldCase{"Alpha", "ddspf.dwABitMask", 104, 4, "0x00000000"},
        FieldCase{"Caps", "dwCaps", 108, 4, "0x00401008: DDSCAPS_COMPLEX | DDSCAPS_TEXTURE | DDSCAPS_MIPMAP"},
        FieldCase{"Caps2", "dwCaps2", 112, 4,
                  "0x0000FE00: DDSCAPS2_CUBEMAP | DDSCAPS2_CUBEMAP_POSITIVEX | DDSCAPS2_CUBEMAP_NEGATIVEX | "
                  "DDSCAPS2_CUBEMAP_POSITIVEY | DDSCAPS2_CUBEMAP_NEGATIVEY | DDSCAPS2_CUBEMAP_POSITIVEZ | "
                  "DDSCAPS2_CUBEMAP_NEGATIVEZ"},
        FieldCase{"Reserved2", "dwReserved2", 124, 4, "0"}, FieldCase{"Pixels", "pixel data", 128, 336, ""},
        FieldCase{"FirstLevel", "face +x, level 0", 128, 32, "8 × 8"},
        FieldCase{"SecondFace", "face -x, level 1", 216, 8, "4 × 4"},
        FieldCase{"LastLevel", "face -z, level 3", 456, 8, "1 × 1"},
        FieldCase{"DxgiFormat", "dxgiFormat", 128, 4, "72: DXGI_FORMAT_BC1_UNORM_SRGB"},
        FieldCase{"Dimension", "resourceDimension", 132, 4, "3: D3D10_RESOURCE_DIMENSION_TEXTURE2D"},
        FieldCase{"MiscFlag", "miscFlag", 136, 4, "0x00000004: DDS_RESOURCE_MISC_TEXTURECUBE"},
        FieldCase{"ArraySize", "arraySize", 140, 4, "1"},
        FieldCase{"MiscFlags2", "miscFlags2", 144, 4, "1: DDS_ALPHA_MODE_STRAIGHT"}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(DdsAnatomy, MasksAreExplainedByTheirBits) {
    const Anatomy anatomy = dissectDds(ddsFile(test::masked(0x41, 16, 0x7C00, 0x3E0, 0x1B, 0x8000), {0, 0}));
    EXPECT_EQ(fieldOf(anatomy, "ddspf.dwRBitMask").meaning, "red in bits 10 to 14");
    EXPECT_EQ(fieldOf(anatomy, "ddspf.dwBBitMask").meaning, "blue in bits 0 to 4, with holes");
    EXPECT_EQ(fieldOf(anatomy, "ddspf.dwABitMask").meaning, "alpha in bit 15");
}

TEST(DdsAnatomy, GoesOnToThePointOfDamage) {
    const Bytes file = ddsFile(cubeHeader(), std::vector<int>(6 * 56));
    const auto cut = [&](std::size_t size) {
        return dissectDds(Bytes(file.begin(), file.begin() + static_cast<std::ptrdiff_t>(size)));
    };
    const Anatomy header = cut(90);
    EXPECT_EQ(header.damage, "DDS: the headers need 128 bytes, the file has 90");
    EXPECT_EQ(fieldOf(header, "DDS_HEADER").wrong, "it needs 124 bytes, the file has 86 of them");
    EXPECT_EQ(fieldOf(header, "dwWidth").value, "8");
    EXPECT_EQ(fieldOf(header, "ddspf.dwFourCC").wrong, "");
    EXPECT_EQ(fieldOf(header, "ddspf.dwRGBBitCount").value, "") << "two of its four bytes are there";
    EXPECT_EQ(fieldOf(header, "ddspf.dwRGBBitCount").wrong, "it ends at offset 92, the file at 90");

    const Anatomy base = cut(140);
    EXPECT_EQ(base.damage, "DDS: level 0 of face +x needs 32 bytes from offset 128, the file has 140");
    EXPECT_EQ(fieldOf(base, "face +x, level 0").wrong, "it ends at offset 160, the file at 140");

    const Anatomy tip = cut(463);
    EXPECT_EQ(tip.damage, "DDS: the last level ends at offset 464, the file at 463");
    EXPECT_EQ(fieldOf(tip, "face -z, level 2").wrong, "");
    EXPECT_EQ(fieldOf(tip, "face -z, level 3").wrong, "it ends at offset 464, the file at 463");
}

TEST(DdsAnatomy, AMagicNumberAndASizeThatAreWrongAreSaid) {
    Bytes file = ddsFile(cubeHeader(), std::vector<int>(6 * 56));
    file[3] = std::byte{'X'};
    file[4] = std::byte{0};
    const Anatomy anatomy = dissectDds(file);
    EXPECT_EQ(fieldOf(anatomy, "dwMagic").wrong, "expected \"DDS \"");
    EXPECT_EQ(fieldOf(anatomy, "dwSize").wrong, "expected 124");
    EXPECT_EQ(anatomy.damage, "DDS: the file does not begin with \"DDS \"");
}

} // namespace
} // namespace texplorer::dds_anatomy_test

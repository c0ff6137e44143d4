#include "texplorer/codec/bmp/bmp.h"
#include "texplorer/codec/registry.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace texplorer::bmp_anatomy_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Little-endian numbers of the given sizes: {{4, 40}, {2, 1}}.
Bytes numbers(std::initializer_list<std::pair<int, std::int64_t>> values) {
    Bytes bytes;
    for (const auto& [size, value] : values)
        for (int i = 0; i < size; ++i)
            bytes.push_back(static_cast<std::byte>(value >> (8 * i)));
    return bytes;
}

/// 3 x 2 pixels of 4 bits, two palette entries, at offset 62; 70 bytes.
Bytes indexedFile() {
    return numbers({{2, 'B' | 'M' << 8},
                    {4, 70},
                    {2, 0},
                    {2, 0},
                    {4, 62},
                    {4, 40},
                    {4, 3},
                    {4, 2},
                    {2, 1},
                    {2, 4},
                    {4, 0},
                    {4, 8},
                    {4, 2835},
                    {4, -1},
                    {4, 2},
                    {4, 0},
                    {4, 0xFF8000},
                    {4, 0x102030},
                    {4, 0x1001},
                    {4, 0}});
}

Field fieldNamed(const Anatomy& anatomy, const std::string& name) {
    for (const Field& field : anatomy.fields)
        if (field.name == name)
            return field;
    ADD_FAILURE() << "there is no field " << name;
    return {};
}

std::vector<std::string> sections(const Anatomy& anatomy) {
    std::vector<std::string> lines;
    for (const Field& field : anatomy.fields)
        if (field.depth == 0)
            lines.push_back(std::to_string(field.offset) + "+" + std::to_string(field.size) + " " +
                            field.name.english());
    return lines;
}

std::vector<std::string> complaints(const Anatomy& anatomy) {
    std::vector<std::string> lines;
    for (const Field& field : anatomy.fields)
        if (!field.wrong.empty())
            lines.push_back(field.name.english() + ": " + field.wrong.english());
    return lines;
}

void put(Bytes& file, std::size_t offset, const std::vector<int>& bytes) {
    for (const int byte : bytes)
        file.at(offset++) = static_cast<std::byte>(byte);
}

TEST(BmpAnatomy, NamesEveryByteOfAGoodFile) {
    const Bytes file = indexedFile();
    ASSERT_EQ(file.size(), 70U);
    const Anatomy anatomy = dissectBmp(file);
    EXPECT_EQ(anatomy.format, "BMP");
    EXPECT_EQ(anatomy.damage, "");
    EXPECT_THAT(complaints(anatomy), IsEmpty());
    EXPECT_THAT(sections(anatomy), ElementsAre("0+14 File header", "14+40 BITMAPINFOHEADER (Windows 3)",
                                               "54+8 Palette", "62+6 Pixel data"));
    EXPECT_EQ(fieldNamed(anatomy, "bfType").value, "\"BM\"");
    EXPECT_EQ(fieldNamed(anatomy, "biWidth").value, "3");
    EXPECT_EQ(fieldNamed(anatomy, "biWidth").offset, 18U);
    EXPECT_EQ(fieldNamed(anatomy, "biYPelsPerMeter").value, "-1");
    EXPECT_EQ(fieldNamed(anatomy, "biCompression").value, "0, none");
    EXPECT_EQ(fieldNamed(anatomy, "entry 0").value, "#ff8000");
    EXPECT_EQ(fieldNamed(anatomy, "Pixel data").value, "2 rows of 2 bytes");
    EXPECT_EQ(dissect(file).fields.size(), anatomy.fields.size()) << "by way of the registry";

    // The fields of a section follow each other without a hole.
    std::uint64_t next = 0;
    for (const Field& field : anatomy.fields) {
        if (field.depth == 0) {
            next = field.offset;
            continue;
        }
        EXPECT_EQ(field.offset, next) << field.name;
        next = field.offset + field.size;
    }
}

struct Spoilt {
    const char* name;
    std::size_t offset;
    std::vector<int> bytes;
    const char* complaint;
};

class BmpAnatomyComplaints : public testing::TestWithParam<Spoilt> {};

TEST_P(BmpAnatomyComplaints, SayWhatLooksWrong) {
    Bytes file = indexedFile();
    put(file, GetParam().offset, GetParam().bytes);
    EXPECT_THAT(complaints(dissectBmp(file)), testing::Contains(GetParam().complaint));
}

INSTANTIATE_TEST_SUITE_P(
    All, BmpAnatomyComplaints,
    testing::Values(
        Spoilt{"Magic", 1, {'A'}, "bfType: expected \"BM\""},
        Spoilt{"FileSize", 2, {71}, "bfSize: the file has 70 bytes"},
        Spoilt{"Reserved", 8, {1}, "bfReserved2: expected 0"},
        Spoilt{"DataPos0", 10, {0}, "bfOffBits: expected 62, which is used instead"},
        Spoilt{"DataPosLow", 10, {20}, "bfOffBits: lies within the headers, which end at 54"},
        Spoilt{"DataPosFar", 10, {200}, "bfOffBits: the file has 70 bytes"},
        Spoilt{"HeaderSize", 14, {65}, "biSize: expected 12, 16 to 64, 108 or 124"},
        Spoilt{"Width", 18, {0}, "biWidth: expected at least 1"},
        Spoilt{"Planes", 26, {2}, "biPlanes: expected 1"},
        Spoilt{"Depth", 28, {5}, "biBitCount: expected 1, 4, 8, 16, 24 or 32"},
        Spoilt{"Rle8", 30, {1}, "biCompression: needs 8 bits a pixel, the file has 4"},
        Spoilt{"Compression", 30, {9}, "biCompression: expected 0 to 6"},
        Spoilt{"ImageSize", 34, {7}, "biSizeImage: the pixels need 8 bytes"},
        Spoilt{"Colors", 46, {17}, "biClrUsed: 4 bits a pixel can index 16 entries"},
        Spoilt{"ColorsRoom", 46, {3}, "Palette: expected 3 entries, but there is space for 2"},
        Spoilt{"Important", 50, {3}, "biClrImportant: more than the 2 available"},
        Spoilt{"NoPalette", 10, {54}, "Palette: 4 bits a pixel need one, the pixels begin at offset 54"}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(BmpAnatomy, GoesOnToThePointOfDamage) {
    Bytes file = indexedFile();
    file.resize(67);
    EXPECT_EQ(dissectBmp(file).damage, "Pixel data needs 6 bytes from offset 62, the file has 67");
    EXPECT_EQ(sections(dissectBmp(file)).size(), 4U);
    file.resize(20);
    EXPECT_EQ(dissectBmp(file).damage, "biWidth needs 4 bytes from offset 18, the file has 20");
    EXPECT_EQ(dissectBmp({}).damage, "bfType needs 2 bytes from offset 0, the file has 0");
    file = indexedFile();
    put(file, 14, {200});
    EXPECT_THAT(dissectBmp(file).damage, HasSubstr("this one has 200"));
}

TEST(BmpAnatomy, CountsRunLengthCodes) {
    Bytes file = indexedFile(); // 3 x 2: a run, the next row, a delta, then two codes that go on too far
    put(file, 30, {2});
    file.resize(62);
    const Bytes codes = numbers({{2, 0x1003}, {2, 0}, {2, 0x0200}, {2, 1}, {2, 0x1009}, {2, 0x0300}, {2, 0}});
    file.insert(file.end(), codes.begin(), codes.end());
    Anatomy anatomy = dissectBmp(file);
    EXPECT_EQ(fieldNamed(anatomy, "Pixel data").value, "RLE4: 2 runs, 1 literal, 1 delta");
    EXPECT_EQ(fieldNamed(anatomy, "Pixel data").meaning, "they set 5 of 6 pixels");
    EXPECT_EQ(fieldNamed(anatomy, "Pixel data").wrong, "2 codes continue beyond the end of a row");
    EXPECT_EQ(anatomy.damage, "") << "nothing is missing";

    file.resize(66);
    anatomy = dissectBmp(file);
    EXPECT_EQ(anatomy.damage,
              "the run-length codes end at offset 66 within row 2 of 2, without an end-of-picture code");
}

TEST(BmpAnatomy, ReadsMasksBehindAHeader) {
    Bytes file = numbers({{2, 'B' | 'M' << 8},
                          {4, 70},
                          {4, 0},
                          {4, 66},
                          {4, 40},
                          {4, 2},
                          {4, -1},
                          {2, 1},
                          {2, 16},
                          {4, 3},
                          {4, 4},
                          {4, 0},
                          {4, 0},
                          {4, 0},
                          {4, 0},
                          {4, 0xF800},
                          {4, 0x7E0},
                          {4, 0x2001F},
                          {4, 0}});
    const Anatomy anatomy = dissectBmp(file);
    EXPECT_THAT(sections(anatomy), ElementsAre("0+14 File header", "14+40 BITMAPINFOHEADER (Windows 3)",
                                               "54+12 Masks", "66+4 Pixel data"));
    EXPECT_EQ(fieldNamed(anatomy, "red mask").value, "0x0000f800, 5 bits from bit 11");
    EXPECT_THAT(complaints(anatomy), ElementsAre("blue mask: its bits are not contiguous"));
    EXPECT_THAT(fieldNamed(anatomy, "Pixel data").meaning, HasSubstr("top row first"));
}

TEST(BmpAnatomy, SumsUpALongPalette) {
    const Result<Bytes> file =
        encodeBmp(textureOf(Image{PixelFormat::Luminance8, 1, 1, 1, Bytes(1)}, "BMP"), {});
    ASSERT_TRUE(file);
    const Anatomy anatomy = dissectBmp(*file);
    EXPECT_EQ(fieldNamed(anatomy, "Palette").value, "256 entries");
    EXPECT_EQ(fieldNamed(anatomy, "entries 8 to 254").value, "247 more");
    EXPECT_EQ(fieldNamed(anatomy, "entry 255").value, "#ffffff");
    EXPECT_EQ(fieldNamed(anatomy, "entry 255").offset, 54U + 255 * 4);
}

TEST(BmpAnatomy, KnowsEveryHeader) {
    for (const auto& [size, name, last] : {std::tuple{12, "BITMAPCOREHEADER (OS/2 1.x)", "bcBitCount"},
                                           {16, "BITMAPINFOHEADER2 (OS/2 2.x)", "cBitCount"},
                                           {64, "BITMAPINFOHEADER2 (OS/2 2.x)", "ulIdentifier"},
                                           {40, "BITMAPINFOHEADER (Windows 3)", "biClrImportant"},
                                           {52, "BITMAPV2INFOHEADER", "biBlueMask"},
                                           {56, "BITMAPV3INFOHEADER", "biAlphaMask"},
                                           {108, "BITMAPV4HEADER", "bV4GammaBlue"},
                                           {124, "BITMAPV5HEADER", "bV5Reserved"}}) {
        Bytes file = numbers({{2, 'B' | 'M' << 8}, {4, 0}, {4, 0}, {4, 0}, {4, size}});
        file.resize(14 + static_cast<std::size_t>(size), std::byte{0});
        const Anatomy anatomy = dissectBmp(file);
        EXPECT_EQ(sections(anatomy).at(1), "14+" + std::to_string(size) + " " + name);
        const Field field = fieldNamed(anatomy, last);
        EXPECT_EQ(field.offset + field.size, file.size()) << last;
    }
}

} // namespace
} // namespace texplorer::bmp_anatomy_test

#include "tests/support/tga_recipe.h"
#include "texplorer/codec/tga/tga.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace texplorer::tga_anatomy_test {
namespace {

using test::fileOf;
using test::withAttributesType;
using testing::ElementsAre;
using testing::HasSubstr;

const Field& fieldNamed(const Anatomy& anatomy, std::string_view name) {
    const auto found = std::ranges::find(anatomy.fields, Sentence(name), &Field::name);
    if (found == anatomy.fields.end())
        throw std::runtime_error("no field " + std::string(name));
    return *found;
}

std::vector<std::string> sectionsOf(const Anatomy& anatomy) {
    std::vector<std::string> names;
    for (const Field& field : anatomy.fields)
        if (field.depth == 0)
            names.push_back(field.name.english() + " at " + std::to_string(field.offset) + ", " +
                            std::to_string(field.size));
    return names;
}

TEST(TgaAnatomy, ListsEveryPartInFileOrder) {
    const Bytes file = withAttributesType(fileOf({.type = 1,
                                                  .width = 3,
                                                  .height = 2,
                                                  .depth = 8,
                                                  .descriptor = 0x21,
                                                  .firstEntry = 7,
                                                  .entries = 2,
                                                  .entryBits = 16,
                                                  .data = {0xE0, 0x83, 0x1F, 0x00, 7, 8, 7, 8, 7, 8}}),
                                          4);
    const Anatomy anatomy = dissectTga(file);
    EXPECT_EQ(anatomy.format, "TGA");
    EXPECT_EQ(anatomy.damage, "");
    EXPECT_THAT(sectionsOf(anatomy),
                ElementsAre("Header at 0, 18", "Color Map Data at 18, 4", "Image Data at 22, 6",
                            "Extension Area at 28, 495", "Footer at 523, 26"));
    for (const Field& field : anatomy.fields)
        EXPECT_EQ(field.wrong, "") << field.name;
    EXPECT_EQ(fieldNamed(anatomy, "Image Type").value, "1");
    EXPECT_EQ(fieldNamed(anatomy, "Image Type").meaning, "colour-mapped");
    EXPECT_EQ(fieldNamed(anatomy, "Image Width").offset, 12U);
    EXPECT_EQ(fieldNamed(anatomy, "Image Width").value, "3");
    EXPECT_EQ(fieldNamed(anatomy, "Image Descriptor").value, "0x21");
    EXPECT_EQ(fieldNamed(anatomy, "Image Descriptor").meaning,
              "1 attribute bits, first pixel at the top left");
    EXPECT_EQ(fieldNamed(anatomy, "Entry 7").value, "red 0, green 31, blue 0, alpha 1 of 31");
    EXPECT_EQ(fieldNamed(anatomy, "Entry 8").value, "red 0, green 0, blue 31, alpha 0 of 31");
    EXPECT_EQ(fieldNamed(anatomy, "Attributes Type").offset, 28U + 494);
    EXPECT_EQ(fieldNamed(anatomy, "Attributes Type").meaning, "premultiplied alpha");
    EXPECT_EQ(fieldNamed(anatomy, "Extension Area Offset").value, "28");
}

TEST(TgaAnatomy, FieldsLieWithinTheirSections) {
    const Bytes file = withAttributesType(
        fileOf({.type = 10, .width = 4, .depth = 24, .data = {0x80, 1, 2, 3, 2, 1, 2, 3, 4, 5, 6, 7, 8, 9}}),
        0);
    std::uint64_t begin = 0;
    std::uint64_t end = 0;
    for (const Field& field : dissectTga(file).fields) {
        if (field.depth == 0) {
            EXPECT_GE(field.offset, end) << field.name;
            begin = field.offset;
            end = field.offset + field.size;
        } else {
            EXPECT_GE(field.offset, begin) << field.name;
            EXPECT_LE(field.offset + field.size, end) << field.name;
            begin = field.offset + field.size;
        }
    }
    EXPECT_EQ(end, file.size());
}

TEST(TgaAnatomy, DescribesPacketsAndWhereTheyBreakOff) {
    Bytes file =
        fileOf({.type = 10, .width = 4, .height = 2, .data = {0x84, 1, 2, 3, 2, 1, 2, 3, 4, 5, 6, 7, 8, 9}});
    const Anatomy whole = dissectTga(file);
    EXPECT_EQ(whole.damage, "");
    EXPECT_EQ(fieldNamed(whole, "Packet 0").value, "5 times the same pixel");
    EXPECT_THAT(fieldNamed(whole, "Packet 0").wrong, HasSubstr("beyond the end of its row"));
    EXPECT_EQ(fieldNamed(whole, "Packet 1").value, "3 raw pixels");
    EXPECT_EQ(fieldNamed(whole, "Packet 1").offset, 22U);
    EXPECT_EQ(fieldNamed(whole, "Packet 1").size, 10U);
    EXPECT_EQ(fieldNamed(whole, "Packet 1").meaning, "from column 1 of row 1");
    EXPECT_EQ(fieldNamed(whole, "Image Data").wrong, "1 packets continue beyond the end of a row");

    file.resize(file.size() - 1);
    const Anatomy cut = dissectTga(file);
    EXPECT_EQ(cut.damage, "the packets end at offset 22, after 5 of 8 pixels");
    EXPECT_EQ(fieldNamed(cut, "Packet 1").wrong, "needs 10 bytes, 9 bytes are left");
}

TEST(TgaAnatomy, SaysWhatLooksWrong) {
    const Anatomy anatomy = dissectTga(fileOf({.type = 2, .width = 0, .depth = 23, .descriptor = 0x47}));
    EXPECT_EQ(fieldNamed(anatomy, "Image Width").wrong, "expected at least 1 pixel, found 0");
    EXPECT_EQ(fieldNamed(anatomy, "Pixel Depth").wrong,
              "expected 15, 16, 24 or 32 bits for true colour, found 23");
    EXPECT_THAT(fieldNamed(anatomy, "Image Descriptor").wrong, HasSubstr("interleaved (1"));
    EXPECT_EQ(fieldNamed(anatomy, "Image Height").wrong, "");
}

TEST(TgaAnatomy, GoesOnToThePointOfDamage) {
    Bytes file = fileOf({.width = 2, .height = 2, .data = std::vector<int>(12)});
    file.resize(25);
    EXPECT_EQ(dissectTga(file).damage, "pixel data needs 12 bytes from offset 18, there are 7");
    EXPECT_EQ(dissectTga(file).fields.size(), 1U + 12 + 1);
    file.resize(13);
    EXPECT_EQ(dissectTga(file).damage, "the header needs 18 bytes, the file has 13");
    EXPECT_EQ(dissectTga(file).fields.back().name, "Y-origin of Image") << "the last that is whole";
    EXPECT_EQ(dissectTga({}).fields.size(), 1U);
}

TEST(TgaAnatomy, CountsMoreBytesThan32BitsCan) {
    const Bytes file = fileOf({.width = 32768, .height = 32768, .depth = 32, .descriptor = 8});
    EXPECT_EQ(dissectTga(file).damage, "pixel data needs 4294967296 bytes from offset 18, there are 0");
    DecodeLimits limits;
    limits.maxExtent = 65535;
    limits.maxPixels = limits.maxBytes = std::numeric_limits<std::size_t>::max();
    EXPECT_FALSE(decodeTga(file, limits));
}

TEST(TgaAnatomy, AFooterThatPointsNowhereIsNamed) {
    Bytes file = withAttributesType(fileOf({.data = std::vector<int>(6)}), 0);
    file[file.size() - 26 + 3] = std::byte{0x7F}; // the extension area's offset
    const Anatomy anatomy = dissectTga(file);
    EXPECT_THAT(fieldNamed(anatomy, "Extension Area Offset").wrong,
                HasSubstr("between header and footer (18 to 519)"));
    EXPECT_THAT(sectionsOf(anatomy),
                ElementsAre("Header at 0, 18", "Image Data at 18, 6", "Footer at 519, 26"));
}

TEST(TgaAnatomy, DeveloperTagsAndTheImageIdAreShown) {
    // The ID "ab", one pixel of grey, a directory of one tag (700) with 5 bytes at offset 999.
    Bytes file = fileOf({.type = 3,
                         .width = 1,
                         .depth = 8,
                         .data = {'a', 'b', 200, 1, 0, 0xBC, 2, 0xE7, 3, 0, 0, 5, 0, 0, 0}});
    file[0] = std::byte{2};
    for (const int value : {0, 0, 0, 0, 21, 0, 0, 0})
        file.push_back(static_cast<std::byte>(value));
    for (const char c : std::string("TRUEVISION-XFILE.") + '\0')
        file.push_back(static_cast<std::byte>(c));
    const Anatomy anatomy = dissectTga(file);
    EXPECT_EQ(fieldNamed(anatomy, "Image ID").value, "\"ab\"");
    EXPECT_EQ(fieldNamed(anatomy, "Tag 700").value, "5 bytes at offset 999");
    EXPECT_EQ(fieldNamed(anatomy, "Tag 700").wrong, "ends at offset 1004, the file has 59 bytes");
    EXPECT_THAT(sectionsOf(anatomy),
                ElementsAre("Header at 0, 18", "Image ID at 18, 2", "Image Data at 20, 1",
                            "Developer Directory at 21, 12", "Footer at 33, 26"));
}

} // namespace
} // namespace texplorer::tga_anatomy_test

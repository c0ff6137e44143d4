#include "tests/support/python.h"
#include "tests/support/raw_file.h"
#include "tests/support/temp_dir.h"
#include "tests/support/tga_recipe.h"
#include "texplorer/codec/tga/tga.h"
#include "texplorer/s3tc/surface_pixels.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <random>

namespace texplorer::tga_test {
namespace {

using test::fileOf;
using test::Recipe;
using test::withAttributesType;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Result<Image> decodePicture(ByteView file, const DecodeLimits& limits = {}) {
    Result<TextureImage> texture = decodeTga(file, limits);
    if (!texture)
        return fail(texture.error());
    return uprightImage(std::move(*texture));
}

PixelFormat formatNamed(const std::string& letters) {
    return letters == "l"     ? PixelFormat::Luminance8
           : letters == "la"  ? PixelFormat::LuminanceAlpha8
           : letters == "rgb" ? PixelFormat::Rgb8
                              : PixelFormat::Rgba8;
}

TEST(Tga, EveryVariantGivesThePixelsThatWereWritten) {
    const test::TempDir folder;
    ASSERT_TRUE(test::runPython("fixtures/make_tga.py", folder.path()));
    int decoded = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
        if (entry.path().extension() != ".tga")
            continue;
        SCOPED_TRACE(entry.path().filename());
        std::array<char, 8> letters{};
        int origin = 0;
        int width = 0;
        int height = 0;
        ASSERT_EQ(std::sscanf(entry.path().stem().c_str(), "%*[a-z0-9]_%7[a-z]_%d_%dx%d", letters.data(),
                              &origin, &width, &height),
                  4);
        const Bytes file = test::readRaw(entry.path());
        EXPECT_TRUE(isTga(file));
        const Result<TextureImage> texture = decodeTga(file);
        ASSERT_TRUE(texture) << texture.error().message;
        EXPECT_EQ(texture->fileTopFirst, (origin & 2) != 0);
        EXPECT_FALSE(texture->topFirst);
        const Image image = uprightImage(*texture);
        ASSERT_EQ(image.format, formatNamed(letters.data()));
        EXPECT_EQ(image.width, width);
        EXPECT_EQ(image.height, height);
        EXPECT_EQ(image.pixels, test::readRaw(std::filesystem::path(entry.path()).replace_extension(".raw")));
        const Anatomy anatomy = dissectTga(file);
        EXPECT_EQ(anatomy.damage, "");
        ++decoded;
    }
    // gray, colours and colour maps in two codings, ten combinations of origin and extents; then the others
    EXPECT_EQ(decoded, (2 + 5 + 5 * 4) * 2 * 10 + 1 + 7 + 4 * 2 * 2 + 2 * 2);
}

std::vector<int> numbers(const Image& image) {
    std::vector<int> values;
    for (const std::byte byte : image.pixels)
        values.push_back(std::to_integer<int>(byte));
    return values;
}

TEST(Tga, PixelsAreBlueGreenRedAlphaAndTheOriginIsTheBottomLeft) {
    const Result<Image> image = decodePicture(
        fileOf({.width = 1, .height = 2, .depth = 32, .descriptor = 8, .data = {1, 2, 3, 4, 5, 6, 7, 8}}));
    ASSERT_TRUE(image);
    EXPECT_THAT(numbers(*image), ElementsAre(3, 2, 1, 4, 7, 6, 5, 8));
}

// v / 31 of five bits, as the nearest of eight: 3 / 31 = 24.7 / 255, 24 / 31 = 197.4 / 255.
TEST(Tga, FiveBitsBecomeTheNearestEight) {
    const int value = 3 | 24 << 5 | 31 << 10;
    const Result<Image> image =
        decodePicture(fileOf({.width = 1, .depth = 16, .data = {value & 255, value >> 8}}));
    ASSERT_TRUE(image);
    EXPECT_THAT(numbers(*image), ElementsAre(255, 197, 25));
}

struct AlphaCase {
    const char* name;
    int depth;
    int descriptor;
    int attributesType; // -1: a file of version 1
    std::vector<int> data;
    AlphaMeaning meaning;
    std::vector<int> pixels;
    const char* note;
};

class TgaAlpha : public testing::TestWithParam<AlphaCase> {};

TEST_P(TgaAlpha, IsWhatTheFileSays) {
    const AlphaCase& row = GetParam();
    Bytes file = fileOf({.depth = row.depth, .descriptor = row.descriptor, .data = row.data});
    if (row.attributesType >= 0)
        file = withAttributesType(std::move(file), row.attributesType);
    const Result<TextureImage> texture = decodeTga(file);
    ASSERT_TRUE(texture) << texture.error().message;
    EXPECT_EQ(texture->alpha, row.meaning);
    EXPECT_EQ(numbers(uprightImage(*texture)), row.pixels);
    if (*row.note == '\0')
        EXPECT_THAT(texture->notes, IsEmpty());
    else
        EXPECT_THAT(texture->notes, ElementsAre(HasSubstr(row.note)));
}

const std::vector<int> twoAlphas{1, 2, 3, 4, 5, 6, 7, 8};
const std::vector<int> kept{3, 2, 1, 4, 7, 6, 5, 8};
const std::vector<int> opaque{3, 2, 1, 255, 7, 6, 5, 255};
const std::vector<int> bitSetAndNot{0x00, 0x80, 0xFF, 0x7F};
const std::vector<int> bitNotSet{0x00, 0x00, 0xFF, 0x7F};
const std::vector<int> blackAndWhite{0, 0, 0, 255, 255, 255, 255, 255};
using enum AlphaMeaning;

INSTANTIATE_TEST_SUITE_P(
    All, TgaAlpha,
    testing::Values(
        AlphaCase{"Version1Eight", 32, 8, -1, twoAlphas, Straight, kept, ""},
        AlphaCase{"Version1None", 32, 0, -1, twoAlphas, Unknown, kept, "not every alpha is 0: kept"},
        AlphaCase{"Version1Padding",
                  32,
                  0,
                  -1,
                  {1, 2, 3, 0, 5, 6, 7, 0},
                  None,
                  opaque,
                  "every alpha is 0: ignored"},
        AlphaCase{"Type0", 32, 0, 0, twoAlphas, None, opaque, ""},
        AlphaCase{"Type0Contradicts", 32, 8, 0, twoAlphas, Unknown, kept,
                  "the descriptor 8 bits, but not every alpha is 0: kept"},
        AlphaCase{"Type1", 32, 8, 1, twoAlphas, None, opaque, ""},
        AlphaCase{"Type2", 32, 8, 2, twoAlphas, Unknown, kept, ""},
        AlphaCase{"Type3", 32, 8, 3, twoAlphas, Straight, kept, ""},
        AlphaCase{"Type3WithoutBits", 32, 0, 3, twoAlphas, Straight, kept, ""},
        AlphaCase{"Type4", 32, 8, 4, twoAlphas, Premultiplied, kept, ""},
        AlphaCase{"TypeReserved", 32, 8, 77, twoAlphas, Straight, kept, "attributes type is 77"},
        AlphaCase{"OneBit", 16, 1, -1, bitSetAndNot, Straight, {0, 0, 0, 255, 255, 255, 255, 0}, ""},
        AlphaCase{"OneBitUnused", 16, 0, -1, bitSetAndNot, None, {0, 0, 0, 255, 255, 255}, ""},
        AlphaCase{"OneBitType4", 16, 0, 4, bitSetAndNot, Premultiplied, {0, 0, 0, 255, 255, 255, 255, 0}, ""},
        AlphaCase{"OneBitNeverSet", 16, 1, -1, bitNotSet, None, blackAndWhite, "every alpha is 0: ignored"},
        AlphaCase{"OneBitNeverSetType0", 16, 1, 0, bitNotSet, None, blackAndWhite,
                  "the descriptor 1 bit, and"},
        AlphaCase{"OneBitNeverSetType2", 16, 1, 2, bitNotSet, None, blackAndWhite,
                  "every alpha is 0: ignored"},
        AlphaCase{"OneBitNeverSetType3", 16, 1, 3, bitNotSet, Straight, {0, 0, 0, 0, 255, 255, 255, 0}, ""},
        AlphaCase{
            "OneBitNeverSetType4", 16, 1, 4, bitNotSet, Premultiplied, {0, 0, 0, 0, 255, 255, 255, 0}, ""},
        AlphaCase{
            "EightBitsNeverSet", 32, 8, -1, {1, 2, 3, 0, 5, 6, 7, 0}, Straight, {3, 2, 1, 0, 7, 6, 5, 0}, ""},
        AlphaCase{"EightBitsNeverSetType0",
                  32,
                  8,
                  0,
                  {1, 2, 3, 0, 5, 6, 7, 0},
                  None,
                  opaque,
                  "the descriptor 8 bits, and"},
        AlphaCase{"BitsThatCannotBe", 24, 8, -1, {1, 2, 3, 4, 5, 6}, None, {3, 2, 1, 6, 5, 4}, "expected 0"}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(Tga, PixelsThatNameNoEntryAreBlackAndCounted) {
    const Result<TextureImage> texture = decodeTga(fileOf({.type = 9,
                                                           .width = 7,
                                                           .depth = 8,
                                                           .firstEntry = 10,
                                                           .entries = 2,
                                                           .entryBits = 24,
                                                           .data = {1, 2, 3, 4, 5, 6, //
                                                                    2, 9, 10, 11, // raw: below, both entries
                                                                    0x83, 12}})); // four times the one above
    ASSERT_TRUE(texture) << texture.error().message;
    EXPECT_THAT(numbers(uprightImage(*texture)),
                ElementsAre(0, 0, 0, 3, 2, 1, 6, 5, 4, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0));
    EXPECT_THAT(texture->notes, ElementsAre("5 pixels are outside the colour map (10 to 11): black"));
}

TEST(Tga, OnePixelWithoutAnEntryIsNamedInTheSingular) {
    const Result<TextureImage> texture = decodeTga(fileOf({.type = 1,
                                                           .width = 1,
                                                           .depth = 8,
                                                           .firstEntry = 10,
                                                           .entries = 2,
                                                           .entryBits = 24,
                                                           .data = {1, 2, 3, 4, 5, 6, 9}}));
    ASSERT_TRUE(texture) << texture.error().message;
    EXPECT_THAT(texture->notes, ElementsAre("1 pixel is outside the colour map (10 to 11): black"));
}

TEST(Tga, FieldsOfAColorMapThatIsNotThereAreNotedAndIgnored) {
    Bytes file = fileOf({.width = 2, .firstEntry = 7, .entryBits = 24, .data = {1, 2, 3, 4, 5, 6}});
    file[5] = std::byte{255}; // entries
    EXPECT_TRUE(isTga(file));
    const Result<TextureImage> texture = decodeTga(file);
    ASSERT_TRUE(texture) << texture.error().message;
    EXPECT_THAT(numbers(uprightImage(*texture)), ElementsAre(3, 2, 1, 6, 5, 4));
    EXPECT_THAT(texture->notes,
                ElementsAre("First Entry Index: expected 0 without a colour map, found 7",
                            "Color map Length: expected 0 without a colour map, found 255",
                            "Color map Entry Size: expected 0 without a colour map, found 24"));
    EXPECT_EQ(dissectTga(file).damage, "");
}

struct Refusal {
    const char* name;
    Recipe recipe;
    std::size_t size; // the file's, cut or not
    ErrorCode code;
    const char* message;
};

class TgaRefusals : public testing::TestWithParam<Refusal> {};

TEST_P(TgaRefusals, SayWhatWasExpectedAndWhatWasFound) {
    Bytes file = fileOf(GetParam().recipe);
    file.resize(GetParam().size, std::byte{0});
    const Result<TextureImage> texture = decodeTga(file);
    ASSERT_FALSE(texture);
    EXPECT_EQ(texture.error().message, GetParam().message);
    EXPECT_EQ(texture.error().code, GetParam().code);
    EXPECT_EQ(texture.error().where, "");
}

using enum ErrorCode;

INSTANTIATE_TEST_SUITE_P(
    All, TgaRefusals,
    testing::Values(
        Refusal{"Empty", {}, 0, Malformed, "TGA: the header needs 18 bytes, the file has 0"},
        Refusal{"HeaderCut", {}, 17, Malformed, "TGA: the header needs 18 bytes, the file has 17"},
        Refusal{"NoPicture",
                {.type = 0},
                24,
                Malformed,
                "TGA: Image Type: expected type 1, 2, 3, 9, 10 or 11, found 0"},
        Refusal{"Type4",
                {.type = 4},
                24,
                Malformed,
                "TGA: Image Type: expected type 1, 2, 3, 9, 10 or 11, found 4"},
        Refusal{"Huffman",
                {.type = 32},
                24,
                Unsupported,
                "TGA: Image Type: types 1, 2, 3, 9, 10 and 11 are read, the file has 32: colour-mapped; "
                "Huffman, delta and run-length coded"},
        Refusal{"NoColorMap",
                {.type = 1, .depth = 8},
                24,
                Malformed,
                "TGA: Color Map Type: expected 1, as the picture is colour-mapped, found 0"},
        Refusal{"EntrySize",
                {.type = 1, .depth = 8, .entries = 1, .entryBits = 8},
                24,
                Malformed,
                "TGA: Color map Entry Size: expected 15, 16, 24 or 32 bits an entry, found 8"},
        Refusal{"ColorMapCut",
                {.type = 1, .depth = 8, .entries = 256, .entryBits = 24},
                100,
                Malformed,
                "TGA: the image ID and the colour map end at offset 786, the file has 100 bytes"},
        Refusal{"DepthOfColor",
                {.depth = 8},
                24,
                Malformed,
                "TGA: Pixel Depth: expected 15, 16, 24 or 32 bits for true colour, found 8"},
        Refusal{"DepthOfGray",
                {.type = 3, .depth = 24},
                24,
                Malformed,
                "TGA: Pixel Depth: expected 8 or 16 bits for grey, found 24"},
        Refusal{"DepthOfIndex",
                {.type = 1, .depth = 24, .entries = 1, .entryBits = 24},
                24,
                Malformed,
                "TGA: Pixel Depth: expected 8, 15 or 16 bits for a colour map's index, found 24"},
        Refusal{
            "WidthZero", {.width = 0}, 24, Malformed, "TGA: Image Width: expected at least 1 pixel, found 0"},
        Refusal{"HeightZero",
                {.height = 0},
                24,
                Malformed,
                "TGA: Image Height: expected at least 1 pixel, found 0"},
        Refusal{"Interleaved",
                {.descriptor = 0x80},
                24,
                Unsupported,
                "TGA: Image Descriptor: rows one after the other are read, these are interleaved (2 in bits "
                "6 and "
                "7)"},
        Refusal{"TooWide",
                {.width = 16385},
                24,
                TooLarge,
                "TGA: at most 16384 × 16384 pixels are read, the file has 16385 × 1 pixels"},
        Refusal{"PixelsCut",
                {},
                23,
                Malformed,
                "TGA: pixel data needs 6 bytes from offset 18, the file has 5 there"},
        Refusal{"Lying",
                {.width = 16384, .height = 16384, .depth = 32},
                24,
                Malformed,
                "TGA: pixel data needs 1073741824 bytes from offset 18, the file has 6 there"},
        // 2097152 packets of 128 pixels
        Refusal{"Bomb",
                {.type = 10, .width = 16384, .height = 16384, .depth = 24, .data = {255, 0}},
                20,
                Malformed,
                "TGA: pixel data needs at least 8388608 bytes from offset 18, the file has 2 there"},
        Refusal{"PacketsCut",
                {.type = 10, .width = 3, .data = {0, 1, 2, 3, 1, 1, 2, 3}},
                26,
                Malformed,
                "TGA: the packets end after 8 bytes from offset 18, before the picture's 3 pixels"}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(Tga, LimitsAreTheCallersToSay) {
    const Bytes file = fileOf({.width = 3, .height = 2, .data = std::vector<int>(18)});
    EXPECT_TRUE(decodePicture(file, {.maxExtent = 3, .maxPixels = 6, .maxBytes = 18}));
    for (const DecodeLimits& limits :
         {DecodeLimits{.maxExtent = 2}, DecodeLimits{.maxPixels = 5}, DecodeLimits{.maxBytes = 17}}) {
        const Result<Image> refused = decodePicture(file, limits);
        ASSERT_FALSE(refused);
        EXPECT_EQ(refused.error().code, TooLarge);
    }
}

struct Stranger {
    const char* name;
    std::vector<int> bytes; // then 0, up to 200
};

class TgaStrangers : public testing::TestWithParam<Stranger> {};

TEST_P(TgaStrangers, AreNotTakenForTga) {
    Bytes file(200, std::byte{0});
    std::ranges::transform(GetParam().bytes, file.begin(),
                           [](int value) { return static_cast<std::byte>(value); });
    EXPECT_FALSE(isTga(file));
}

INSTANTIATE_TEST_SUITE_P(
    All, TgaStrangers,
    testing::Values(
        Stranger{"Zeros", {}}, Stranger{"Text", {'h', 'e', 'l', 'l', 'o'}},
        Stranger{"Icon", {0, 0, 1, 0, 1, 0, 16, 16, 0, 0, 1, 0, 24, 0, 64, 3, 0, 0, 22}},
        // one of 32 x 32 with its hot spot at 24, 24; its entry begins as a colour map of 8192 entries
        Stranger{"Cursor", {0, 0, 2, 0, 1, 0, 32, 32, 0, 0, 24, 0, 24, 0, 24, 1, 24, 0, 22}},
        Stranger{"MpegVideo", {0, 0, 1, 0xB3, 0x14, 0, 0xF0, 0x13, 0xFF}},
        Stranger{"TrueType", {0, 1, 0, 0, 0, 15, 0, 128, 0, 3, 0, 112}},
        Stranger{"Png", {0x89, 'P', 'N', 'G', 13, 10, 26, 10}}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(Tga, TheFooterAloneMakesATga) {
    Bytes file = withAttributesType(fileOf({.type = 0, .data = {}}), 0);
    EXPECT_TRUE(isTga(file)) << "so that its header is complained of";
    file.back() = std::byte{1};
    EXPECT_FALSE(isTga(file));
}

/// Small files of all kinds, to be damaged.
std::vector<Bytes> goodFiles() {
    return {
        fileOf({.data = {1, 2, 3, 4, 5, 6}}),
        withAttributesType(fileOf({.depth = 32, .descriptor = 8, .data = twoAlphas}), 3),
        fileOf({.type = 10, .width = 5, .height = 3, .descriptor = 0x30, .data = {0x89, 1,  2,  3,  4,  1, 2,
                                                                                  3,    4,  5,  6,  7,  8, 9,
                                                                                  10,   11, 12, 13, 14, 15}}),
        fileOf({.type = 9,
                .width = 4,
                .height = 2,
                .depth = 8,
                .firstEntry = 1,
                .entries = 2,
                .entryBits = 16,
                .data = {1, 2, 3, 4, 0x83, 1, 3, 1, 2, 1, 2}}),
        withAttributesType(
            fileOf({.type = 11, .width = 4, .depth = 16, .descriptor = 8, .data = {0x83, 1, 2}}), 4),
    };
}

TEST(Tga, EveryTruncationIsRefusedWhereItCutsPixels) {
    for (const Bytes& file : goodFiles()) {
        ASSERT_TRUE(decodePicture(file)) << decodePicture(file).error().message;
        const std::size_t tail = file.size() > 500 ? 495 + 26 : 0;
        for (std::size_t size = 0; size < file.size(); ++size) {
            // A copy of exactly that size, so that the sanitizer sees a read beyond its end.
            const Bytes cut(file.begin(), file.begin() + static_cast<std::ptrdiff_t>(size));
            EXPECT_EQ(decodePicture(cut).has_value(), size >= file.size() - tail)
                << size << " of " << file.size() << " bytes";
            const Anatomy anatomy = dissectTga(cut);
            EXPECT_EQ(anatomy.damage.empty(), size >= file.size() - tail) << size << ": " << anatomy.damage;
        }
    }
}

TEST(Tga, FlippedBitsNeverCrashAndNeverGiveHalfAnImage) {
    std::mt19937 random(20); // NOLINT: the same files each time
    int decoded = 0;
    constexpr int rounds = 4000;
    const std::vector<Bytes> files = goodFiles();
    for (int round = 0; round < rounds; ++round) {
        Bytes file = files[static_cast<std::size_t>(round) % files.size()];
        for (int flips = 1 + static_cast<int>(random() % 4); flips > 0; --flips)
            file[random() % std::min<std::size_t>(file.size(), 40)] ^=
                static_cast<std::byte>(1U << (random() % 8));
        if (random() % 2 == 0 && file.size() > 500)
            file[file.size() - 1 - random() % 26] ^= static_cast<std::byte>(1U << (random() % 8));
        EXPECT_LE(dissectTga(file).fields.size(), 4096U);
        const Result<Image> image = decodePicture(file);
        if (!image) {
            EXPECT_FALSE(image.error().message.empty());
            continue;
        }
        ++decoded;
        ASSERT_EQ(image->pixels.size(), image->rowBytes() * static_cast<std::size_t>(image->height));
        ASSERT_LE(image->pixels.size(), file.size() * 128 * 4) << "more than packets can give";
    }
    EXPECT_GT(decoded, rounds / 10);
    EXPECT_LT(decoded, rounds * 9 / 10);
}

} // namespace
} // namespace texplorer::tga_test

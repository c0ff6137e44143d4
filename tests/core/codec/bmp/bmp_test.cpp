#include "tests/support/python.h"
#include "tests/support/raw_file.h"
#include "tests/support/temp_dir.h"
#include "texplorer/codec/bmp/bmp.h"
#include "texplorer/s3tc/surface_pixels.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <random>
#include <string>
#include <vector>

namespace texplorer::bmp_test {
namespace {

Result<Image> decodePicture(ByteView file, const DecodeLimits& limits = {}) {
    Result<TextureImage> texture = decodeBmp(file, limits);
    if (!texture)
        return fail(texture.error());
    return uprightImage(std::move(*texture));
}

PixelFormat formatNamed(const std::string& name) {
    return name == "l" ? PixelFormat::Luminance8 : name == "rgba" ? PixelFormat::Rgba8 : PixelFormat::Rgb8;
}

/// Decodes every NAME_FORMAT_WxH.bmp of a folder and compares it with the pixels next to it. Returns how many
/// there were.
int decodeFolder(const std::filesystem::path& folder) {
    int decoded = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() != ".bmp")
            continue;
        SCOPED_TRACE(entry.path().filename());
        int width = 0;
        int height = 0;
        std::array<char, 8> format{};
        EXPECT_EQ(std::sscanf(entry.path().stem().c_str(), "%*[a-z0-9]_%7[a-z]_%dx%d", format.data(), &width,
                              &height),
                  3);
        const Result<Image> image = decodePicture(test::readRaw(entry.path()));
        ++decoded;
        if (!image) {
            ADD_FAILURE() << image.error().message;
            continue;
        }
        EXPECT_EQ(image->format, formatNamed(format.data()));
        EXPECT_EQ(image->width, width);
        EXPECT_EQ(image->height, height);
        EXPECT_EQ(image->depth, 1);
        EXPECT_EQ(image->pixels,
                  test::readRaw(std::filesystem::path(entry.path()).replace_extension(".raw")));
    }
    return decoded;
}

TEST(Bmp, TrueColorGivesThePixelsThatWereWritten) {
    const test::TempDir folder;
    ASSERT_TRUE(test::runPython("fixtures/make_bmp.py", folder.path()));
    EXPECT_EQ(decodeFolder(folder.path()), 5 * 3 * 3 + 6 * 2 + 6 + 5);
}

TEST(Bmp, EveryVariantGivesThePixelsThatWereWritten) {
    const test::TempDir folder;
    ASSERT_TRUE(test::runPython("fixtures/make_bmp_variants.py", folder.path()));
    const int written = std::stoi(test::readRawText(folder.path() / "count"));
    EXPECT_GT(written, 150);
    EXPECT_EQ(decodeFolder(folder.path()), written);
}

/// A file of 3 x 2 pixels, each row 9 bytes and 3 of padding. The cases change one field each.
Bytes goodFile() {
    Bytes file(54 + 24, std::byte{0});
    const auto put = [&](std::size_t offset, unsigned value) {
        file[offset] = static_cast<std::byte>(value);
    };
    put(0, 'B');
    put(1, 'M');
    put(10, 54);
    put(14, 40);
    put(18, 3);
    put(22, 2);
    put(26, 1);
    put(28, 24);
    for (unsigned i = 0; i < 24; ++i)
        put(54 + i, i + 1);
    return file;
}

TEST(Bmp, ColorsAreBlueGreenRedAndTheFirstRowIsTheBottomOne) {
    const Result<Image> image = decodePicture(goodFile());
    ASSERT_TRUE(image);
    const auto components = [&](int x, int y) {
        const ByteView at = image->at(x, y);
        return std::array{static_cast<int>(at[0]), static_cast<int>(at[1]), static_cast<int>(at[2])};
    };
    EXPECT_EQ(components(0, 0), (std::array{3, 2, 1}));
    EXPECT_EQ(components(2, 0), (std::array{9, 8, 7}));
    EXPECT_EQ(components(0, 1), (std::array{15, 14, 13})) << "after 9 bytes and 3 of padding";
}

struct Refusal {
    const char* name;
    std::size_t offset;
    std::vector<int> bytes; // written at `at`
    std::size_t size;       // size of the file after that
    ErrorCode code;
    const char* message;
};

class BmpRefusals : public testing::TestWithParam<Refusal> {};

TEST_P(BmpRefusals, SayWhatWasExpectedAndWhatWasFound) {
    Bytes file = goodFile();
    for (std::size_t i = 0; i < GetParam().bytes.size(); ++i)
        file.at(GetParam().offset + i) = static_cast<std::byte>(GetParam().bytes[i]);
    file.resize(GetParam().size);
    const Result<Image> image = decodePicture(file);
    ASSERT_FALSE(image);
    EXPECT_EQ(image.error().message, GetParam().message);
    EXPECT_EQ(image.error().code, GetParam().code);
    EXPECT_EQ(image.error().where, "");
}

using enum ErrorCode;

INSTANTIATE_TEST_SUITE_P(
    All, BmpRefusals,
    testing::Values(
        Refusal{"Empty", 0, {}, 0, Malformed, "BMP: the file is empty"},
        Refusal{"Magic", 0, {'P', 'M'}, 78, Malformed, "BMP: the file does not begin with \"BM\""},
        Refusal{"OneByte", 0, {}, 1, Malformed, "BMP: the file does not begin with \"BM\""},
        Refusal{"MagicAlone", 0, {}, 2, Malformed, "BMP: the headers need 26 bytes, the file has 2"},
        Refusal{"HeaderCut", 0, {}, 53, Malformed, "BMP: the headers need 54 bytes, the file has 53"},
        Refusal{"NoPixels",
                0,
                {},
                54,
                Malformed,
                "BMP: pixel data needs 21 bytes from offset 54, the file has 54"},
        Refusal{"LastByte",
                0,
                {},
                74,
                Malformed,
                "BMP: pixel data needs 21 bytes from offset 54, the file has 74"},
        // 256 x 256 in a file of 78 bytes
        Refusal{"Lying",
                18,
                {0, 1, 0, 0, 0, 1, 0, 0},
                78,
                Malformed,
                "BMP: pixel data needs 196608 bytes from offset 54, the file has 78"},
        Refusal{"DataPosFar",
                10,
                {0xFF, 0xFF, 0xFF, 0xFF},
                78,
                Malformed,
                "BMP: pixel data begins at offset 4294967295, the file has 78 bytes"},
        Refusal{"DataPosLow",
                10,
                {20},
                78,
                Malformed,
                "BMP: pixel data begins at offset 20, within the headers, which end at 54"},
        Refusal{"HeaderOdd",
                14,
                {65},
                78,
                Unsupported,
                "BMP: headers of 12, 16 to 64, 108 and 124 bytes are read, the file has one of 65"},
        Refusal{"HeaderHuge",
                14,
                {0xFF, 0xFF, 0xFF, 0xFF},
                78,
                Unsupported,
                "BMP: headers of 12, 16 to 64, 108 and 124 bytes are read, the file has one of 4294967295"},
        Refusal{
            "LongHeaderCut", 14, {124}, 78, Malformed, "BMP: the headers need 138 bytes, the file has 78"},
        Refusal{"HeadersBehindPixels",
                14,
                {60},
                78,
                Malformed,
                "BMP: pixel data begins at offset 54, within the headers, which end at 74"},
        Refusal{
            "PaletteNone",
            28,
            {8},
            78,
            Malformed,
            "BMP: 8 bits a pixel need a palette, but there is none between offset 54 and the pixels at 54"},
        Refusal{"Depth",
                28,
                {64},
                78,
                Unsupported,
                "BMP: 1, 2, 4, 8, 16, 24 or 32 bits a pixel are read, the file has 64"},
        Refusal{"Rle8", 30, {1}, 78, Malformed, "BMP: RLE8 needs 8 bits a pixel, the file has 24"},
        Refusal{"Rle4", 30, {2}, 78, Malformed, "BMP: RLE4 needs 4 bits a pixel, the file has 24"},
        Refusal{"BitFields",
                30,
                {3},
                78,
                Malformed,
                "BMP: bit fields needs 16 or 32 bits a pixel, the file has 24"},
        Refusal{"Jpeg",
                30,
                {4},
                78,
                Unsupported,
                "BMP: the file contains a whole JPEG file for printers, at offset 54; extract it first"},
        Refusal{"Png",
                30,
                {5},
                78,
                Unsupported,
                "BMP: the file contains a whole PNG file for printers, at offset 54; extract it first"},
        Refusal{"Cmyk",
                30,
                {11},
                78,
                Unsupported,
                "BMP: only uncompressed, RLE and bit-field pixels are read, this file's compression is CMYK"},
        Refusal{
            "CompressionUnknown",
            30,
            {9},
            78,
            Unsupported,
            "BMP: only uncompressed, RLE and bit-field pixels are read, this file's compression is number 9"},
        Refusal{
            "Os2Rle24",
            14,
            {36, 0, 0, 0, 3, 0, 0, 0, 2, 0, 0, 0, 1, 0, 24, 0, 4},
            78,
            Unsupported,
            "BMP: only uncompressed and RLE pixels of OS/2 files are read, this file's compression is RLE24"},
        Refusal{
            "Os2Huffman",
            14,
            {36, 0, 0, 0, 3, 0, 0, 0, 2, 0, 0, 0, 1, 0, 1, 0, 3},
            78,
            Unsupported,
            "BMP: only uncompressed and RLE pixels of OS/2 files are read, this file's compression is Huffman 1D"},
        Refusal{"WidthZero",
                18,
                {0},
                78,
                Malformed,
                "BMP: a picture has at least 1 × 1 pixels, this one has 0 × 2 pixels"},
        Refusal{"HeightZero",
                22,
                {0},
                78,
                Malformed,
                "BMP: a picture has at least 1 × 1 pixels, this one has 3 × 0 pixels"},
        Refusal{"WidthNegative",
                18,
                {0xFD, 0xFF, 0xFF, 0xFF},
                78,
                Malformed,
                "BMP: a picture has at least 1 × 1 pixels, this one has -3 × 2 pixels"},
        Refusal{"HeightSmallestInt",
                22,
                {0, 0, 0, 0x80},
                78,
                TooLarge,
                "BMP: at most 16384 × 16384 pixels are read, the file has 3 × 2147483648 pixels"},
        // 100000 = 0x186A0
        Refusal{"TooWide",
                18,
                {0xA0, 0x86, 1, 0},
                78,
                TooLarge,
                "BMP: at most 16384 × 16384 pixels are read, the file has 100000 × 2 pixels"}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(Bmp, TheLargestExtentIsTheCallersToSay) {
    EXPECT_TRUE(decodePicture(goodFile(), {.maxExtent = 3}));
    const Result<Image> refused = decodePicture(goodFile(), {.maxExtent = 2});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, TooLarge);
}

TEST(Bmp, TheBytesAndPixelsThatAreReadAreTheCallersToSay) {
    EXPECT_TRUE(decodePicture(goodFile(), {.maxPixels = 6, .maxBytes = 18}));
    EXPECT_EQ(decodePicture(goodFile(), {.maxPixels = 5}).error().message,
              "BMP: at most 5 pixels are read, the file has 3 × 2 pixels");
    EXPECT_EQ(decodePicture(goodFile(), {.maxBytes = 17}).error().message,
              "BMP: at most 17 bytes of pixels are read, the picture has 18");
}

/// RLE8 of any extent, two colours, with these codes.
Bytes rleFile(std::uint32_t width, std::uint32_t height, std::initializer_list<int> codes) {
    Bytes file = goodFile();
    file.resize(54 + 8);
    const auto put = [&](std::size_t offset, std::uint32_t value) {
        for (std::size_t i = 0; i < 4; ++i)
            file[offset + i] = static_cast<std::byte>(value >> (8 * i));
    };
    put(10, 62);
    put(18, width);
    put(22, height);
    put(28, 8 | 1 << 16);
    put(46, 2);
    put(54, 0x102030);
    put(58, 0x405060);
    for (const int code : codes)
        file.push_back(static_cast<std::byte>(code));
    return file;
}

TEST(Bmp, RunLengthCodesThatStopWithoutAnEndAreRefused) {
    EXPECT_TRUE(decodePicture(rleFile(4, 2, {4, 1, 0, 0, 4, 0, 0, 1})));
    EXPECT_TRUE(decodePicture(rleFile(4, 2, {4, 1, 0, 0, 4, 0}))) << "nothing is missing";
    EXPECT_EQ(decodePicture(rleFile(4, 2, {4, 1, 0, 0, 3, 0})).error().message,
              "BMP: the run-length codes end at offset 68 within row 2 of 2, without an end-of-picture code");
}

TEST(Bmp, FewRunLengthCodesDoNotBuyMuchMemory) {
    EXPECT_TRUE(decodePicture(rleFile(1024, 1024, {0, 1})));
    EXPECT_EQ(decodePicture(rleFile(1024, 1025, {0, 1})).error().message,
              "BMP: 2 bytes of run-length codes make at most 1048576 pixels, the file has 1049600");
}

std::vector<Sentence> notesOf(const Bytes& file) {
    const Result<TextureImage> texture = decodeBmp(file);
    EXPECT_TRUE(texture) << texture.error().message;
    return texture ? texture->notes : std::vector<Sentence>();
}

/// Correct parts of a file that the decoder ignores.
std::vector<Sentence> remarksOf(const Bytes& file) {
    return decodeBmp(file)->remarks;
}

TEST(Bmp, WhatWasOddIsNoted) {
    using testing::ElementsAre;
    using testing::IsEmpty;
    EXPECT_THAT(notesOf(goodFile()), IsEmpty());
    EXPECT_THAT(notesOf(rleFile(4, 2, {4, 1, 0, 0, 4, 0, 0, 1})), IsEmpty());
    EXPECT_THAT(notesOf(rleFile(4, 2, {9, 1, 0, 1})),
                ElementsAre("1 run-length code continued beyond the end of a row and ended there"));
    EXPECT_THAT(remarksOf(rleFile(4, 2, {9, 1, 0, 1})),
                ElementsAre("the run-length codes skip 4 pixels; these have the palette's first colour"));
    EXPECT_THAT(notesOf(rleFile(4, 1, {4, 7, 0, 1})),
                ElementsAre("a pixel has colour 7, the palette has 2; it is black"));
    Bytes file = goodFile(); // 1 x 2 pixels of 32 bits, whose fourth bytes are 4 and 8
    file[18] = std::byte{1};
    file[28] = std::byte{32};
    EXPECT_THAT(notesOf(file), IsEmpty());
    EXPECT_THAT(remarksOf(file),
                ElementsAre("the fourth bytes of the pixels differ and may be alpha; without an alpha mask "
                            "they are ignored"));
}

/// 2 x 1 pixels of 32 bits without bit fields, with a V4 header and its masks; `fourth` is in both pixels.
Bytes v4File(std::uint8_t first, std::uint8_t second, std::uint8_t highestOfMask) {
    Bytes file(14 + 108 + 8, std::byte{0});
    const auto put = [&](std::size_t at, std::initializer_list<int> bytes) {
        for (const int byte : bytes)
            file[at++] = static_cast<std::byte>(byte);
    };
    put(0, {'B', 'M', static_cast<int>(file.size())});
    put(10, {122, 0, 0, 0, 108, 0, 0, 0, 2, 0, 0, 0, 1, 0, 0, 0, 1, 0, 32, 0});
    put(54, {0, 0, 0xFF, 0, 0, 0xFF, 0, 0, 0xFF, 0, 0, 0, 0, 0, 0, highestOfMask});
    put(122, {1, 2, 3, first, 4, 5, 6, second});
    return file;
}

TEST(Bmp, AnAlphaMaskCountsWithoutBitFieldsToo) {
    const auto alphas = [](const Bytes& file) {
        const Image image = std::get<Image>(decodeBmp(file)->surfaces.front());
        EXPECT_EQ(image.format, PixelFormat::Rgba8);
        return std::pair{std::to_integer<int>(image.pixels[3]), std::to_integer<int>(image.pixels[7])};
    };
    EXPECT_EQ(alphas(v4File(0, 200, 0xFF)), std::pair(0, 200));
    EXPECT_THAT(remarksOf(v4File(0, 200, 0xFF)),
                testing::ElementsAre(
                    testing::HasSubstr("the header has an alpha mask: the fourth bytes are used as alpha")));
    EXPECT_EQ(alphas(v4File(0, 0, 0xFF)), std::pair(255, 255))
        << "a picture that nothing is seen of is not meant";
    EXPECT_EQ(std::get<Image>(decodeBmp(v4File(0, 200, 0))->surfaces.front()).format, PixelFormat::Rgb8);
    EXPECT_THAT(remarksOf(v4File(0, 200, 0)),
                testing::ElementsAre(testing::HasSubstr("without an alpha mask they are ignored")));
}

TEST(Bmp, SaysHowManyBitsAComponentHas) {
    Bytes file = v4File(0, 0, 0xC0);
    file[30] = std::byte{3}; // bit fields of 10 bits each
    const std::array masks{0xFF, 0x03, 0, 0, 0, 0xFC, 0x0F, 0, 0, 0, 0xF0, 0x3F};
    for (std::size_t i = 0; i < masks.size(); ++i)
        file[54 + i] = static_cast<std::byte>(masks[i]);
    EXPECT_EQ(decodeBmp(file)->componentBits, 10);
    EXPECT_EQ(decodeBmp(goodFile())->componentBits, 8);
}

TEST(Bmp, AlphaIsWhatAMaskSays) {
    const test::TempDir folder;
    ASSERT_TRUE(test::runPython("fixtures/make_bmp_variants.py", folder.path()));
    EXPECT_EQ(decodeBmp(test::readRaw(folder.path() / "bgra_rgba_5x3.bmp"))->alpha, AlphaMeaning::Straight);
    EXPECT_EQ(decodeBmp(test::readRaw(folder.path() / "plain32_rgb_5x3.bmp"))->alpha, AlphaMeaning::None);
}

TEST(Bmp, SaysWhichRowTheFileBeginsWith) {
    Bytes file = goodFile();
    EXPECT_FALSE(decodeBmp(file)->fileTopFirst);
    for (std::size_t i = 22; i < 26; ++i) // -2
        file[i] = i == 22 ? std::byte{0xFE} : std::byte{0xFF};
    EXPECT_TRUE(decodeBmp(file)->fileTopFirst);
    EXPECT_FALSE(decodeBmp(file)->topFirst) << "they are turned around while decoding";
}

/// One file for each kind of pixels, small enough to be cut at every byte.
std::vector<Bytes> smallFiles() {
    const test::TempDir folder;
    EXPECT_TRUE(test::runPython("fixtures/make_bmp_variants.py", folder.path()));
    std::vector<Bytes> files{goodFile()};
    for (const char* name :
         {"pal1_rgb_9x3", "pal2_rgb_5x2", "pal4down_rgb_9x3", "short_rgb_7x5", "os2short_rgb_13x4",
          "os22pal4_rgb_13x4", "palheader16_rgb_7x5", "mask565_rgb_5x3", "a2101010_rgba_11x3",
          "bgra_rgba_5x3", "behind_rgba_11x3", "plain32_rgb_5x3", "rle8_rgb_7x5", "rle8deltas_rgb_20x12",
          "rle4overrun_rgb_7x5", "rle4early_rgb_20x12", "grey_l_7x5", "pillowrgba_rgba_9x6"})
        files.push_back(test::readRaw(folder.path() / (std::string(name) + ".bmp")));
    return files;
}

/// Either an error or a whole picture; the anatomy stays within its bounds for any bytes.
bool survives(const Bytes& file) {
    const Anatomy anatomy = dissectBmp(file);
    EXPECT_LE(anatomy.fields.size(), 4096U);
    const Result<TextureImage> texture = decodeBmp(file, {.maxPixels = 1 << 20});
    if (!texture) {
        EXPECT_FALSE(texture.error().message.empty());
        return false;
    }
    const Image& image = std::get<Image>(texture->surface(0, 0));
    EXPECT_EQ(image.pixels.size(), image.rowBytes() * static_cast<std::size_t>(image.height));
    return true;
}

TEST(Bmp, EveryTruncationIsRefusedOrLosesNothing) {
    for (const Bytes& file : smallFiles()) {
        ASSERT_GT(file.size(), 60U);
        const Result<Image> whole = decodePicture(file);
        ASSERT_TRUE(whole) << whole.error().message;
        for (std::size_t size = 0; size < file.size(); ++size) {
            // A copy of exactly that size, so that the sanitizer sees a read beyond its end.
            const Bytes cut(file.begin(), file.begin() + static_cast<std::ptrdiff_t>(size));
            if (survives(cut)) // without the last padding or end-of-picture code
                EXPECT_EQ(*decodePicture(cut), *whole) << size << " of " << file.size() << " bytes";
            else
                EXPECT_FALSE(dissectBmp(cut).damage.empty()) << size << " of " << file.size() << " bytes";
        }
    }
}

TEST(Bmp, FlippedBitsNeverCrashAndNeverGiveHalfAnImage) {
    std::mt19937 random(20); // NOLINT: the same files each time
    for (const Bytes& file : smallFiles()) {
        int decoded = 0;
        constexpr int rounds = 1000;
        for (int round = 0; round < rounds; ++round) {
            Bytes spoilt = file;
            for (int flips = 1 + static_cast<int>(random() % 3); flips > 0; --flips)
                spoilt[random() % (round % 2 == 0 ? 54 : spoilt.size())] ^=
                    static_cast<std::byte>(1U << (random() % 8));
            decoded += survives(spoilt) ? 1 : 0;
        }
        EXPECT_GT(decoded, rounds / 10);
        EXPECT_LT(decoded, rounds);
    }
}

} // namespace
} // namespace texplorer::bmp_test

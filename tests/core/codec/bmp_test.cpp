#include "core/codec/bmp.h"
#include "tests/support/python.h"
#include "tests/support/raw_file.h"
#include "tests/support/temp_dir.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <random>

namespace texplorer {
namespace {

Result<Image> decodePicture(ByteView file, const DecodeLimits& limits = {}) {
    Result<TextureImage> texture = decodeBmp(file, limits);
    if (!texture)
        return fail(texture.error());
    return uprightImage(std::move(*texture));
}

TEST(Bmp, EveryVariantGivesThePixelsThatWereWritten) {
    const test::TempDir folder;
    ASSERT_TRUE(test::runPython("fixtures/make_bmp.py", folder.path()));
    int decoded = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
        if (entry.path().extension() != ".bmp")
            continue;
        SCOPED_TRACE(entry.path().filename());
        int width = 0;
        int height = 0;
        ASSERT_EQ(std::sscanf(entry.path().stem().c_str(), "%*[a-z0-9]_%dx%d", &width, &height), 2);
        const Result<Image> image = decodePicture(test::readRaw(entry.path()));
        ASSERT_TRUE(image) << image.error().message;
        EXPECT_EQ(image->format, PixelFormat::Rgb8);
        EXPECT_EQ(image->width, width);
        EXPECT_EQ(image->height, height);
        EXPECT_EQ(image->depth, 1);
        EXPECT_EQ(image->pixels,
                  test::readRaw(std::filesystem::path(entry.path()).replace_extension(".raw")));
        ++decoded;
    }
    EXPECT_EQ(decoded, 5 * 3 * 3 + 6 * 2 + 6 + 5);
}

/// A file of 3 x 2 pixels, each row 9 bytes and 3 of padding, that the cases spoil one field at a time.
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
    std::vector<int> bytes; // written there
    std::size_t size;       // then cut to this
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
        Refusal{"MagicAlone", 0, {}, 2, Malformed, "BMP: the headers need 54 bytes, the file has 2"},
        Refusal{"HeaderCut", 0, {}, 53, Malformed, "BMP: the headers need 54 bytes, the file has 53"},
        Refusal{"NoPixels",
                0,
                {},
                54,
                Malformed,
                "BMP: pixel data needs 24 bytes from offset 54, the file has 54"},
        Refusal{"LastByte",
                0,
                {},
                77,
                Malformed,
                "BMP: pixel data needs 24 bytes from offset 54, the file has 77"},
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
        Refusal{"Os2",
                14,
                {12},
                78,
                Unsupported,
                "BMP: headers of 40, 52, 56, 64, 108, 124 bytes are read, the file has one of 12"},
        Refusal{"HeaderHuge",
                14,
                {0xFF, 0xFF, 0xFF, 0xFF},
                78,
                Unsupported,
                "BMP: headers of 40, 52, 56, 64, 108, 124 bytes are read, the file has one of 4294967295"},
        Refusal{"LongHeaderCut",
                14,
                {124},
                78,
                Malformed,
                "BMP: pixel data begins at offset 54, within the headers, which end at 138"},
        Refusal{"Palette", 28, {8}, 78, Unsupported, "BMP: 24 bits a pixel are read, the file has 8"},
        Refusal{"Alpha", 28, {32}, 78, Unsupported, "BMP: 24 bits a pixel are read, the file has 32"},
        Refusal{"Rle",
                30,
                {1},
                78,
                Unsupported,
                "BMP: uncompressed files are read, this one's compression is RLE8"},
        Refusal{"CompressionUnknown",
                30,
                {9},
                78,
                Unsupported,
                "BMP: uncompressed files are read, this one's compression is number 9"},
        Refusal{"WidthZero",
                18,
                {0},
                78,
                Malformed,
                "BMP: a picture has at least 1 x 1 pixels, this one says 0 x 2 pixels"},
        Refusal{"HeightZero",
                22,
                {0},
                78,
                Malformed,
                "BMP: a picture has at least 1 x 1 pixels, this one says 3 x 0 pixels"},
        Refusal{"WidthNegative",
                18,
                {0xFD, 0xFF, 0xFF, 0xFF},
                78,
                Malformed,
                "BMP: a picture has at least 1 x 1 pixels, this one says -3 x 2 pixels"},
        Refusal{"HeightSmallestInt",
                22,
                {0, 0, 0, 0x80},
                78,
                TooLarge,
                "BMP: at most 16384 x 16384 pixels are read, the file has 3 x 2147483648 pixels"},
        // 100000 = 0x186A0
        Refusal{"TooWide",
                18,
                {0xA0, 0x86, 1, 0},
                78,
                TooLarge,
                "BMP: at most 16384 x 16384 pixels are read, the file has 100000 x 2 pixels"}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(Bmp, TheLargestExtentIsTheCallersToSay) {
    EXPECT_TRUE(decodePicture(goodFile(), {.maxExtent = 3}));
    const Result<Image> refused = decodePicture(goodFile(), {.maxExtent = 2});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, TooLarge);
}

TEST(Bmp, EveryTruncationIsRefused) {
    const Bytes file = goodFile();
    for (std::size_t size = 0; size < file.size(); ++size) {
        // A copy of exactly that size, so that the sanitizer sees a read beyond its end.
        const Bytes cut(file.begin(), file.begin() + static_cast<std::ptrdiff_t>(size));
        EXPECT_FALSE(decodePicture(cut)) << size << " of " << file.size() << " bytes";
    }
    EXPECT_TRUE(decodePicture(file));
}

TEST(Bmp, FlippedBitsNeverCrashAndNeverGiveHalfAnImage) {
    std::mt19937 random(20); // NOLINT: the same files each time
    int decoded = 0;
    for (int round = 0; round < 20000; ++round) {
        Bytes file = goodFile();
        for (int flips = 1 + static_cast<int>(random() % 4); flips > 0; --flips)
            file[random() % 54] ^= static_cast<std::byte>(1U << (random() % 8));
        const Result<Image> image = decodePicture(file);
        if (!image) {
            EXPECT_FALSE(image.error().message.empty());
            continue;
        }
        ++decoded;
        ASSERT_EQ(image->pixels.size(), image->rowBytes() * static_cast<std::size_t>(image->height));
        ASSERT_LE(image->pixels.size(), 24U) << "more than the file holds";
    }
    EXPECT_GT(decoded, 1000);
    EXPECT_LT(decoded, 19000);
}

} // namespace
} // namespace texplorer

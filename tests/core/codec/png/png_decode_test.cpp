#include "tests/support/made_files.h"
#include "tests/support/png_repair.h"
#include "texplorer/codec/png/png.h"
#include "texplorer/image/patterns/pattern.h"
#include "texplorer/s3tc/surface_pixels.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <random>

namespace texplorer::png_decode_test {
namespace {

struct Expected {
    const char* extension;
    PixelFormat format;
};

constexpr Expected formats[] = {{".l", PixelFormat::Luminance8},
                                {".la", PixelFormat::LuminanceAlpha8},
                                {".rgb", PixelFormat::Rgb8},
                                {".rgba", PixelFormat::Rgba8}};

/// The files of make_png.py: every colour type, depth, interlacing and transparency.
class PngFiles : public test::MadeFiles {
protected:
    static void SetUpTestSuite() { make("fixtures/make_png.py"); }
};

TEST_F(PngFiles, OfEveryVariantGiveThePixelsThatTheyHold) {
    int decoded = 0;
    for (const std::string& name : names(".png")) {
        SCOPED_TRACE(name);
        int width = 0;
        int height = 0;
        ASSERT_EQ(std::sscanf(name.c_str(), "%*[a-z0-9]_%dx%d", &width, &height), 2);
        const Result<TextureImage> texture = decodePng(contents()[name]);
        ASSERT_TRUE(texture) << texture.error().message;
        EXPECT_EQ(texture->format, "PNG");
        EXPECT_FALSE(texture->topFirst);
        EXPECT_TRUE(texture->fileTopFirst);
        EXPECT_THAT(texture->notes, testing::IsEmpty());
        const Image image = toImage(texture->surfaces.at(0));
        EXPECT_EQ(image.width, width);
        EXPECT_EQ(image.height, height);
        for (const Expected& expected : formats) {
            const auto raw = contents().find(name.substr(0, name.size() - 4) + expected.extension);
            if (raw == contents().end())
                continue;
            EXPECT_EQ(image.format, expected.format);
            EXPECT_TRUE(image.pixels == raw->second);
            ++decoded;
        }
    }
    EXPECT_EQ(decoded, 2 * 4 * (2 * (5 + 2 + 4) + 2 + 2));
}

TEST_F(PngFiles, CutAtAnyByteAreRefused) {
    for (const std::string& name : names("_9x7.png")) {
        SCOPED_TRACE(name);
        test::expectRefusedWhenCut(*codecForExtension(".png"), contents()[name]);
    }
}

// With the checksums made right again, or else hardly any damage would get further than to them.
TEST_F(PngFiles, WithFlippedBitsNeverCrashAndNeverGiveHalfAnImage) {
    std::mt19937 random(7); // NOLINT: the same files each time
    test::Outcomes outcomes;
    for (const std::string& name : names("_9x7.png"))
        for (int round = 0; round < 100; ++round) {
            Bytes file = contents()[name];
            test::flipBits(file, 8, random);
            if (round % 4 != 0)
                test::repairPng(file);
            test::countOutcome(*codecForExtension(".png"), file, outcomes);
        }
    EXPECT_GT(outcomes.decoded, 100);
    EXPECT_GT(outcomes.refused, 1000);
}

Bytes bytesOf(std::initializer_list<int> values) {
    Bytes bytes;
    for (const int value : values)
        bytes.push_back(static_cast<std::byte>(value));
    return bytes;
}

/// 2 x 3 pixels of RGB; the IHDR's data begins at 16.
Bytes goodFile() {
    Image image{PixelFormat::Rgb8, 2, 3, 1, {}};
    for (int i = 0; i < 18; ++i)
        image.pixels.push_back(static_cast<std::byte>(i));
    return *encodePng(image);
}

void insertChunk(Bytes& file, std::size_t at, std::string_view type, const Bytes& data) {
    Bytes chunk = bytesOf({0, 0, 0, static_cast<int>(data.size())});
    for (const char c : type)
        chunk.push_back(static_cast<std::byte>(c));
    chunk.insert(chunk.end(), data.begin(), data.end());
    chunk.resize(chunk.size() + 4);
    file.insert(file.begin() + static_cast<std::ptrdiff_t>(at), chunk.begin(), chunk.end());
    test::repairPng(file);
}

struct Refusal {
    const char* name;
    std::size_t offset;
    std::vector<int> bytes; // written there, with the checksums made right
    ErrorCode code;
    const char* message;
};

class PngRefusals : public testing::TestWithParam<Refusal> {};

TEST_P(PngRefusals, SayWhatWasExpectedAndWhatWasFound) {
    Bytes file = goodFile();
    for (std::size_t i = 0; i < GetParam().bytes.size(); ++i)
        file.at(GetParam().offset + i) = static_cast<std::byte>(GetParam().bytes[i]);
    test::repairPng(file);
    const Result<TextureImage> texture = decodePng(file);
    ASSERT_FALSE(texture);
    EXPECT_THAT(texture.error().message, testing::MatchesRegex(GetParam().message));
    EXPECT_EQ(texture.error().code, GetParam().code);
}

using enum ErrorCode;

INSTANTIATE_TEST_SUITE_P(
    All, PngRefusals,
    testing::Values(
        Refusal{
            "Signature", 0, {'P'}, Malformed, "PNG: the file does not begin with PNG's signature of 8 bytes"},
        Refusal{"FirstChunk", 12, {'J'}, Malformed, "PNG: the first chunk is not an IHDR of 13 bytes"},
        Refusal{"WidthZero",
                16,
                {0, 0, 0, 0},
                Malformed,
                "PNG: a picture has at least 1 × 1 pixels, this one has 0 × 3 pixels"},
        Refusal{"TooWide",
                16,
                {0, 1, 0x86, 0xA0},
                TooLarge,
                "PNG: at most 16384 × 16384 pixels are read, the file has 100000 × 3 pixels"},
        Refusal{"Bomb",
                16,
                {0, 0, 0x40, 0, 0, 0, 0x40, 0},
                Malformed,
                "PNG: 16384 × 16384 pixels need 805322752 bytes, the file's [0-9]+ bytes of pixel data can "
                "hold at most [0-9]+"},
        Refusal{"Depth",
                24,
                {4},
                Malformed,
                "PNG: colour type 2 with 4 bits a sample is not one of the format's 15 combinations"},
        Refusal{"ColorType",
                25,
                {5},
                Malformed,
                "PNG: colour type 5 with 8 bits a sample is not one of the format's 15 combinations"},
        Refusal{"TooFewRows", 20, {0, 0, 0, 30}, Malformed, "PNG: .*[Nn]ot enough image data.*offset.*"},
        Refusal{"NoPalette", 25, {3}, Malformed, "PNG: .*[Mm]issing PLTE.*offset.*"}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(PngDecode, AnEmptyFileIsRefused) {
    EXPECT_EQ(decodePng({}).error().message, "PNG: the file is empty");
}

TEST(PngDecode, AWrongChecksumOfPixelDataIsRefused) {
    Bytes file = goodFile();
    file[file.size() - 12 - 1] ^= std::byte{1}; // before IEND's 12 bytes
    const Result<TextureImage> texture = decodePng(file);
    ASSERT_FALSE(texture);
    EXPECT_THAT(texture.error().message, testing::StartsWith("PNG: IDAT: CRC error"));
}

TEST(PngDecode, AnEarlyEndIsToldInBytes) {
    Bytes file = goodFile();
    const std::size_t whole = file.size();
    file.resize(whole - 2);
    EXPECT_EQ(decodePng(file).error().message,
              "PNG: the file ends early: 4 more bytes were expected at offset " + std::to_string(whole - 4) +
                  ", the file has " + std::to_string(whole - 2));
}

TEST(PngDecode, LimitsAreTheCallersToSay) {
    const Bytes file = goodFile();
    EXPECT_TRUE(decodePng(file, {.maxExtent = 3, .maxPixels = 6, .maxBytes = 18}));
    EXPECT_EQ(decodePng(file, {.maxExtent = 2}).error().code, TooLarge);
    EXPECT_EQ(decodePng(file, {.maxPixels = 5}).error().message,
              "PNG: at most 5 pixels are read, the file has 6");
    EXPECT_EQ(decodePng(file, {.maxBytes = 17}).error().message,
              "PNG: at most 17 bytes of pixels are read, the file has 18");
    std::stop_source source;
    const std::stop_token stop = source.get_token();
    EXPECT_TRUE(decodePng(file, {.stop = &stop}));
    source.request_stop();
    EXPECT_EQ(decodePng(file, {.stop = &stop}).error().code, ErrorCode::Cancelled);
}

TEST(PngDecode, GammaChangesNoPixel) {
    Bytes file = goodFile();
    insertChunk(file, 33, "gAMA", bytesOf({0, 0, 0x27, 0x10})); // 0.1
    const Result<TextureImage> texture = decodePng(file);
    ASSERT_TRUE(texture) << texture.error().message;
    EXPECT_FALSE(texture->srgb);
    EXPECT_EQ(std::get<Image>(texture->surfaces[0]), std::get<Image>(decodePng(goodFile())->surfaces[0]));
}

TEST(PngDecode, AnSrgbChunkIsSaid) {
    Bytes file = goodFile();
    insertChunk(file, 33, "sRGB", bytesOf({0}));
    EXPECT_TRUE(decodePng(file)->srgb);
}

TEST(PngDecode, WhatIsSurvivedIsNoted) {
    Bytes file = goodFile();
    insertChunk(file, 33, "acTL", bytesOf({0, 0, 0, 2, 0, 0, 0, 0}));
    insertChunk(file, 33, "gAMA", bytesOf({0, 0, 0x27})); // a byte short
    file.push_back(std::byte{0});
    const Result<TextureImage> texture = decodePng(file);
    ASSERT_TRUE(texture) << texture.error().message;
    EXPECT_THAT(texture->notes, testing::ElementsAre(testing::MatchesRegex("recovered: gAMA: .*"),
                                                     "1 byte after the end (IEND) ignored"));
    EXPECT_THAT(texture->remarks,
                testing::ElementsAre("the file is an animation; its first picture is read"));
    EXPECT_THAT(texture->losses, testing::ElementsAre(Loss{"frames", "1 of the animation's 2 pictures"}));
}

TEST(PngDecode, WhatStandsBesideThePictureIsKeptForAnotherPng) {
    Bytes file = goodFile();
    insertChunk(file, 33, "tIME", bytesOf({7, 0xE8, 1, 2, 3, 4, 5}));
    insertChunk(file, 33, "tEXt", bytesOf({'a', 0, 'b'}));
    insertChunk(file, 33, "gAMA", bytesOf({0, 0, 0x27})); // a byte short: left out
    Bytes primaries(32, std::byte{0});
    primaries[0] = std::byte{0x80}; // a number that no version of libpng takes
    insertChunk(file, 33, "cHRM", primaries);
    EXPECT_THAT(decodePng(file)->parts, testing::IsEmpty());
    const Result<TextureImage> texture = decodePng(file, {.everything = true});
    ASSERT_TRUE(texture) << texture.error().message;
    EXPECT_THAT(texture->parts, testing::ElementsAre(testing::Field(&FilePart::name, "tEXt")));
    EXPECT_THAT(texture->losses, testing::ElementsAre(Loss{"metadata", "the chunks tIME", false}));
    const Result<Bytes> again = encodePng(*texture, {});
    ASSERT_TRUE(again) << again.error().message;
    const Result<TextureImage> copy = decodePng(*again, {.everything = true});
    ASSERT_EQ(copy->parts.size(), 1U);
    EXPECT_EQ(copy->parts.front().data, bytesOf({'a', 0, 'b'}));
}

TEST(PngEncode, SaysSrgbOfATextureThatIs) {
    TextureImage texture = *decodePng(goodFile());
    EXPECT_FALSE(decodePng(*encodePng(texture, {}))->srgb);
    texture.srgb = true;
    EXPECT_TRUE(decodePng(*encodePng(texture, {}))->srgb);
}

const Field* fieldNamed(const Anatomy& anatomy, std::string_view name) {
    for (const Field& field : anatomy.fields)
        if (field.name.english() == name)
            return &field;
    return nullptr;
}

TEST(PngAnatomy, NamesChunksAndTheFieldsOfTheHeader) {
    const Bytes file = goodFile();
    const Anatomy anatomy = dissectPng(file);
    EXPECT_EQ(anatomy.damage, "");
    for (const Field& field : anatomy.fields)
        EXPECT_EQ(field.wrong, "") << field.name;
    ASSERT_NE(fieldNamed(anatomy, "width"), nullptr);
    EXPECT_EQ(fieldNamed(anatomy, "width")->offset, 16U);
    EXPECT_EQ(fieldNamed(anatomy, "width")->value, "2");
    EXPECT_EQ(fieldNamed(anatomy, "height")->value, "3");
    EXPECT_EQ(fieldNamed(anatomy, "bit depth")->value, "8");
    EXPECT_EQ(fieldNamed(anatomy, "colour type")->meaning, "RGB");
    ASSERT_NE(fieldNamed(anatomy, "IEND"), nullptr);
    EXPECT_EQ(fieldNamed(anatomy, "IEND")->offset, file.size() - 12);
}

TEST(PngAnatomy, SaysWhatLooksWrong) {
    Bytes file = goodFile();
    file[24] = std::byte{3};
    insertChunk(file, 33, "IHDR", bytesOf({}));
    file[29] ^= std::byte{1}; // of the first checksum
    const Anatomy anatomy = dissectPng(file);
    EXPECT_EQ(fieldNamed(anatomy, "bit depth")->wrong, "expected 1, 2, 4, 8 or 16");
    EXPECT_THAT(fieldNamed(anatomy, "CRC")->wrong, testing::StartsWith("the bytes give 0x"));
    EXPECT_TRUE(
        std::ranges::any_of(anatomy.fields, [](const Field& f) { return f.wrong == "a second IHDR"; }));
}

TEST(PngAnatomy, GoesOnToWhereTheFileEnds) {
    const Bytes file = goodFile();
    EXPECT_EQ(dissectPng(ByteView(file).first(40)).damage, "the file ends at offset 40 without an IEND");
    EXPECT_THAT(dissectPng(ByteView(file).first(file.size() - 1)).damage,
                testing::HasSubstr("the chunk IEND at offset"));
}

TEST(PngAnatomy, EndsAtAChunkOfMoreBytesThan32BitsCount) {
    Bytes file = goodFile();
    file.resize(16);
    std::ranges::fill(std::span(file).subspan(8, 3), std::byte{0xFF});
    file[11] = std::byte{0xF4}; // with its frame of twelve bytes: 2^32
    EXPECT_EQ(dissectPng(file).damage, "the chunk IHDR at offset 8 needs 4294967296 bytes, the file has 16");
}

TEST(PngDecode, ReadsWhatTheEncoderWrites) {
    const Image image = drawPattern(Pattern::Tree);
    for (const bool small : {false, true})
        EXPECT_EQ(std::get<Image>(decodePng(*encodePng(image, {.small = small}))->surfaces[0]), image);
}

} // namespace
} // namespace texplorer::png_decode_test

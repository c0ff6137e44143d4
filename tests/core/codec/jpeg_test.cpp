#include "core/codec/jpeg.h"
#include "core/codec/jpeg_markers.h"
#include "tests/support/made_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <map>
#include <random>

namespace texplorer {
namespace {

/// The files of make_jpeg.py.
class JpegFiles : public test::MadeFiles {
protected:
    static void SetUpTestSuite() { make("fixtures/make_jpeg.py"); }
    static std::size_t offsetOf(const Bytes& file, std::uint8_t marker) {
        JpegSegments segments(file);
        while (const std::optional<JpegSegment> segment = segments.next())
            if (segment->marker == marker)
                return segment->offset;
        return 0;
    }
};

TEST_F(JpegFiles, GiveThePixelsThatPillowReads) {
    int decoded = 0;
    for (const std::string& name : names(".jpg")) {
        SCOPED_TRACE(name);
        int width = 0;
        int height = 0;
        ASSERT_EQ(std::sscanf(name.c_str(), "%*[a-z0-9]_%dx%d", &width, &height), 2);
        const Result<TextureImage> texture = decodeJpeg(contents()[name]);
        ASSERT_TRUE(texture) << texture.error().message;
        const Image image = toImage(texture->surfaces.at(0));
        EXPECT_EQ(image.width, width);
        EXPECT_EQ(image.height, height);
        const std::string stem = name.substr(0, name.size() - 4);
        const bool grey = contents().contains(stem + ".l");
        EXPECT_EQ(image.format, grey ? PixelFormat::Luminance8 : PixelFormat::Rgb8);
        const Bytes& expected = contents()[stem + (grey ? ".l" : ".rgb")];
        ASSERT_EQ(image.pixels.size(), expected.size());
        // Pillow rounds its conversion of CMYK otherwise than we do.
        const int tolerance = name.find("cmyk") != std::string::npos ? 1 : 0;
        for (std::size_t i = 0; i < expected.size(); ++i)
            ASSERT_NEAR(std::to_integer<int>(image.pixels[i]), std::to_integer<int>(expected[i]), tolerance)
                << "byte " << i;
        if (name.starts_with("turned"))
            EXPECT_THAT(texture->notes, testing::ElementsAre(testing::HasSubstr("orientation 6")));
        else
            EXPECT_THAT(texture->notes, testing::IsEmpty());
        ++decoded;
    }
    EXPECT_EQ(decoded, 3 * (2 * 5 + 2));
}

TEST_F(JpegFiles, CutAtAnyByteAreRefused) {
    for (const std::string& name : names("_7x5.jpg")) {
        SCOPED_TRACE(name);
        test::expectRefusedWhenCut(*codecForExtension(".jpg"), contents()[name]);
    }
}

TEST_F(JpegFiles, WithFlippedBitsNeverCrashAndNeverGiveHalfAnImage) {
    std::mt19937 random(11); // NOLINT: the same files each time
    test::Outcomes outcomes;
    for (const std::string& name : names("_65x33.jpg"))
        for (int round = 0; round < 100; ++round) {
            Bytes file = contents()[name];
            test::flipBits(file, 2, random);
            test::countOutcome(*codecForExtension(".jpg"), file, outcomes);
        }
    EXPECT_GT(outcomes.decoded, 100);
    EXPECT_GT(outcomes.refused, 100);
}

TEST_F(JpegFiles, WhoseExtentsLieAreRefusedBeforeAnythingIsAllocated) {
    Bytes file = contents()["baseline420_7x5.jpg"];
    const std::size_t frame = offsetOf(file, jpegSof0);
    for (const std::size_t i : {5U, 7U}) { // height and width: 16384
        file[frame + i] = std::byte{0x40};
        file[frame + i + 1] = std::byte{0};
    }
    const Result<TextureImage> texture = decodeJpeg(file);
    ASSERT_FALSE(texture);
    // 2048 x 2048 blocks of luminance, a quarter of that for each of the others
    EXPECT_EQ(texture.error().message,
              "JPEG: 16384 x 16384 pixels need 6291456 coded blocks of at least 1 bit each, the file has " +
                  std::to_string(file.size()) + " bytes");
    file[frame + 5] = std::byte{0xFF};
    EXPECT_EQ(decodeJpeg(file).error().message,
              "JPEG: at most 16384 x 16384 pixels are read, the file has 16384 x 65280 pixels");
}

TEST_F(JpegFiles, LimitsAreTheCallersToSay) {
    const Bytes& file = contents()["baseline444_7x5.jpg"];
    EXPECT_TRUE(decodeJpeg(file, {.maxExtent = 7, .maxPixels = 35, .maxBytes = 105}));
    EXPECT_EQ(decodeJpeg(file, {.maxExtent = 6}).error().code, ErrorCode::TooLarge);
    EXPECT_EQ(decodeJpeg(file, {.maxPixels = 34}).error().message,
              "JPEG: at most 34 pixels are read, the file has 35");
    EXPECT_EQ(decodeJpeg(file, {.maxBytes = 104}).error().message,
              "JPEG: at most 104 bytes of pixels are read, the file has 105");
}

TEST_F(JpegFiles, WithStrayBytesAreReadAndTheyAreNoted) {
    Bytes file = contents()["baseline444_7x5.jpg"];
    const Image whole = std::get<Image>(decodeJpeg(file)->surfaces[0]);
    file.insert(file.begin() + static_cast<std::ptrdiff_t>(offsetOf(file, jpegDqt)), 3, std::byte{0x11});
    file.push_back(std::byte{0});
    file.push_back(std::byte{0});
    const Result<TextureImage> texture = decodeJpeg(file);
    ASSERT_TRUE(texture) << texture.error().message;
    EXPECT_EQ(std::get<Image>(texture->surfaces[0]), whole);
    EXPECT_THAT(texture->notes, testing::ElementsAre(testing::HasSubstr("3 extraneous bytes"),
                                                     "2 bytes behind the end (EOI) left out"));
}

TEST_F(JpegFiles, OfTwelveBitsOrWithoutLossAreRefusedByName) {
    Bytes file = contents()["baseline444_7x5.jpg"];
    const std::size_t frame = offsetOf(file, jpegSof0);
    file[frame + 4] = std::byte{12};
    EXPECT_THAT(decodeJpeg(file).error().message, testing::HasSubstr("precision 12"));
    file[frame + 4] = std::byte{8};
    file[frame + 1] = std::byte{0xC3};
    EXPECT_THAT(decodeJpeg(file).error().message, testing::HasSubstr("0xc3"));
}

TEST_F(JpegFiles, AreDissectedToWhereTheyEnd) {
    const Bytes& file = contents()["baseline420_7x5.jpg"];
    const Anatomy anatomy = dissectJpeg(file);
    EXPECT_EQ(anatomy.damage, "");
    std::map<std::string, Field> fields;
    for (const Field& field : anatomy.fields) {
        EXPECT_EQ(field.wrong, "") << field.name;
        fields[field.name] = field;
    }
    EXPECT_EQ(fields["SOI"].offset, 0U);
    EXPECT_EQ(fields["width"].value, "7");
    EXPECT_EQ(fields["height"].value, "5");
    EXPECT_EQ(fields["width"].offset, offsetOf(file, jpegSof0) + 7);
    EXPECT_EQ(fields["component 1"].value, "2 x 2");
    EXPECT_EQ(fields["EOI"].offset, file.size() - 2);
    EXPECT_EQ(dissectJpeg(ByteView(file).first(10)).damage,
              "APP0 at offset 2 needs 18 bytes, the file has 10");
    EXPECT_EQ(dissectJpeg(ByteView(file).first(file.size() - 2)).damage,
              "the file ends at offset " + std::to_string(file.size() - 2) + " without an EOI");
}

TEST(Jpeg, WhatIsNoJpegIsRefused) {
    EXPECT_EQ(decodeJpeg({}).error().message, "JPEG: the file is empty");
    const std::array<std::byte, 3> start{std::byte{0xFF}, std::byte{0xD8}, std::byte{0xFF}};
    EXPECT_EQ(decodeJpeg(ByteView(start).first(1)).error().message,
              "JPEG: the file does not begin with a start marker (FF D8)");
    EXPECT_EQ(decodeJpeg(start).error().message,
              "JPEG: there is no frame header (SOF) in the 3 bytes of the file");
}

} // namespace
} // namespace texplorer

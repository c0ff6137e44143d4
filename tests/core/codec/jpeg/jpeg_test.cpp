#include "tests/support/made_files.h"
#include "tests/support/python.h"
#include "tests/support/raw_file.h"
#include "tests/support/temp_dir.h"
#include "texplorer/codec/jpeg/jpeg.h"
#include "texplorer/codec/jpeg/jpeg_markers.h"
#include "texplorer/s3tc/surface_pixels.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <jpeglib.h>
#include <map>
#include <random>

namespace texplorer::jpeg_test {
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
        EXPECT_THAT(texture->notes, testing::IsEmpty());
        if (name.starts_with("turned"))
            EXPECT_THAT(texture->remarks, testing::ElementsAre(testing::HasSubstr("orientation 6")));
        else
            EXPECT_THAT(texture->remarks, testing::IsEmpty());
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
              "JPEG: 16384 × 16384 pixels need 6291456 coded blocks of at least 1 bit each, the file has " +
                  std::to_string(file.size()) + " bytes");
    file[frame + 5] = std::byte{0xFF};
    EXPECT_EQ(decodeJpeg(file).error().message,
              "JPEG: at most 16384 × 16384 pixels are read, the file has 16384 × 65280 pixels");
}

TEST_F(JpegFiles, LimitsAreTheCallersToSay) {
    const Bytes& file = contents()["baseline444_7x5.jpg"];
    EXPECT_TRUE(decodeJpeg(file, {.maxExtent = 7, .maxPixels = 35, .maxBytes = 105}));
    EXPECT_EQ(decodeJpeg(file, {.maxExtent = 6}).error().code, ErrorCode::TooLarge);
    EXPECT_EQ(decodeJpeg(file, {.maxPixels = 34}).error().message,
              "JPEG: at most 34 pixels are read, the file has 35");
    EXPECT_EQ(decodeJpeg(file, {.maxBytes = 104}).error().message,
              "JPEG: at most 104 bytes of pixels are read, the file has 105");
    std::stop_source source;
    const std::stop_token stop = source.get_token();
    EXPECT_TRUE(decodeJpeg(file, {.stop = &stop}));
    source.request_stop();
    EXPECT_EQ(decodeJpeg(file, {.stop = &stop}).error().code, ErrorCode::Cancelled);
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
                                                     "2 bytes after the end (EOI) ignored"));
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
    EXPECT_EQ(fields["component 1"].value, "2 × 2");
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

using Factors = std::array<std::array<int, 2>, 3>; // across and down, of Y, Cb and Cr

/// What libjpeg makes of slopes, with these sampling factors.
Bytes encodedWith(const Factors& factors, int width, int height) {
    jpeg_compress_struct jpeg{};
    jpeg_error_mgr errors{};
    jpeg.err = jpeg_std_error(&errors);
    jpeg_create_compress(&jpeg);
    unsigned char* file = nullptr;
    unsigned long size = 0;
    jpeg_mem_dest(&jpeg, &file, &size);
    jpeg.image_width = static_cast<JDIMENSION>(width);
    jpeg.image_height = static_cast<JDIMENSION>(height);
    jpeg.input_components = 3;
    jpeg.in_color_space = JCS_RGB;
    jpeg_set_defaults(&jpeg);
    jpeg_set_quality(&jpeg, 95, TRUE);
    for (std::size_t i = 0; i < factors.size(); ++i) {
        jpeg.comp_info[i].h_samp_factor = factors[i][0];
        jpeg.comp_info[i].v_samp_factor = factors[i][1];
    }
    jpeg_start_compress(&jpeg, TRUE);
    for (int y = 0; y < height; ++y) {
        std::vector<JSAMPLE> row;
        for (int x = 0; x < width; ++x)
            for (const int value : {255 * x / width, 255 * y / height, 128})
                row.push_back(static_cast<JSAMPLE>(value));
        JSAMPROW start = row.data();
        jpeg_write_scanlines(&jpeg, &start, 1);
    }
    jpeg_finish_compress(&jpeg);
    jpeg_destroy_compress(&jpeg);
    const ByteView written = std::as_bytes(std::span(file, size));
    const Bytes bytes(written.begin(), written.end());
    std::free(file); // NOLINT: libjpeg's allocation
    return bytes;
}

constexpr std::array unusualFactors{
    Factors{{{1, 1}, {2, 2}, {2, 2}}}, Factors{{{2, 2}, {2, 1}, {1, 2}}}, Factors{{{3, 1}, {1, 1}, {1, 1}}},
    Factors{{{1, 3}, {1, 1}, {1, 3}}}, Factors{{{1, 4}, {1, 1}, {1, 2}}}, Factors{{{1, 2}, {2, 1}, {1, 1}}},
    Factors{{{4, 1}, {1, 1}, {2, 1}}}, Factors{{{1, 1}, {1, 1}, {4, 2}}},
};

TEST(Jpeg, UnusualSamplingFactorsGiveThePixelsThatPillowReads) {
    const test::TempDir folder;
    for (const auto& [width, height] : {std::pair{1, 1}, {7, 5}, {65, 33}})
        for (const Factors& factors : unusualFactors) {
            std::string name = "factors";
            for (const auto& [across, down] : factors)
                name += std::to_string(across) + std::to_string(down);
            name += "_" + std::to_string(width) + "x" + std::to_string(height);
            SCOPED_TRACE(name);
            const Bytes file = encodedWith(factors, width, height);
            test::writeRaw(folder.path() / (name + ".jpg"), file);
            const Result<TextureImage> texture = decodeJpeg(file);
            ASSERT_TRUE(texture) << texture.error().message;
            EXPECT_THAT(texture->notes, testing::IsEmpty());
            const Image image = toImage(texture->surfaces.at(0));
            test::writeRaw(folder.path() / (name + ".rgb"), image.pixels);
            EXPECT_EQ(dissectJpeg(file).damage, "");
        }
    EXPECT_TRUE(test::runPython("core/codec/jpeg/jpeg_against_pillow.py", folder.path()));
}

TEST(Jpeg, SamplingFactorsThatDivideNoLargestOneAreRefused) {
    Bytes file = encodedWith({{{4, 1}, {2, 1}, {1, 1}}}, 20, 10);
    JpegSegments segments(file);
    while (const std::optional<JpegSegment> segment = segments.next())
        if (segment->isFrame())
            file[segment->offset + 11] = std::byte{0x31}; // which libjpeg itself doesn't write
    EXPECT_EQ(decodeJpeg(file).error().message,
              "JPEG: sampling factors must divide the largest, the components have 3 × 1, 2 × 1, 1 × 1");
}

TEST(Jpeg, ThatEndsEarlyIsRefusedInItsOwnWords) {
    Bytes file = encodedWith(unusualFactors[0], 65, 33);
    file.resize(file.size() - 2);
    EXPECT_EQ(decodeJpeg(file).error().message,
              "JPEG: Premature end of JPEG file (the file has " + std::to_string(file.size()) + " bytes)");
}

TEST(Jpeg, OfTwoComponentsIsRefused) {
    Bytes file = encodedWith({{{1, 1}, {1, 1}, {1, 1}}}, 8, 8);
    JpegSegments segments(file);
    while (const std::optional<JpegSegment> segment = segments.next())
        if (segment->isFrame()) {
            file.erase(file.begin() + static_cast<std::ptrdiff_t>(segment->offset + 16),
                       file.begin() + static_cast<std::ptrdiff_t>(segment->offset + 19));
            file[segment->offset + 3] = std::byte{14};
            file[segment->offset + 9] = std::byte{2};
            break;
        }
    const Result<TextureImage> texture = decodeJpeg(file);
    ASSERT_FALSE(texture);
    EXPECT_EQ(
        texture.error().message,
        "JPEG: only pictures with 1 (grey), 3 (colour) or 4 (CMYK) components are read, this one has 2");
    EXPECT_EQ(texture.error().code, ErrorCode::Unsupported);
}

} // namespace
} // namespace texplorer::jpeg_test

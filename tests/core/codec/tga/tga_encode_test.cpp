#include "tests/support/python.h"
#include "tests/support/raw_file.h"
#include "tests/support/temp_dir.h"
#include "texplorer/codec/tga/tga.h"
#include "texplorer/s3tc/surface_pixels.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

namespace texplorer::tga_encode_test {
namespace {

/// Noise with runs of all lengths in it.
Image noisyImage(PixelFormat format, int width, int height, unsigned seed) {
    std::mt19937 random(seed); // NOLINT: the same pictures each time
    Image image = Image::uninitialised(format, width, height);
    const auto size = static_cast<std::size_t>(bytesPerPixel(format));
    std::array<std::byte, 4> pixel{};
    std::size_t run = 0;
    for (std::size_t at = 0; at < image.pixels.size(); at += size) {
        if (run == 0) {
            run = random() % 3 == 0 ? 1 + random() % 300 : 1;
            for (std::byte& component : pixel)
                component = static_cast<std::byte>(random() % 3 * 100);
        }
        --run;
        std::copy_n(pixel.begin(), size, image.pixels.begin() + static_cast<std::ptrdiff_t>(at));
    }
    return image;
}

struct FormatRow {
    const char* name; // as the script knows it
    PixelFormat format;
};

constexpr std::array formats{FormatRow{"l", PixelFormat::Luminance8},
                             FormatRow{"la", PixelFormat::LuminanceAlpha8},
                             FormatRow{"rgb", PixelFormat::Rgb8}, FormatRow{"rgba", PixelFormat::Rgba8}};

TEST(TgaWriter, OthersAndWeReadWhatWasWritten) {
    const test::TempDir folder;
    unsigned number = 0;
    for (const FormatRow& row : formats)
        for (const auto& [width, height] : {std::pair{1, 1}, {2, 3}, {127, 2}, {128, 2}, {129, 3}, {700, 5}})
            for (const bool runLengthCoded : {false, true})
                for (const bool topFirst : {false, true}) {
                    TextureImage texture =
                        textureOf(noisyImage(row.format, width, height, number), "picture");
                    texture.topFirst = topFirst;
                    const std::string name = std::to_string(number++) + "_" + row.name + "_" +
                                             std::to_string(width) + "x" + std::to_string(height);
                    SCOPED_TRACE(name);
                    const Result<Bytes> file = encodeTga(texture, {.runLengthCoded = runLengthCoded});
                    ASSERT_TRUE(file);
                    const Image picture = uprightImage(texture);
                    test::writeRaw(folder / (name + ".tga"), *file);
                    test::writeRaw(folder / (name + ".raw"), picture.pixels);

                    const Result<TextureImage> again = decodeTga(*file);
                    ASSERT_TRUE(again) << again.error().message;
                    EXPECT_EQ(again->fileTopFirst, topFirst);
                    EXPECT_EQ(again->alpha, texture.alpha);
                    EXPECT_THAT(again->notes, testing::IsEmpty());
                    EXPECT_EQ(uprightImage(*again), picture);
                    EXPECT_EQ(dissectTga(*file).damage, "");
                }
    EXPECT_TRUE(test::runPython("core/codec/tga/tga_against_pillow.py", folder.path()));
}

struct MeaningCase {
    const char* name;
    AlphaMeaning meaning;
    int bits;           // a pixel
    int attributesType; // byte 494 of the extension area
};

class TgaWriterAlpha : public testing::TestWithParam<MeaningCase> {};

TEST_P(TgaWriterAlpha, IsSaidInTheExtensionArea) {
    TextureImage texture = textureOf(noisyImage(PixelFormat::Rgba8, 9, 5, 1), "picture");
    texture.alpha = GetParam().meaning;
    const Result<Bytes> file = encodeTga(texture);
    ASSERT_TRUE(file);
    EXPECT_EQ(std::to_integer<int>((*file)[16]), GetParam().bits);
    EXPECT_EQ(std::to_integer<int>((*file)[file->size() - 26 - 1]), GetParam().attributesType);
    const Result<TextureImage> again = decodeTga(*file);
    ASSERT_TRUE(again);
    EXPECT_EQ(again->alpha, GetParam().meaning);
}

INSTANTIATE_TEST_SUITE_P(All, TgaWriterAlpha,
                         testing::Values(MeaningCase{"None", AlphaMeaning::None, 24, 0},
                                         MeaningCase{"Unknown", AlphaMeaning::Unknown, 32, 2},
                                         MeaningCase{"Straight", AlphaMeaning::Straight, 32, 3},
                                         MeaningCase{"Premultiplied", AlphaMeaning::Premultiplied, 32, 4}),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(TgaWriter, GreyWithoutMeaningfulAlphaIsEightBits) {
    TextureImage texture = textureOf({PixelFormat::LuminanceAlpha8, 2, 1, 1, Bytes{}}, "picture");
    std::get<Image>(texture.surfaces[0]).pixels = {std::byte{10}, std::byte{0}, std::byte{20}, std::byte{0}};
    texture.alpha = AlphaMeaning::None;
    const Result<Bytes> file = encodeTga(texture);
    ASSERT_TRUE(file);
    EXPECT_EQ((*file)[16], std::byte{8});
    EXPECT_EQ((*file)[18], std::byte{10});
    EXPECT_EQ((*file)[19], std::byte{20});
}

TEST(TgaWriter, AlphaAloneBecomesGrey) {
    const Result<Bytes> file = encodeTga(textureOf(noisyImage(PixelFormat::Alpha8, 4, 4, 3), "picture"));
    ASSERT_TRUE(file);
    const Result<TextureImage> again = decodeTga(*file);
    ASSERT_TRUE(again);
    EXPECT_EQ(std::get<Image>(again->surfaces[0]).format, PixelFormat::Luminance8);
    EXPECT_EQ(std::get<Image>(again->surfaces[0]).pixels, noisyImage(PixelFormat::Alpha8, 4, 4, 3).pixels);
}

TEST(TgaWriter, CompressedPicturesAreDecompressed) {
    TextureImage texture;
    texture.surfaces.emplace_back(BlockImage::uninitialised(BlockFormat::Dxt1, 4, 4));
    // Both colours are red in 5:6:5 (0xF800); every texel is the first.
    std::get<BlockImage>(texture.surfaces[0]).blocks = {std::byte{0},    std::byte{0xF8}, std::byte{0},
                                                        std::byte{0xF8}, std::byte{0},    std::byte{0},
                                                        std::byte{0},    std::byte{0}};
    const Result<Bytes> file = encodeTga(texture);
    ASSERT_TRUE(file);
    const Result<TextureImage> again = decodeTga(*file);
    ASSERT_TRUE(again);
    const Image image = uprightImage(*again);
    EXPECT_EQ(image.format, PixelFormat::Rgb8);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        ASSERT_EQ(image.pixels[i], static_cast<std::byte>(i % 3 == 0 ? 255 : 0));
}

TEST(TgaWriter, NoisyPicturesGrowByTheirPacketsAtMost) {
    Image image = Image::uninitialised(PixelFormat::Luminance8, 300, 7);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        image.pixels[i] = static_cast<std::byte>(i * 97);
    const Result<Bytes> file = encodeTga(textureOf(image, "picture"), {.runLengthCoded = true});
    ASSERT_TRUE(file);
    EXPECT_EQ(file->size(), 18U + 7 * (300 + 3) + 495 + 26) << "three packets a row";
}

struct Refusal {
    const char* name;
    TextureImage texture;
    const char* message;
};

TEST(TgaWriter, SaysWhatItCannotWrite) {
    const auto picture = [](int width, int height, std::size_t bytes) {
        return textureOf(Image{PixelFormat::Rgb8, width, height, 1, Bytes(bytes)}, "picture");
    };
    for (const Refusal& row :
         {Refusal{"no surface", {}, "TGA: there is no picture to write"},
          Refusal{"empty", picture(0, 0, 0),
                  "TGA: a picture has 1 to 65535 pixels along each axis, this one has 0 × 0"},
          Refusal{"wide", picture(65536, 1, 3 * 65536),
                  "TGA: a picture has 1 to 65535 pixels along each axis, this one has 65536 × 1"},
          Refusal{"short", picture(2, 2, 11), "TGA: the picture needs 12 bytes, it has 11"}}) {
        const Result<Bytes> file = encodeTga(row.texture);
        ASSERT_FALSE(file) << row.name;
        EXPECT_EQ(file.error().message, row.message);
    }
}

} // namespace
} // namespace texplorer::tga_encode_test

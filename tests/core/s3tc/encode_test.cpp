// libsquish and stb_dxt are asked directly for what they make of the same picture.

#include "tests/core/s3tc/squish_oracle.h"
#include "texplorer/image/patterns/pattern.h"
#include "texplorer/s3tc/decode.h"
#include "texplorer/s3tc/encode.h"
#include "texplorer/s3tc/flip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>

#define STB_DXT_STATIC
#define STB_DXT_IMPLEMENTATION
#include <stb/stb_dxt.h>

namespace texplorer::encode_test {
namespace {

/// Slopes, waves and a little noise in all four channels.
Image picture(int width, int height) {
    Image image = Image::uninitialised(PixelFormat::Rgba8, width, height);
    std::mt19937 random(5);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const double wave = 60 * std::sin(0.13 * x) * std::cos(0.07 * y);
            const auto channel = [&](double value) {
                return static_cast<std::byte>(
                    std::clamp(value + static_cast<double>(random() % 9), 0.0, 255.0));
            };
            const auto pixel = image.at(x, y);
            pixel[0] = channel(120 + wave);
            pixel[1] = channel(90 - wave / 2 + y % 64);
            pixel[2] = channel(140 + x % 64);
            pixel[3] = channel(170 + wave / 2);
        }
    return image;
}

/// In dB, over the channels that the format keeps.
double psnr(const Image& a, const Image& b, BlockFormat format) {
    std::size_t channels = 4;
    if (format == BlockFormat::Dxt1 || format == BlockFormat::Dxt1Alpha)
        channels = 3;
    if (format == BlockFormat::Bc4)
        channels = 1;
    if (format == BlockFormat::Bc5)
        channels = 2;
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i)
        if (i % 4 < channels) {
            const double difference = std::to_integer<int>(a.pixels[i]) - std::to_integer<int>(b.pixels[i]);
            sum += difference * difference;
            ++count;
        }
    return sum == 0 ? 99 : 10 * std::log10(255.0 * 255.0 * static_cast<double>(count) / sum);
}

constexpr std::array encodable{
    rowOf(BlockFormat::Dxt1), rowOf(BlockFormat::Dxt1Alpha), rowOf(BlockFormat::Dxt3),
    rowOf(BlockFormat::Dxt5), rowOf(BlockFormat::Bc4),       rowOf(BlockFormat::Bc5),
};

class EveryFormatAndQuality : public testing::TestWithParam<std::tuple<EnumRow, EnumRow>> {
protected:
    [[nodiscard]] static BlockFormat format() {
        return static_cast<BlockFormat>(std::get<0>(GetParam()).value);
    }
    [[nodiscard]] static EncodeQuality quality() {
        return static_cast<EncodeQuality>(std::get<1>(GetParam()).value);
    }
    [[nodiscard]] static Image encodedAndDecoded(const Image& image) {
        return decodeBlocks(encodeBlocks(image, format(), quality()).value());
    }
};

TEST_P(EveryFormatAndQuality, KeepsThePictureAtEverySize) {
    for (const auto& [width, height] : {std::pair{1, 1}, {2, 3}, {5, 7}, {16, 16}, {33, 18}, {4, 1}}) {
        const Image image = picture(width, height);
        const Image found = encodedAndDecoded(image);
        ASSERT_EQ(found.width, width);
        ASSERT_EQ(found.height, height);
        EXPECT_GT(psnr(image, found, format()), 30) << width << " x " << height;
    }
}

TEST_P(EveryFormatAndQuality, RepeatsTheEdge) {
    const Image small = picture(3, 2);
    Image padded = Image::uninitialised(PixelFormat::Rgba8, 4, 4);
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 4; ++x)
            std::memcpy(padded.at(x, y).data(), small.at(std::min(x, 2), std::min(y, 1)).data(), 4);
    EXPECT_EQ(encodeBlocks(small, format(), quality()).value().blocks,
              encodeBlocks(padded, format(), quality()).value().blocks);
}

TEST_P(EveryFormatAndQuality, GivesTheSameWithAnyNumberOfThreads) {
    const Image image = picture(128, 192);
    const BlockImage alone = encodeBlocks(image, format(), quality(), {}, {}, 1).value();
    EXPECT_EQ(encodeBlocks(image, format(), quality(), {}, {}, 7).value(), alone);
    EXPECT_EQ(encodeBlocks(image, format(), quality()).value(), alone);
}

TEST_P(EveryFormatAndQuality, IsAsGoodAsTheLibraryItself) {
    const Image image = picture(64, 64);
    Image source = image;
    if (format() == BlockFormat::Dxt1)
        for (std::size_t i = 3; i < source.pixels.size(); i += 4)
            source.pixels[i] = std::byte{255};
    const auto* rgba = reinterpret_cast<const squish::u8*>(source.pixels.data());
    BlockImage peer = BlockImage::uninitialised(format(), 64, 64);
    const bool isBest = quality() == EncodeQuality::Best;
    const int fit = isBest ? squish::kColourClusterFit : squish::kColourRangeFit;
    squish::CompressImage(rgba, 64, 64, peer.blocks.data(), squishFlag(format()) | fit);
    double expected = psnr(image, decodeBlocks(peer), format());
    if (!isBest && format() == BlockFormat::Dxt1) {
        const int mode = quality() == EncodeQuality::Fast ? STB_DXT_NORMAL : STB_DXT_HIGHQUAL;
        for (int at = 0; at < 256; ++at) {
            std::array<unsigned char, 64> texels;
            for (int y = 0; y < 4; ++y)
                std::memcpy(texels.data() + 16 * y, source.at(at % 16 * 4, at / 16 * 4 + y).data(), 16);
            stb_compress_dxt_block(reinterpret_cast<unsigned char*>(peer.blocks.data()) + 8 * at,
                                   texels.data(), 0, mode);
        }
        expected = psnr(image, decodeBlocks(peer), format());
    } else if (quality() == EncodeQuality::Fast) {
        expected -= 0.5; // libsquish fits values better than stb_dxt does
    }
    EXPECT_GE(psnr(image, encodedAndDecoded(image), format()), expected);
}

INSTANTIATE_TEST_SUITE_P(Rows, EveryFormatAndQuality,
                         testing::Combine(testing::ValuesIn(encodable), testing::ValuesIn(encodeQualityRows)),
                         [](const auto& test) {
                             return std::string(std::get<0>(test.param).name) + "_" +
                                    std::string(std::get<1>(test.param).name);
                         });

/// Noise of every size, the larger the stronger, as photographs have it; alpha is a slope.
Image photoLikeNoise(int side) {
    std::mt19937 random(7);
    std::vector<double> sums(static_cast<std::size_t>(side) * static_cast<std::size_t>(side) * 3);
    for (int cells = 4; cells <= side; cells *= 2) {
        std::vector<double> grid(static_cast<std::size_t>((cells + 1) * (cells + 1)) * 3);
        for (double& each : grid)
            each = (static_cast<double>(random() % 256) - 128) / cells * 4;
        for (std::size_t i = 0; i < sums.size(); ++i) {
            const int texel = static_cast<int>(i / 3);
            const double x = texel % side * static_cast<double>(cells) / side;
            const double y = texel / side * static_cast<double>(cells) / side;
            const auto at = [&](int dx, int dy) {
                const int place = (static_cast<int>(y) + dy) * (cells + 1) + static_cast<int>(x) + dx;
                return grid[static_cast<std::size_t>(place) * 3 + i % 3];
            };
            const double u = x - std::floor(x);
            const double v = y - std::floor(y);
            sums[i] +=
                (1 - v) * ((1 - u) * at(0, 0) + u * at(1, 0)) + v * ((1 - u) * at(0, 1) + u * at(1, 1));
        }
    }
    Image image = Image::uninitialised(PixelFormat::Rgba8, side, side);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            for (std::size_t i = 0; i < 3; ++i)
                image.at(x, y)[i] = static_cast<std::byte>(
                    std::clamp(128 + sums[static_cast<std::size_t>(y * side + x) * 3 + i], 0.0, 255.0));
            image.at(x, y)[3] = static_cast<std::byte>(x * 255 / (side - 1));
        }
    return image;
}

// As libsquish decodes it. That it takes longer is for `./dev bench`.
TEST(EncodeBlocks, EachQualityIsBetterThanTheOneBefore) {
    for (const Image& image : {drawPattern(Pattern::Planet), photoLikeNoise(128)}) {
        Image colors = Image::uninitialised(PixelFormat::Rgba8, image.width, image.height);
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x) {
                colors.at(x, y)[3] = std::byte{255};
                std::memcpy(colors.at(x, y).data(), image.at(x, y).data(), image.at(x, y).size());
            }
        for (const BlockFormat format : {BlockFormat::Dxt1, BlockFormat::Dxt3, BlockFormat::Dxt5}) {
            double before = 0;
            for (const EncodeQuality quality :
                 {EncodeQuality::Fast, EncodeQuality::Normal, EncodeQuality::Best}) {
                const BlockImage blocks = encodeBlocks(colors, format, quality).value();
                // Colours alone: 3 channels.
                const double now = psnr(colors, decodeWithSquish(blocks), BlockFormat::Dxt1);
                EXPECT_GT(now, before + 0.02) << rowOf(format).name << " " << rowOf(quality).name;
                before = now;
            }
        }
    }
}

/// In dB over the components that a format keeps, as libsquish decodes it, where it does.
double psnrOf(const Image& image, BlockFormat format, EncodeQuality quality) {
    const BlockImage blocks = encodeBlocks(image, format, quality).value();
    const bool isRgtc = format == BlockFormat::Bc4 || format == BlockFormat::Bc5;
    return psnr(image, isRgtc ? decodeBlocks(blocks) : decodeWithSquish(blocks), format);
}

TEST(EncodeBlocks, TheBestIsNotWorseOnASlope) {
    Image slope = Image::uninitialised(PixelFormat::Rgba8, 128, 128);
    for (int y = 0; y < 128; ++y)
        for (int x = 0; x < 128; ++x) {
            const std::array values{x + y / 4, 255 - x - y / 2, 60 + y, 255 - y};
            for (std::size_t i = 0; i < 4; ++i)
                slope.at(x, y)[i] = static_cast<std::byte>(values[i]);
        }
    for (const EnumRow& row : encodable) {
        const auto format = static_cast<BlockFormat>(row.value);
        EXPECT_GE(psnrOf(slope, format, EncodeQuality::Best) + 1e-9,
                  std::max(psnrOf(slope, format, EncodeQuality::Normal),
                           psnrOf(slope, format, EncodeQuality::Fast)))
            << row.name;
    }
}

TEST(EncodeBlocks, MakesAlphaBelow128AHole) {
    Image image = picture(8, 4);
    for (int x = 0; x < 8; ++x)
        for (int y = 0; y < 4; ++y)
            image.at(x, y)[3] = static_cast<std::byte>(x < 4 ? 126 + (x + y) % 4 : 200);
    for (const EnumRow& quality : encodeQualityRows) {
        const auto encode = [&](BlockFormat format) {
            return decodeBlocks(
                encodeBlocks(image, format, static_cast<EncodeQuality>(quality.value)).value());
        };
        const Image holes = encode(BlockFormat::Dxt1Alpha);
        const Image opaque = encode(BlockFormat::Dxt1);
        for (int x = 0; x < 8; ++x)
            for (int y = 0; y < 4; ++y) {
                const int alpha = std::to_integer<int>(image.at(x, y)[3]);
                EXPECT_EQ(std::to_integer<int>(holes.at(x, y)[3]), alpha < 128 ? 0 : 255) << x << " " << y;
                EXPECT_EQ(std::to_integer<int>(opaque.at(x, y)[3]), 255) << x << " " << y;
            }
        EXPECT_GT(psnr(image, opaque, BlockFormat::Dxt1), 30) << quality.name;
    }
}

struct PixelCase {
    const char* name;
    PixelFormat format;
    std::vector<int> pixel;
    std::array<int, 4> rgba;
};

class EveryPixelFormat : public testing::TestWithParam<PixelCase> {};

// 0 and 255 are kept exactly by every encoder.
TEST_P(EveryPixelFormat, IsEncodedAsItsRgba) {
    const PixelCase& row = GetParam();
    Image image = Image::uninitialised(row.format, 3, 3);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        image.pixels[i] = static_cast<std::byte>(row.pixel[i % row.pixel.size()]);
    const Image found = decodeBlocks(encodeBlocks(image, BlockFormat::Dxt5, EncodeQuality::Fast).value());
    for (std::size_t c = 0; c < 4; ++c)
        EXPECT_EQ(std::to_integer<int>(found.at(2, 2)[c]), row.rgba[c]) << c;
}

INSTANTIATE_TEST_SUITE_P(
    Rows, EveryPixelFormat,
    testing::Values(PixelCase{"Alpha", PixelFormat::Alpha8, {77}, {0, 0, 0, 77}},
                    PixelCase{"Luminance", PixelFormat::Luminance8, {255}, {255, 255, 255, 255}},
                    PixelCase{"LuminanceAlpha", PixelFormat::LuminanceAlpha8, {255, 33}, {255, 255, 255, 33}},
                    PixelCase{"Rgb", PixelFormat::Rgb8, {255, 0, 255}, {255, 0, 255, 255}},
                    PixelCase{"Rgba", PixelFormat::Rgba8, {0, 255, 255, 12}, {0, 255, 255, 12}}),
    [](const auto& test) { return std::string(test.param.name); });

struct Refusal {
    const char* name;
    Image image;
    BlockFormat format;
    ErrorCode code;
    const char* message;
};

class EncodeRefuses : public testing::TestWithParam<Refusal> {};

TEST_P(EncodeRefuses, WithASentence) {
    const Result<BlockImage> result = encodeBlocks(GetParam().image, GetParam().format, EncodeQuality::Fast);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, GetParam().code);
    EXPECT_EQ(result.error().message, GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    Rows, EncodeRefuses,
    testing::Values(
        Refusal{"Signed", picture(4, 4), BlockFormat::Bc5Signed, ErrorCode::Unsupported,
                "pictures are not compressed to GL_COMPRESSED_SIGNED_RG_RGTC2: their values are not signed"},
        Refusal{"Volume", Image::uninitialised(PixelFormat::Rgba8, 4, 4, 2), BlockFormat::Dxt1,
                ErrorCode::Unsupported, "volumes are not compressed: expected a depth of 1, found 2"},
        Refusal{"Empty", Image{}, BlockFormat::Dxt1, ErrorCode::OutOfRange,
                "a picture to compress needs at least 1 × 1 × 1 pixels, this one has 0 × 0 × 1"},
        Refusal{"TooFewBytes", Image{PixelFormat::Rgba8, 4, 4, 1, Bytes(63)}, BlockFormat::Dxt1,
                ErrorCode::Malformed, "a picture of 4 × 4 × 1 pixels needs 64 bytes, but has 63"}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(EncodeBlocks, SaysHowFarItIs) {
    std::vector<float> shares;
    ASSERT_TRUE(encodeBlocks(picture(8, 32), BlockFormat::Dxt1, EncodeQuality::Fast,
                             [&](float share) { shares.push_back(share); }));
    EXPECT_EQ(shares, (std::vector<float>{0.125F, 0.25F, 0.375F, 0.5F, 0.625F, 0.75F, 0.875F, 1}));
}

TEST(EncodeBlocks, StopsWhenAsked) {
    std::stop_source source;
    const Result<BlockImage> result = encodeBlocks(
        picture(8, 32), BlockFormat::Dxt1, EncodeQuality::Best,
        [&](float share) {
            if (share >= 0.5F)
                source.request_stop();
        },
        source.get_token(), 1);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::Cancelled);
    EXPECT_EQ(result.error().message, "compressing was stopped after 4 of 8 rows of blocks");
}

struct LossyCase {
    const char* name;
    FlipAxis axis;
    bool x;
    bool y;
};

class DecodeFlipEncode : public testing::TestWithParam<LossyCase> {};

TEST_P(DecodeFlipEncode, TurnsAroundWhatCantBeFlippedWithoutLoss) {
    const BlockImage image = encodeBlocks(picture(11, 6), BlockFormat::Dxt5, EncodeQuality::Best).value();
    const Image before = decodeBlocks(image);
    Image expected = before;
    for (int y = 0; y < 6; ++y)
        for (int x = 0; x < 11; ++x)
            std::memcpy(expected.at(x, y).data(),
                        before.at(GetParam().x ? 10 - x : x, GetParam().y ? 5 - y : y).data(), 4);
    const Result<BlockImage> flipped = decodeFlipEncode(image, GetParam().axis, EncodeQuality::Best);
    ASSERT_TRUE(flipped);
    const double kept = psnr(expected, decodeBlocks(*flipped), BlockFormat::Dxt5);
    EXPECT_GT(kept, 35);
    EXPECT_GT(kept, psnr(before, decodeBlocks(*flipped), BlockFormat::Dxt5));
}

INSTANTIATE_TEST_SUITE_P(Rows, DecodeFlipEncode,
                         testing::Values(LossyCase{"Vertical", FlipAxis::Vertical, false, true},
                                         LossyCase{"Horizontal", FlipAxis::Horizontal, true, false},
                                         LossyCase{"Both", FlipAxis::Both, true, true}),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(DecodeFlipEncodeOfASignedFormat, IsRefused) {
    const BlockImage image = BlockImage::uninitialised(BlockFormat::Bc4Signed, 4, 3);
    const Result<BlockImage> flipped = decodeFlipEncode(image, FlipAxis::Vertical, EncodeQuality::Fast);
    ASSERT_FALSE(flipped);
    EXPECT_EQ(flipped.error().code, ErrorCode::Unsupported);
}

} // namespace
} // namespace texplorer::encode_test

// The driver decompresses the same blocks.

#include "app/render/gl_handle.h"
#include "tests/support/render_fixture.h"
#include "texplorer/s3tc/decode.h"
#include "texplorer/s3tc/flip.h"

#include <GL/glew.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <random>

namespace texplorer::render::s3tc_test {
namespace {

class CompressedTexture : public test::RenderTest, public testing::WithParamInterface<EnumRow> {
protected:
    [[nodiscard]] static BlockFormat format() { return static_cast<BlockFormat>(GetParam().value); }
    [[nodiscard]] static bool isSigned() {
        return format() == BlockFormat::Bc4Signed || format() == BlockFormat::Bc5Signed;
    }

    void SetUp() override {
        RenderTest::SetUp();
        glGenTextures(1, &name_);
        glBindTexture(GL_TEXTURE_2D, name_);
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
    }
    void TearDown() override {
        glDeleteTextures(1, &name_);
        RenderTest::TearDown();
    }

    /// What the driver makes of the blocks; signed components as signed bytes.
    static Image decompressedByTheDriver(const BlockImage& image) {
        glCompressedTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLenum>(image.format), image.width, image.height,
                               0, static_cast<GLsizei>(image.blocks.size()), image.blocks.data());
        Image pixels = Image::uninitialised(PixelFormat::Rgba8, image.width, image.height);
        glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, isSigned() ? GL_BYTE : GL_UNSIGNED_BYTE,
                      pixels.pixels.data());
        EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
        return pixels;
    }

    static BlockImage randomBlocks(int width, int height) {
        BlockImage image = BlockImage::uninitialised(format(), width, height);
        std::mt19937 random(static_cast<unsigned>(width + height));
        for (std::byte& each : image.blocks)
            each = static_cast<std::byte>(random());
        return image;
    }

    /// The largest difference of any channel that the format has.
    static int largestDifference(const Image& ours, const Image& drivers) {
        const bool oneChannel = format() == BlockFormat::Bc4 || format() == BlockFormat::Bc4Signed;
        const bool twoChannels = format() == BlockFormat::Bc5 || format() == BlockFormat::Bc5Signed;
        const std::size_t channels = oneChannel ? 1 : twoChannels ? 2 : 4;
        int largest = 0;
        for (std::size_t i = 0; i < ours.pixels.size(); ++i) {
            if (i % 4 >= channels)
                continue;
            int expected = std::to_integer<int>(drivers.pixels[i]);
            if (isSigned()) // -127 to 127 is our 0 to 255
                expected =
                    ((std::max(-127, static_cast<int>(static_cast<std::int8_t>(expected))) + 127) * 255 +
                     127) /
                    254;
            largest = std::max(largest, std::abs(std::to_integer<int>(ours.pixels[i]) - expected));
        }
        return largest;
    }

private:
    GLuint name_ = 0;
};

/// What core/s3tc/decode.h says about llvmpipe, which rounds the values between the ends in its own way.
int allowedDifference(BlockFormat format) {
    switch (format) {
    case BlockFormat::Dxt1:
    case BlockFormat::Dxt1Alpha:
    case BlockFormat::Dxt3:
        return 1;
    case BlockFormat::Dxt5:
    case BlockFormat::Bc4:
    case BlockFormat::Bc5:
        return 2;
    case BlockFormat::Bc4Signed:
    case BlockFormat::Bc5Signed:
        break;
    }
    return 3;
}

TEST_P(CompressedTexture, IsDecompressedLikeByTheDriver) {
    for (const auto& [width, height] : {std::pair{128, 128}, {5, 7}, {2, 2}, {1, 1}}) {
        const BlockImage image = randomBlocks(width, height);
        EXPECT_LE(largestDifference(decodeBlocks(image), decompressedByTheDriver(image)),
                  allowedDifference(format()))
            << width << " x " << height;
    }
}

/// 65536 blocks with every pair of values, in both halves of those of 16 bytes, and every code.
BlockImage everyPairOfValues(BlockFormat format) {
    BlockImage image = BlockImage::uninitialised(format, 4 * 256, 4 * 256);
    const std::size_t size = bytesPerBlock(format);
    for (std::size_t at = 0; at < image.blocks.size(); ++at) {
        const std::size_t pair = at / size;
        const std::array<std::size_t, 8> bytes{pair & 255, pair >> 8, 0x88, 0xC6, 0xFA, 0x88, 0xC6, 0xFA};
        image.blocks[at] = static_cast<std::byte>(bytes[at % 8]);
    }
    return image;
}

TEST_P(CompressedTexture, IsDecompressedLikeByTheDriverForEveryPairOfValues) {
    const BlockImage image = everyPairOfValues(format());
    EXPECT_EQ(largestDifference(decodeBlocks(image), decompressedByTheDriver(image)),
              allowedDifference(format()));
}

TEST_P(CompressedTexture, IsUpsideDownForTheDriverWhenItsBlocksAreFlipped) {
    for (const auto& [width, height] : {std::pair{64, 32}, {5, 4}, {2, 2}, {1, 1}}) {
        BlockImage image = randomBlocks(width, height);
        const Image before = decompressedByTheDriver(image);
        ASSERT_TRUE(flipVertically(image));
        const Image after = decompressedByTheDriver(image);
        for (int y = 0; y < height; ++y)
            EXPECT_EQ(
                std::memcmp(before.at(0, y).data(), after.at(0, height - 1 - y).data(), before.rowBytes()), 0)
                << width << " x " << height << ", row " << y;
    }
}

/// One channel of a block, worked out by hand.
struct Between {
    const char* name;
    BlockFormat format;
    int first, second, code;
    int ours;   ///< what decode.h promises, of 255
    int driver; ///< a + ((b - a) * w >> 8), of 255, or of 127 where it is signed
};

class ValuesBetween : public test::RenderTest, public testing::WithParamInterface<Between> {};

TEST_P(ValuesBetween, DifferAsTheHeaderSays) {
    const Between& row = GetParam();
    BlockImage image = BlockImage::uninitialised(row.format, 1, 1);
    const std::array bytes{row.first, row.second, row.code, 0, 0, 0, 0, 0};
    std::ranges::transform(bytes, image.blocks.begin(), [](int v) { return static_cast<std::byte>(v); });
    EXPECT_EQ(std::to_integer<int>(decodeBlocks(image).pixels[0]), row.ours);

    const TextureHandle texture = TextureHandle::create();
    glBindTexture(GL_TEXTURE_2D, texture.name());
    glCompressedTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLenum>(row.format), 1, 1, 0, 8,
                           image.blocks.data());
    std::array<std::byte, 4> rgba{};
    const bool isSigned = row.format == BlockFormat::Bc4Signed;
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, isSigned ? GL_BYTE : GL_UNSIGNED_BYTE, rgba.data());
    EXPECT_EQ(isSigned ? static_cast<int>(static_cast<std::int8_t>(rgba[0])) : std::to_integer<int>(rgba[0]),
              row.driver);
}

INSTANTIATE_TEST_SUITE_P(
    Rows, ValuesBetween,
    testing::Values(
        // (255 + 6 * 46) / 7 = 75.86; w = 218, 255 + (-209 * 218 >> 8) = 255 - 178.
        Between{"TwoBelow", BlockFormat::Bc4, 255, 46, 7, 75, 77},
        // (0 + 4 * 197) / 5 = 157.6; w = 204, 197 * 204 >> 8 = 156.
        Between{"OneAbove", BlockFormat::Bc4, 0, 197, 5, 157, 156},
        // (2 * -53 + 3 * 34) / 5 = -0.8, cut off to 0, is 127.5 of 255; w = 153, -53 + (87 * 153 >> 8) = -2.
        Between{"AcrossZero", BlockFormat::Bc4Signed, 256 - 53, 34, 4, 128, -2},
        // -127 > -128, so there are values between them and not the ends of the range; all are -1.
        Between{"BothAreMinusOne", BlockFormat::Bc4Signed, 0x81, 0x80, 7, 0, -127}),
    [](const auto& test) { return std::string(test.param.name); });

INSTANTIATE_TEST_SUITE_P(Rows, CompressedTexture, testing::ValuesIn(blockFormatRows),
                         [](const auto& test) { return std::string(test.param.name); });

} // namespace
} // namespace texplorer::render::s3tc_test

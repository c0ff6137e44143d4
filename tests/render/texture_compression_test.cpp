// The three ways to a compressed texture, as the driver has it afterwards: read back level by level.

#include "app/render/texture_cache.h"
#include "tests/support/flat_scene.h"
#include "tests/support/render_fixture.h"
#include "texplorer/s3tc/decode.h"
#include "texplorer/s3tc/encode.h"

#include <gmock/gmock.h>

namespace texplorer::texture_compression_test {
namespace {

using namespace test;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Soft colours, as block formats are made for.
Image softPicture(int width, int height) {
    Image made = Image::uninitialised(PixelFormat::Rgba8, width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const std::array values{40 + x * 3, 60 + y * 3, 128 + x - y, 255};
            std::ranges::transform(values, made.at(x, y).begin(),
                                   [](int v) { return static_cast<std::byte>(v); });
        }
    return made;
}

/// Random bits: every block mode occurs.
TextureImage randomFile(BlockFormat format, int width, int height, int levels) {
    TextureImage file;
    file.topFirst = true;
    file.levels = levels;
    unsigned state = 4711;
    for (int level = 0; level < levels; ++level) {
        BlockImage blocks =
            BlockImage::uninitialised(format, std::max(1, width >> level), std::max(1, height >> level));
        for (std::byte& each : blocks.blocks) {
            state = state * 1664525U + 1013904223U; // the generator of "Numerical Recipes"
            each = static_cast<std::byte>(state >> 24);
        }
        file.surfaces.emplace_back(std::move(blocks));
    }
    return file;
}

int worstDifference(const Image& a, const Image& b, std::size_t components = 4) {
    EXPECT_EQ(a.pixels.size(), b.pixels.size());
    int worst = 0;
    for (std::size_t i = 0; i < std::min(a.pixels.size(), b.pixels.size()); ++i)
        if (i % 4 < components)
            worst = std::max(worst,
                             std::abs(std::to_integer<int>(a.pixels[i]) - std::to_integer<int>(b.pixels[i])));
    return worst;
}

class Compressed : public RenderTest {
protected:
    std::vector<TextureLevel> levelsOf(const Scene& scene) {
        static_cast<void>(picture(scene));
        Result<std::vector<TextureLevel>> levels = renderer->readTexture(0);
        EXPECT_TRUE(levels) << describe(levels.error());
        return levels ? *std::move(levels) : std::vector<TextureLevel>{};
    }
    static Scene sceneWith(Compression compression, MipPolicy mipmaps) {
        Scene scene = texturedScene();
        scene.textures[0].compression = compression;
        scene.textures[0].mipmaps = mipmaps;
        return scene;
    }
};

class CompressedFile : public Compressed, public testing::WithParamInterface<BlockFormat> {};

TEST_P(CompressedFile, IsUploadedBlockByBlock) {
    const TextureImage file = randomFile(GetParam(), 16, 8, 5);
    images.put("image", file);
    Scene scene = sceneWith(Compression::FromFile, MipPolicy::FromFile);
    scene.textures[0].flip = FlipMode::None; // what the driver has is the file's own bytes
    const auto levels = levelsOf(scene);
    EXPECT_THAT(problems, IsEmpty());
    ASSERT_EQ(levels.size(), 5U);
    for (int level = 0; level < 5; ++level) {
        EXPECT_EQ(levels[static_cast<std::size_t>(level)].number, level);
        EXPECT_EQ(std::get<BlockImage>(*levels[static_cast<std::size_t>(level)].surface),
                  std::get<BlockImage>(file.surface(0, level)));
    }
}

INSTANTIATE_TEST_SUITE_P(All, CompressedFile,
                         testing::Values(BlockFormat::Dxt1, BlockFormat::Dxt1Alpha, BlockFormat::Dxt3,
                                         BlockFormat::Dxt5, BlockFormat::Bc4, BlockFormat::Bc5),
                         [](const auto& test) {
                             std::string name(rowOf(test.param).name);
                             return name;
                         });

// The specification leaves the rounding of the colours in between open, and the driver expands 5 and 6 bits
// in its own way: 2 steps of 255 at most; transparent black is where both have it.
TEST_F(Compressed, FilesLookAsOurDecoderSaysWithinTwoSteps) {
    for (const BlockFormat format : {BlockFormat::Dxt1, BlockFormat::Dxt3, BlockFormat::Dxt5}) {
        images.put("image", randomFile(format, 8, 8, 1));
        const Image driver = picture(sceneWith(Compression::FromFile, MipPolicy::None), 8);
        const Image ours = picture(sceneWith(Compression::None, MipPolicy::None), 8);
        EXPECT_LE(worstDifference(driver, ours, format == BlockFormat::Dxt1 ? 3 : 4), 2)
            << rowOf(format).name;
    }
}

TEST_F(Compressed, FilesThatEndEarlyAreCompleteByTheirMaxLevel) {
    images.put("image", randomFile(BlockFormat::Dxt1, 16, 16, 2));
    Scene scene = sceneWith(Compression::FromFile, MipPolicy::FromFile);
    scene.material.color = {0.2F, 0.4F, 0.6F, 0.8F};
    scene.textures[0].minFilter = MinFilter::LinearMipmapLinear;
    const Image image = picture(scene);
    EXPECT_FALSE(isColor(colorAt(image, 1, 1), scene.material.color, 0)) << "drawn with the texture";
    scene.textures[0].mipmaps = MipPolicy::None; // the same without GL_TEXTURE_MAX_LEVEL
    EXPECT_TRUE(isColor(onlyColor(scene), scene.material.color));
}

TEST_F(Compressed, AMissingLevelMakesItIncompleteAndDrawsUntextured) {
    images.put("image", softPicture(16, 16));
    Scene scene = sceneWith(Compression::FromFile, MipPolicy::Missing);
    scene.material.color = {0.2F, 0.4F, 0.6F, 0.8F};
    scene.textures[0].minFilter = MinFilter::LinearMipmapLinear;
    EXPECT_TRUE(isColor(onlyColor(scene), scene.material.color));
    scene.textures[0].minFilter = MinFilter::Linear; // asks for no level but the base
    EXPECT_FALSE(isColor(colorAt(picture(scene), 1, 1), scene.material.color, 0));
    scene.textures[0].minFilter = MinFilter::LinearMipmapLinear;
    scene.textures[0].maxLevel = 1; // nor does this reach the gap, at level 2
    EXPECT_FALSE(isColor(colorAt(picture(scene), 1, 1), scene.material.color, 0));
}

struct DriverCase {
    const char* name;
    CompressedFormat format;
    std::size_t baseBytes; // of 32 x 32 texels
};

class CompressedByDriver : public Compressed, public testing::WithParamInterface<DriverCase> {};

// A good compressor stays above 35 dB on a soft picture; 30 dB is what any must reach.
TEST_P(CompressedByDriver, IsReadBackAsBlocksThatLookLikeThePicture) {
    images.put("image", softPicture(32, 32));
    Scene scene = sceneWith(Compression::Driver, MipPolicy::Generated);
    scene.textures[0].compressedFormat = GetParam().format;
    const auto levels = levelsOf(scene);
    EXPECT_THAT(problems, IsEmpty());
    ASSERT_EQ(levels.size(), 6U);
    const MipChain source = buildMipChain(softPicture(32, 32));
    for (const TextureLevel& level : levels) {
        const auto* blocks = std::get_if<BlockImage>(&*level.surface);
        ASSERT_NE(blocks, nullptr);
        EXPECT_EQ(blocks->format, blockFormat(GetParam().format));
    }
    const TextureReport report = reportOn(levels, source);
    EXPECT_EQ(report.levels[0].bytes, GetParam().baseBytes);
    ASSERT_TRUE(report.levels[0].psnr);
    EXPECT_GT(*report.levels[0].psnr, 30);
}

INSTANTIATE_TEST_SUITE_P(All, CompressedByDriver,
                         testing::Values(DriverCase{"Dxt1", CompressedFormat::Dxt1, 512},
                                         DriverCase{"Dxt1Alpha", CompressedFormat::Dxt1Alpha, 512},
                                         DriverCase{"Dxt3", CompressedFormat::Dxt3, 1024},
                                         DriverCase{"Dxt5", CompressedFormat::Dxt5, 1024}),
                         [](const auto& test) { return std::string(test.param.name); });

TEST_F(Compressed, TexturesAreDecompressedForADriverWithoutS3tcAndSaidSo) {
    view::Capabilities poor = capabilities;
    poor.s3tc = false;
    renderer = std::move(*makeRenderer(poor));
    const TextureImage file = randomFile(BlockFormat::Dxt5, 8, 8, 4);
    images.put("image", file);
    const auto levels = levelsOf(sceneWith(Compression::FromFile, MipPolicy::FromFile));
    EXPECT_THAT(problems, ElementsAre(HasSubstr("the driver has no GL_COMPRESSED_RGBA_S3TC_DXT5_EXT")));
    ASSERT_EQ(levels.size(), 4U);
    Image expected = decodeBlocks(std::get<BlockImage>(file.surface(0, 0)));
    flipVertically(expected);
    EXPECT_EQ(std::get<Image>(*levels[0].surface), expected);

    images.put("image", softPicture(8, 8));
    const auto driver = levelsOf(sceneWith(Compression::Driver, MipPolicy::None));
    EXPECT_THAT(problems, ElementsAre(HasSubstr("uploaded decompressed")));
    ASSERT_EQ(driver.size(), 1U);
    EXPECT_EQ(std::get<Image>(*driver[0].surface), softPicture(8, 8));
}

TEST_F(Compressed, LevelsMadeAtRunTimeAreUploadedAsTheyAre) {
    const Scene scene = sceneWith(Compression::Cached, MipPolicy::Generated);
    images.put("image", softPicture(16, 12));
    const auto levels = levelsOf(scene);
    EXPECT_THAT(problems, ElementsAre(HasSubstr("textures[0]: the compressed levels can't be cached")));
    ASSERT_EQ(levels.size(), 5U);
    const auto wanted = encodeBlocks(softPicture(16, 12), BlockFormat::Dxt1, EncodeQuality::Normal);
    EXPECT_EQ(std::get<BlockImage>(*levels[0].surface), *wanted);
    for (const TextureLevel& level : levels)
        EXPECT_TRUE(std::holds_alternative<BlockImage>(*level.surface)) << level.number;
}

TEST_F(Compressed, ATextureThatWasNotDrawnCannotBeReadBack) {
    const auto levels = renderer->readTexture(0);
    ASSERT_FALSE(levels);
    EXPECT_EQ(describe(levels.error()), "textures[0]: it has not been drawn as GL_TEXTURE_2D");
}

} // namespace
} // namespace texplorer::texture_compression_test

// The uploaded pixels: flip, levels and compression of a texture, checked against pictures turned by hand.

#include "tests/support/watched_heap.h"
#include "texplorer/s3tc/decode.h"
#include "texplorer/s3tc/surface_pixels.h"
#include "texplorer/texture/texture_levels.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace texplorer::texture_levels_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Image randomImage(int width, int height, int depth = 1, PixelFormat format = PixelFormat::Rgba8) {
    Image made = Image::uninitialised(format, width, height, depth);
    std::mt19937 random(11); // NOLINT: the same picture each time
    std::ranges::generate(made.pixels, [&] { return static_cast<std::byte>(random() >> 24); });
    return made;
}

BlockImage randomBlocks(BlockFormat format, int width, int height, int depth = 1) {
    BlockImage made = BlockImage::uninitialised(format, width, height, depth);
    std::mt19937 random(12); // NOLINT
    std::ranges::generate(made.blocks, [&] { return static_cast<std::byte>(random() >> 24); });
    return made;
}

/// As a DDS file is: top row first.
TextureImage blockTexture(int width, int height, int levels, BlockFormat format = BlockFormat::Dxt5) {
    TextureImage texture;
    texture.format = "DDS";
    texture.topFirst = true;
    texture.levels = levels;
    for (int level = 0; level < levels; ++level)
        texture.surfaces.emplace_back(
            randomBlocks(format, std::max(1, width >> level), std::max(1, height >> level)));
    return texture;
}

/// Upside down, row by row.
Image upsideDown(const Image& image) {
    Image turned = image;
    for (int z = 0; z < image.depth; ++z)
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x)
                std::ranges::copy(image.at(x, image.height - 1 - y, z), turned.at(x, y, z).begin());
    return turned;
}

Image pixels(const TextureLevel& level) {
    return toImage(level.surface);
}

bool isBlocks(const TextureLevel& level) {
    return std::holds_alternative<BlockImage>(*level.surface);
}

Texture with(FlipMode flip, MipPolicy mipmaps = MipPolicy::FromFile) {
    Texture texture;
    texture.flip = flip;
    texture.mipmaps = mipmaps;
    return texture;
}

std::vector<int> numbers(const TextureLevels& levels) {
    std::vector<int> found;
    for (const TextureLevel& level : levels.levels)
        found.push_back(level.number);
    return found;
}

TEST(PreparedBlocks, AreTurnedAroundWithoutDecompressing) {
    const TextureImage file = blockTexture(16, 8, 5);
    const auto levels = prepareLevels(with(FlipMode::Blocks), file);
    ASSERT_TRUE(levels) << describe(levels.error());
    ASSERT_EQ(levels->levels.size(), 5U);
    for (const TextureLevel& level : levels->levels) {
        ASSERT_TRUE(isBlocks(level));
        EXPECT_EQ(pixels(level), upsideDown(toImage(file.surface(0, level.number)))) << level.number;
    }
    EXPECT_EQ(levels->lateFlip, LateFlip::None);
    EXPECT_THAT(levels->notes, IsEmpty());
    EXPECT_THAT(levels->source, IsEmpty());
}

TEST(PreparedBlocks, OfAHeightThatCannotBeTurnedAreDecompressedAndSaidSo) {
    const TextureImage file = blockTexture(24, 12, 4); // heights 12, 6, 3, 1
    const auto levels = prepareLevels(with(FlipMode::Blocks), file);
    ASSERT_TRUE(levels);
    ASSERT_EQ(levels->levels.size(), 4U);
    for (const TextureLevel& level : levels->levels) {
        EXPECT_FALSE(isBlocks(level)) << "all levels of a texture have one format";
        EXPECT_EQ(pixels(level), upsideDown(toImage(file.surface(0, level.number))));
    }
    EXPECT_THAT(levels->notes, ElementsAre(HasSubstr("level 1 has 12 × 6 texels")));
}

TEST(PreparedBlocks, StayAsTheFileHasThemWhereTheFlipComesLater) {
    const TextureImage file = blockTexture(24, 12, 4);
    const std::array<std::pair<FlipMode, LateFlip>, 3> modes{{{FlipMode::Coordinates, LateFlip::Coordinates},
                                                              {FlipMode::Matrix, LateFlip::Matrix},
                                                              {FlipMode::None, LateFlip::None}}};
    for (const auto& [flip, late] : modes) {
        const auto levels = prepareLevels(with(flip), file);
        ASSERT_TRUE(levels);
        EXPECT_EQ(levels->lateFlip, late) << rowOf(flip).name;
        EXPECT_THAT(levels->notes, IsEmpty());
        for (const TextureLevel& level : levels->levels)
            EXPECT_EQ(std::get<BlockImage>(*level.surface),
                      std::get<BlockImage>(file.surface(0, level.number)));
    }
}

TEST(PreparedBlocks, AreDecompressedForAFlipOfPixels) {
    const TextureImage file = blockTexture(8, 8, 4);
    const auto levels = prepareLevels(with(FlipMode::Pixels), file);
    ASSERT_TRUE(levels);
    for (const TextureLevel& level : levels->levels) {
        EXPECT_FALSE(isBlocks(level));
        EXPECT_EQ(pixels(level), upsideDown(toImage(file.surface(0, level.number))));
    }
}

TEST(PreparedBlocks, AreDecompressedWhereTheSceneSaysSo) {
    Texture texture = with(FlipMode::Blocks);
    texture.compression = Compression::None;
    const TextureImage file = blockTexture(8, 8, 4);
    const auto levels = prepareLevels(texture, file);
    ASSERT_TRUE(levels);
    EXPECT_FALSE(isBlocks(levels->levels[0]));
    EXPECT_EQ(pixels(levels->levels[0]), upsideDown(toImage(file.surface(0, 0))));
    EXPECT_THAT(levels->notes, IsEmpty());
}

TEST(PreparedBlocks, AreDecompressedForWhatNeedsPixelsAndSaidSo) {
    Texture generated = with(FlipMode::Blocks, MipPolicy::Generated);
    Texture scaled = with(FlipMode::Blocks, MipPolicy::None);
    scaled.npot = NpotPolicy::PowerOfTwo;
    Texture stencil = with(FlipMode::Blocks);
    stencil.transparency = Transparency::Stencil;
    const TextureImage file = blockTexture(24, 16, 1);
    for (const auto& [texture, words] : {std::pair{generated, "mip levels are made from pixels"},
                                         {scaled, "24 × 16 to powers of two"},
                                         {stencil, "transparency"}}) {
        const auto levels = prepareLevels(texture, file);
        ASSERT_TRUE(levels);
        EXPECT_FALSE(isBlocks(levels->levels[0]));
        EXPECT_THAT(levels->notes, ElementsAre(HasSubstr(words)));
    }
    EXPECT_EQ(widthOf(prepareLevels(scaled, file)->levels[0].surface), 32); // 24 is 16 * 1.5: it goes up
}

TEST(PreparedBlocks, AreForPicturesOnly) {
    const TextureImage file = blockTexture(8, 4, 1);
    const Image upright = upsideDown(toImage(file.surface(0, 0)));
    const auto line = prepareLevels(with(FlipMode::Blocks), file, Target::Texture1D);
    ASSERT_TRUE(line);
    const Image row = pixels(line->levels[0]);
    EXPECT_EQ(row.height, 1);
    EXPECT_TRUE(std::ranges::equal(row.at(3, 0), upright.at(3, 2)))
        << "the middle row of the upright picture";
    EXPECT_THAT(line->notes, ElementsAre(HasSubstr("GL_TEXTURE_1D")));
    const auto volume = prepareLevels(with(FlipMode::Blocks), file, Target::Texture3D);
    ASSERT_TRUE(volume);
    EXPECT_EQ(pixels(volume->levels[0]), upright);
}

TEST(PreparedBlocks, OfAVolumeAreItsMiddleSlice) {
    TextureImage file;
    file.topFirst = true;
    file.surfaces.emplace_back(randomBlocks(BlockFormat::Dxt1, 8, 8, 4));
    const auto levels = prepareLevels(with(FlipMode::Blocks), file);
    ASSERT_TRUE(levels);
    ASSERT_TRUE(isBlocks(levels->levels[0]));
    const Image all = toImage(file.surface(0, 0));
    const Image found = pixels(levels->levels[0]);
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x)
            ASSERT_TRUE(std::ranges::equal(found.at(x, y), all.at(x, 7 - y, 2)));
}

struct OrderCase {
    const char* name;
    bool topFirst;     // as decoded
    bool fileTopFirst; // in the file
    FlipMode flip;
    bool turned; // against what was decoded
    LateFlip late;
};

class RowOrder : public testing::TestWithParam<OrderCase> {};

TEST_P(RowOrder, FollowsTheFlip) {
    TextureImage file = textureOf(randomImage(5, 3), "test");
    file.topFirst = GetParam().topFirst;
    file.fileTopFirst = GetParam().fileTopFirst;
    const auto levels = prepareLevels(with(GetParam().flip), file);
    ASSERT_TRUE(levels);
    const Image decoded = toImage(file.surface(0, 0));
    EXPECT_EQ(pixels(levels->levels[0]), GetParam().turned ? upsideDown(decoded) : decoded);
    EXPECT_EQ(levels->lateFlip, GetParam().late);
}

using F = FlipMode;
using L = LateFlip;

INSTANTIATE_TEST_SUITE_P(All, RowOrder,
                         testing::Values(
                             // A PNG: begins at the top, decoded bottom row first.
                             OrderCase{"PngBlocks", false, true, F::Blocks, false, L::None},
                             OrderCase{"PngPixels", false, true, F::Pixels, false, L::None},
                             OrderCase{"PngCoordinates", false, true, F::Coordinates, true, L::Coordinates},
                             OrderCase{"PngMatrix", false, true, F::Matrix, true, L::Matrix},
                             OrderCase{"PngNone", false, true, F::None, true, L::None},
                             // A bottom-up BMP is already upright for OpenGL: nothing needs a flip.
                             OrderCase{"BmpBlocks", false, false, F::Blocks, false, L::None},
                             OrderCase{"BmpCoordinates", false, false, F::Coordinates, false, L::None},
                             OrderCase{"BmpMatrix", false, false, F::Matrix, false, L::None},
                             OrderCase{"BmpNone", false, false, F::None, false, L::None},
                             // An uncompressed DDS: top first in both.
                             OrderCase{"DdsBlocks", true, true, F::Blocks, true, L::None},
                             OrderCase{"DdsCoordinates", true, true, F::Coordinates, false, L::Coordinates},
                             OrderCase{"DdsNone", true, true, F::None, false, L::None}),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(PreparedLevels, OfAFileEndWhereTheFileEnds) {
    const auto whole = prepareLevels(with(FlipMode::Blocks), blockTexture(16, 16, 5));
    EXPECT_EQ(whole->lastLevel, 4);
    const auto part = prepareLevels(with(FlipMode::Blocks), blockTexture(16, 16, 3));
    EXPECT_EQ(part->lastLevel, 2);
    EXPECT_THAT(numbers(*part), ElementsAre(0, 1, 2));
    const auto picture = prepareLevels(with(FlipMode::Blocks), textureOf(randomImage(16, 16), "PNG"));
    EXPECT_EQ(picture->lastLevel, 0) << "one level, complete by GL_TEXTURE_MAX_LEVEL";
    const auto base = prepareLevels(with(FlipMode::Blocks, MipPolicy::None), blockTexture(16, 16, 5));
    EXPECT_THAT(numbers(*base), ElementsAre(0));
    EXPECT_EQ(base->lastLevel, 1000) << "incomplete for a filter with mipmaps";
}

TEST(PreparedLevels, AreTheSameWhereTheImageIsShared) {
    const std::vector<TextureImage> images{
        textureOf(randomImage(16, 16), "PNG"), textureOf(randomImage(12, 5), "PNG"),
        textureOf(randomImage(8, 1), "PNG"), textureOf(randomImage(4, 4, 4), "DDS"), blockTexture(8, 8, 4)};
    int lent = 0;
    for (const TextureImage& image : images) {
        const auto shared = std::make_shared<const TextureImage>(image);
        for (const Target target : {Target::Texture1D, Target::Texture2D, Target::Texture3D, Target::CubeMap})
            for (const EnumRow& policy : mipPolicyRows)
                for (const FlipMode flip : {FlipMode::Blocks, FlipMode::None})
                    for (const NpotPolicy npot : {NpotPolicy::Keep, NpotPolicy::PowerOfTwo})
                        for (const int border : {0, 1}) {
                            Texture texture = with(flip, static_cast<MipPolicy>(policy.value));
                            texture.npot = npot;
                            texture.border = border;
                            const auto copied = prepareLevels(texture, image, target);
                            const auto levels = prepareLevels(texture, shared, target);
                            ASSERT_TRUE(copied && levels);
                            ASSERT_EQ(levels->levels.size(), copied->levels.size());
                            for (std::size_t i = 0; i < levels->levels.size(); ++i) {
                                const TextureLevel& level = levels->levels[i];
                                EXPECT_EQ(level.number, copied->levels[i].number);
                                EXPECT_EQ(level.face, copied->levels[i].face);
                                EXPECT_EQ(*level.surface, *copied->levels[i].surface);
                                EXPECT_FALSE(copied->levels[i].surface.isLent());
                                lent += level.surface.isLent() ? 1 : 0;
                            }
                        }
    }
    EXPECT_GT(lent, 50);
}

TEST(PreparedLevels, OfALargePictureTakeNoMoreThanWhatIsAboveIt) {
    const auto image = std::make_shared<const TextureImage>(textureOf(randomImage(1024, 1024), "PNG"));
    const std::size_t pixels = byteCount(*image);
    const test::HeapWatch heap;
    const auto levels = prepareLevels(with(FlipMode::Blocks, MipPolicy::Generated), image);
    ASSERT_TRUE(levels);
    EXPECT_EQ(levels->levels.size(), 11U);
    EXPECT_EQ(&*levels->levels[0].surface, &image->surface(0, 0));
    EXPECT_LT(heap.peak(), pixels * 35 / 100) << "a third of it, and little else";
}

TEST(PreparedLevels, LackOneOnPurpose) {
    const auto levels =
        prepareLevels(with(FlipMode::Blocks, MipPolicy::Missing), textureOf(randomImage(16, 16), "PNG"));
    EXPECT_THAT(numbers(*levels), ElementsAre(0, 1, 3, 4));
    EXPECT_EQ(levels->lastLevel, 1000);
    const auto two =
        prepareLevels(with(FlipMode::Blocks, MipPolicy::Missing), textureOf(randomImage(2, 1), "PNG"));
    EXPECT_THAT(numbers(*two), ElementsAre(0));
    const auto one =
        prepareLevels(with(FlipMode::Blocks, MipPolicy::Missing), textureOf(randomImage(1, 1), "PNG"));
    EXPECT_THAT(numbers(*one), ElementsAre(0));
    EXPECT_THAT(one->notes, ElementsAre(HasSubstr("only a base level")));
}

TEST(PreparedLevels, AreCompressedByTheDriverWhereTheSceneSaysSo) {
    Texture texture = with(FlipMode::Blocks, MipPolicy::Generated);
    texture.compression = Compression::Driver;
    texture.compressedFormat = CompressedFormat::Dxt3;
    const TextureImage picture = textureOf(randomImage(8, 8), "PNG");
    const auto levels = prepareLevels(texture, picture);
    EXPECT_EQ(levels->driverFormat, BlockFormat::Dxt3);
    EXPECT_FALSE(isBlocks(levels->levels[0]));
    const auto line = prepareLevels(texture, picture, Target::Texture1D);
    EXPECT_EQ(line->driverFormat, std::nullopt);
    EXPECT_THAT(line->notes, ElementsAre(HasSubstr("GL_TEXTURE_1D")));
}

TEST(PreparedLevels, HaveTheTransparencyThatTheSceneChooses) {
    Image image = Image::uninitialised(PixelFormat::Rgb8, 2, 1);
    std::ranges::transform(std::array{255, 0, 255, 1, 2, 3}, image.pixels.begin(),
                           [](int c) { return static_cast<std::byte>(c); });
    Texture texture;
    texture.transparency = Transparency::Stencil;
    texture.stencilColor = {1, 0, 1, 0.5F};
    const Image cut = pixels(prepareLevels(texture, textureOf(image, "PNG"))->levels[0]);
    ASSERT_EQ(cut.format, PixelFormat::Rgba8);
    EXPECT_EQ(cut.at(0, 0)[3], std::byte{0});
    EXPECT_EQ(cut.at(1, 0)[3], std::byte{255});
}

TEST(PreparedLevels, OfACubeMapAreItsFirstFaceAndSaidSo) {
    TextureImage cube = blockTexture(4, 4, 1);
    cube.faces = 6;
    for (int face = 1; face < 6; ++face)
        cube.surfaces.emplace_back(BlockImage::uninitialised(BlockFormat::Dxt5, 4, 4));
    const auto levels = prepareLevels(with(FlipMode::None), cube);
    ASSERT_EQ(levels->levels.size(), 1U);
    EXPECT_EQ(levels->levels[0].surface, cube.surfaces[0]);
    EXPECT_THAT(levels->notes, ElementsAre(HasSubstr("6 faces")));
}

TEST(PreparedLevels, OfNothingAreRefused) {
    EXPECT_FALSE(prepareLevels(Texture{}, TextureImage{}));
    EXPECT_FALSE(prepareLevels(Texture{}, textureOf(Image{}, "PNG")));
}

TEST(PreparedLevels, CanBeDecompressedForADriverWithoutS3tc) {
    auto levels = prepareLevels(with(FlipMode::Blocks), blockTexture(8, 8, 4));
    ASSERT_TRUE(levels);
    const Image before = pixels(levels->levels[0]);
    makeBytes(*levels);
    EXPECT_FALSE(isBlocks(levels->levels[0]));
    EXPECT_EQ(pixels(levels->levels[0]), before);
}

TEST(ImageSettings, IgnoreSamplingAndNothingElse) {
    Texture sampled;
    sampled.magFilter = MagFilter::Nearest;
    sampled.minFilter = MinFilter::Nearest;
    sampled.wrapS = sampled.wrapT = sampled.wrapR = Wrap::Clamp;
    sampled.borderColor = glm::vec4(1);
    sampled.baseLevel = sampled.maxLevel = 3;
    sampled.minLod = sampled.maxLod = 1;
    sampled.lodBias = 1;
    sampled.maxAnisotropy = 2;
    sampled.priority = 0;
    EXPECT_EQ(imageSettings(sampled), Texture{});
    Texture made;
    made.flip = FlipMode::None;
    made.mipGamma = true;
    made.internalFormat = InternalFormat::Rgb;
    EXPECT_EQ(imageSettings(made), made);
}

// 4/3, except for the rest after the last level: 1 + 1/4 + 1/16 + ... + 1/4^8 = (4 - 1/4^8) / 3.
TEST(Report, OfAFullChainIsFourThirdsOfTheBase) {
    const auto levels =
        prepareLevels(with(FlipMode::Blocks, MipPolicy::Generated), textureOf(randomImage(256, 256), "PNG"));
    const TextureReport report = reportOn(*levels);
    ASSERT_EQ(report.levels.size(), 9U);
    EXPECT_EQ(report.levels[0].bytes, 256U * 256 * 4);
    EXPECT_EQ(report.levels[8].bytes, 4U);
    EXPECT_EQ(report.bytes, 349524U);
    EXPECT_NEAR(report.ratioToBase, 4.0 / 3, 1e-5);
    EXPECT_EQ(report.shareOfRgba8, 1);
    EXPECT_NEAR(report.shareOfRgb8, 4.0 / 3, 1e-12);
    EXPECT_FALSE(report.levels[0].psnr);
}

struct TexelBytes {
    InternalFormat format;
    std::size_t bytes;
};

// By the names of the formats (table 3.16), for any image: 15 bits take 2 bytes, 4 bits one.
TEST(Report, CountsTheBitsOfTheInternalFormat) {
    for (const auto& [format, bytes] :
         {TexelBytes{InternalFormat::Rgba, 4}, TexelBytes{InternalFormat::Rgb, 3},
          TexelBytes{InternalFormat::LuminanceAlpha, 2}, TexelBytes{InternalFormat::Rgba4, 2},
          TexelBytes{InternalFormat::Rgb5A1, 2}, TexelBytes{InternalFormat::Rgb5, 2},
          TexelBytes{InternalFormat::R3G3B2, 1}, TexelBytes{InternalFormat::Rgba2, 1},
          TexelBytes{InternalFormat::Alpha4, 1}, TexelBytes{InternalFormat::Srgb8Alpha8, 4},
          TexelBytes{InternalFormat::Sluminance8, 1}, TexelBytes{InternalFormat::DepthComponent24, 3}}) {
        Texture texture = with(FlipMode::Blocks, MipPolicy::Generated);
        texture.internalFormat = format;
        const TextureReport report = reportOn(*prepareLevels(texture, textureOf(randomImage(4, 2), "PNG")));
        EXPECT_EQ(report.levels[0].bytes, 8 * bytes) << rowOf(format).name;
        EXPECT_EQ(report.bytes, 11 * bytes) << rowOf(format).name;
        EXPECT_DOUBLE_EQ(report.shareOfRgba8, static_cast<double>(bytes) / 4) << rowOf(format).name;
    }
}

// 93 and 94 are 5.47 and 5.53 of 15: 5 and 6, so 85 and 102. Their mean, 93.5, is 94 in 8 bits: 6 again.
TEST(LevelsOfFewBits, AreRoundedEachForItself) {
    Texture texture = with(FlipMode::Blocks, MipPolicy::Generated);
    texture.internalFormat = InternalFormat::Luminance4;
    Image image{PixelFormat::Luminance8, 4, 1, 1, {}};
    for (const int value : {93, 93, 93, 94})
        image.pixels.push_back(static_cast<std::byte>(value));
    const auto levels = prepareLevels(texture, textureOf(image, {}));
    ASSERT_TRUE(levels);
    EXPECT_EQ(levels->internalFormat, InternalFormat::Luminance4);
    const auto redsOf = [&](std::size_t level) {
        const auto& stored = std::get<Image>(*levels->levels.at(level).surface);
        std::vector<int> reds;
        for (int x = 0; x < stored.width; ++x)
            reds.push_back(std::to_integer<int>(stored.at(x, 0)[0]));
        return reds;
    };
    EXPECT_THAT(redsOf(0), testing::ElementsAre(85, 85, 85, 102));
    EXPECT_THAT(redsOf(1), testing::ElementsAre(85, 102));
    EXPECT_THAT(redsOf(2), testing::ElementsAre(102)); // of 93 and 94 again
}

TEST(LevelsOfFewBits, LeaveBlocksAlone) {
    Texture texture = with(FlipMode::None);
    texture.internalFormat = InternalFormat::Rgba2;
    const TextureImage file = blockTexture(8, 8, 1, BlockFormat::Dxt1);
    auto levels = prepareLevels(texture, file);
    ASSERT_TRUE(levels);
    EXPECT_EQ(*levels->levels[0].surface, file.surface(0, 0));
    makeBytes(*levels); // for a driver that has none: the format of DXT1 is RGB
    EXPECT_EQ(levels->internalFormat, InternalFormat::Rgb);
}

// Blocks of 16 texels: 8 bytes against 64 and 48. A level below 4 x 4 still takes a whole block.
TEST(Report, OfBlocksComparesThemWithPixels) {
    const TextureReport one = reportOn(
        *prepareLevels(with(FlipMode::None, MipPolicy::None), blockTexture(64, 64, 1, BlockFormat::Dxt1)));
    EXPECT_DOUBLE_EQ(one.shareOfRgba8, 1.0 / 8);
    EXPECT_DOUBLE_EQ(one.shareOfRgb8, 1.0 / 6);
    const TextureReport chain =
        reportOn(*prepareLevels(with(FlipMode::None), blockTexture(8, 8, 4, BlockFormat::Dxt5)));
    EXPECT_EQ(chain.bytes, 64U + 16 + 16 + 16);
    EXPECT_DOUBLE_EQ(chain.ratioToBase, 1.75);
    EXPECT_DOUBLE_EQ(chain.shareOfRgba8, 112.0 / (4 * 85));
    EXPECT_THAT(describe(chain), HasSubstr("112 bytes, 1.750 times the base"));
}

// One component of eight off by 10: the mean square is 100 / 8, 10 log10(255^2 / 12.5) = 37.16 dB.
TEST(Report, GivesThePeakSignalToNoiseRatio) {
    Image source = randomImage(2, 1);
    source.pixels[0] = std::byte{100};
    Image stored = source;
    stored.pixels[0] = std::byte{110};
    const TextureReport report = reportOn({{0, stored}, {1, source}}, {source, source});
    ASSERT_TRUE(report.levels[0].psnr);
    EXPECT_NEAR(*report.levels[0].psnr, 37.16, 0.005);
    ASSERT_TRUE(report.levels[1].psnr);
    EXPECT_TRUE(std::isinf(*report.levels[1].psnr));
    EXPECT_THAT(describe(report), HasSubstr("37.2 dB"));
    EXPECT_THAT(describe(report), HasSubstr("exact"));
}

// Grey 100, 200, 50: BC4 keeps only red, BC5 red and green. Blocks of one value are exact, so components that
// are left out must not count as a loss.
TEST(Report, LeavesOutTheComponentsThatAFormatDoesNotHave) {
    Image source = Image::uninitialised(PixelFormat::Rgba8, 4, 4);
    for (std::size_t i = 0; i < source.pixels.size(); i += 4)
        std::ranges::copy(std::array{std::byte{100}, std::byte{200}, std::byte{50}, std::byte{7}},
                          source.pixels.begin() + static_cast<std::ptrdiff_t>(i));
    for (const BlockFormat format : {BlockFormat::Bc4, BlockFormat::Bc5}) {
        const auto blocks = encodeBlocks(source, format, EncodeQuality::Best);
        ASSERT_TRUE(blocks);
        const TextureReport report = reportOn({{0, *blocks}}, {source});
        ASSERT_TRUE(report.levels[0].psnr);
        EXPECT_TRUE(std::isinf(*report.levels[0].psnr)) << rowOf(format).name;
        EXPECT_THAT(describe(report),
                    HasSubstr(format == BlockFormat::Bc4 ? "exact in R\n" : "exact in RG\n"));
    }
}

// One component of six is off by 10: the mean square is 100 / 6, 10 log10(255^2 / (100 / 6)) = 35.91 dB, with
// or without an alpha of 255.
TEST(Report, LeavesOutAnAlphaThatSaysNothing) {
    for (const PixelFormat format : {PixelFormat::Rgb8, PixelFormat::Rgba8}) {
        Image source = Image::uninitialised(format, 2, 1);
        std::ranges::fill(source.pixels, std::byte{255});
        Image stored = source;
        stored.pixels[0] = std::byte{245};
        const LevelReport level = reportOn({{0, stored}}, {source}).levels[0];
        EXPECT_NEAR(level.psnr.value(), 35.91, 0.005);
        EXPECT_EQ(level.components, "RGB");
    }
    // One of eight: 37.16 dB if alpha has information, or if the compression has changed it.
    Image source = Image::uninitialised(PixelFormat::Rgba8, 2, 1);
    std::ranges::fill(source.pixels, std::byte{255});
    Image stored = source;
    stored.pixels[3] = std::byte{245};
    for (const LevelReport& level :
         {reportOn({{0, stored}}, {source}).levels[0], reportOn({{0, source}}, {stored}).levels[0]}) {
        EXPECT_NEAR(level.psnr.value(), 37.16, 0.005);
        EXPECT_EQ(level.components, "RGBA");
    }
}

// The colours of an alpha-only picture are black and are ignored: 20 log10(255 / 10) = 28.13 dB.
TEST(Report, ComparesAlphaAloneWhereThereIsNothingElse) {
    const Image source{PixelFormat::Alpha8, 1, 1, 1, Bytes(1, std::byte{100})};
    const Image stored{PixelFormat::Alpha8, 1, 1, 1, Bytes(1, std::byte{110})};
    const LevelReport level = reportOn({{0, stored}}, {source}).levels[0];
    EXPECT_NEAR(level.psnr.value(), 28.13, 0.005);
    EXPECT_EQ(level.components, "A");
}

// --- Cube maps

/// Six faces of a 1 x 2 picture, whose rows are letters: 'a' over 'A' for +x, 'b' over 'B' for -x …
TextureImage sixFaces(bool topFirst) {
    TextureImage file;
    file.format = "DDS";
    file.faces = 6;
    file.topFirst = topFirst;
    file.fileTopFirst = topFirst;
    for (int face = 0; face < 6; ++face) {
        Image image = Image::uninitialised(PixelFormat::Luminance8, 1, 2);
        image.pixels[topFirst ? 0 : 1] = static_cast<std::byte>('a' + face);
        image.pixels[topFirst ? 1 : 0] = static_cast<std::byte>('A' + face);
        file.surfaces.emplace_back(std::move(image));
    }
    return file;
}

std::string rowsOf(const TextureLevel& level) {
    std::string text;
    for (const std::byte each : std::get<Image>(*level.surface).pixels)
        text += static_cast<char>(each);
    return text;
}

// OpenGL gets each face with its top row first.
TEST(CubeLevels, BeginEachFaceWithItsTopRow) {
    Texture texture;
    texture.source = SourceKind::File;
    for (const bool topFirst : {false, true}) {
        for (const FlipMode flip : {FlipMode::Blocks, FlipMode::Pixels}) {
            texture.flip = flip;
            const auto made = prepareLevels(texture, sixFaces(topFirst), Target::CubeMap);
            ASSERT_TRUE(made);
            ASSERT_EQ(made->levels.size(), 6U);
            EXPECT_EQ(rowsOf(made->levels[0]), "aA");
            EXPECT_EQ(rowsOf(made->levels[5]), "fF");
            EXPECT_EQ(made->levels[5].face, 5);
            EXPECT_EQ(made->lateFlip, LateFlip::None);
            EXPECT_THAT(made->notes, IsEmpty());
        }
    }
    // With a naive loader, only a file that begins at the top is right.
    for (const FlipMode flip : {FlipMode::None, FlipMode::Matrix, FlipMode::Coordinates}) {
        texture.flip = flip;
        EXPECT_EQ(rowsOf(prepareLevels(texture, sixFaces(true), Target::CubeMap)->levels[0]), "aA");
        EXPECT_EQ(rowsOf(prepareLevels(texture, sixFaces(false), Target::CubeMap)->levels[0]), "Aa");
        EXPECT_EQ(prepareLevels(texture, sixFaces(true), Target::CubeMap)->lateFlip, LateFlip::None);
    }
    // A picture uses the first face, upright.
    texture.flip = FlipMode::Blocks;
    const auto picture = prepareLevels(texture, sixFaces(true), Target::Texture2D);
    ASSERT_EQ(picture->levels.size(), 1U);
    EXPECT_EQ(rowsOf(picture->levels[0]), "Aa");
    EXPECT_THAT(picture->notes, ElementsAre(HasSubstr("the first, +x, is drawn")));
}

TEST(CubeLevels, HaveAChainForEachFaceOfAStrip) {
    Texture texture;
    texture.source = SourceKind::File;
    texture.mipmaps = MipPolicy::Missing;
    const auto made = prepareLevels(texture, textureOf(randomImage(24, 4), {}), Target::CubeMap);
    ASSERT_TRUE(made);
    std::vector<std::pair<int, int>> found;
    for (const TextureLevel& level : made->levels) {
        found.emplace_back(level.face, level.number);
        EXPECT_EQ(widthOf(level.surface), 4 >> level.number);
    }
    const std::vector<std::pair<int, int>> expected{{0, 0}, {0, 2}, {1, 0}, {1, 2}, {2, 0}, {2, 2},
                                                    {3, 0}, {3, 2}, {4, 0}, {4, 2}, {5, 0}, {5, 2}};
    EXPECT_EQ(found, expected);
    const TextureReport report = reportOn(*made);
    ASSERT_EQ(report.levels.size(), 2U);
    EXPECT_EQ(report.levels[0].faces, 6);
    EXPECT_EQ(report.levels[0].bytes, 6U * 4 * 4 * 4);
    EXPECT_EQ(report.bytes, 6U * (16 + 1) * 4);
}

TEST(CubeLevels, KeepTheBlocksOfAFile) {
    TextureImage file = blockTexture(8, 8, 2);
    file.faces = 6;
    for (int face = 1; face < 6; ++face) {
        file.surfaces.emplace_back(randomBlocks(BlockFormat::Dxt5, 8, 8));
        file.surfaces.emplace_back(randomBlocks(BlockFormat::Dxt5, 4, 4));
    }
    Texture texture;
    texture.source = SourceKind::File;
    texture.mipmaps = MipPolicy::FromFile;
    const auto made = prepareLevels(texture, file, Target::CubeMap);
    ASSERT_TRUE(made);
    ASSERT_EQ(made->levels.size(), 12U);
    for (std::size_t i = 0; i < 12; ++i)
        EXPECT_EQ(std::get<BlockImage>(*made->levels[i].surface), std::get<BlockImage>(file.surfaces[i]))
            << i;
}

TEST(Levels, WithABorderAreNeverCompressed) {
    Texture texture;
    texture.source = SourceKind::File;
    texture.border = 1;
    const auto kept = prepareLevels(texture, blockTexture(8, 8, 1), Target::Texture2D);
    ASSERT_TRUE(kept);
    EXPECT_EQ(widthOf(kept->levels[0].surface), 10);
    EXPECT_EQ(kept->border, 1);
    EXPECT_THAT(kept->notes, ElementsAre(HasSubstr("without a border only: decompressed")));
    texture.compression = Compression::Driver;
    const auto driver = prepareLevels(texture, textureOf(randomImage(8, 8), {}), Target::Texture2D);
    ASSERT_TRUE(driver);
    EXPECT_FALSE(driver->driverFormat);
    EXPECT_THAT(driver->notes, ElementsAre(HasSubstr("without a border only: not compressed")));
}

} // namespace
} // namespace texplorer::texture_levels_test

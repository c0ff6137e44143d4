// Levels with their own pictures, and how each is prepared: the pixels that OpenGL gets.

#include "texplorer/image/patterns/pattern.h"
#include "texplorer/image/resample.h"
#include "texplorer/s3tc/encode.h"
#include "texplorer/s3tc/surface_pixels.h"
#include "texplorer/texture/image_source.h"
#include "texplorer/texture/level_plan.h"
#include "texplorer/texture/texture_levels.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <stop_token>

namespace texplorer::given_levels_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Pair;

/// Rows of single letters, the bottom one first: "ab" is a column of two texels.
Image column(std::string_view rows) {
    Image image = Image::uninitialised(PixelFormat::Luminance8, 1, static_cast<int>(rows.size()));
    std::ranges::transform(rows, image.pixels.begin(), [](char row) { return static_cast<std::byte>(row); });
    return image;
}

std::string rowsOf(const Surface& surface) {
    std::string rows;
    const auto& image = std::get<Image>(surface);
    for (int y = 0; y < image.height; ++y)
        rows += static_cast<char>(image.at(0, y)[0]);
    return rows;
}

Image flat(int width, int height, int grey, int depth = 1) {
    Image image = Image::uninitialised(PixelFormat::Luminance8, width, height, depth);
    std::ranges::fill(image.pixels, static_cast<std::byte>(grey));
    return image;
}

Image randomImage(int width, int height) {
    Image image = Image::uninitialised(PixelFormat::Rgb8, width, height);
    unsigned state = 1;
    std::ranges::generate(image.pixels, [&] {
        state = state * 1103515245U + 12345U;
        return static_cast<std::byte>(state >> 16U);
    });
    return image;
}

/// As decoded from a file that begins at the top.
TextureImage fileOf(Image image) {
    TextureImage texture = textureOf(std::move(image), "PNG");
    texture.fileTopFirst = true;
    return texture;
}

class GivenLevels : public testing::Test {
protected:
    GivenLevels() {
        texture_.source = SourceKind::File;
        texture_.file = "base";
        texture_.mipmaps = MipPolicy::Given;
    }

    void give(const std::string& file, const Image& image) {
        images_.put(file, fileOf(image));
        if (file != texture_.file)
            texture_.levels.push_back({.source = SourceKind::File, .file = file});
    }
    void give(Pattern pattern) { texture_.levels.push_back({.pattern = pattern}); }

    TextureLevels made(Target target = Target::Texture2D) {
        Result<TextureLevels> levels = prepareLevels(texture_, images_.picturesOf(texture_), target);
        EXPECT_TRUE(levels);
        return levels ? *std::move(levels) : TextureLevels{};
    }
    std::vector<PlannedLevel> planned(Target target = Target::Texture2D) {
        return planLevels(texture_, images_.picturesOf(texture_), target).levels;
    }

    Texture texture_;
    ImageSource images_;
};

TEST_F(GivenLevels, AreTheBaseAloneWithoutAny) {
    give("base", flat(8, 4, 1));
    const TextureLevels levels = made();
    ASSERT_EQ(levels.levels.size(), 1U);
    EXPECT_EQ(levels.lastLevel, 1000) << "nothing is cut off: the texture is as incomplete as it is";
    EXPECT_THAT(planned(), ElementsAre(PlannedLevel{0, 8, 4, 1}));
}

TEST_F(GivenLevels, OfFilesAreAsTheyAre) {
    give("base", flat(8, 4, 1));
    give("half", flat(4, 2, 2));
    give("wrong", flat(3, 5, 3));
    const TextureLevels levels = made();
    ASSERT_EQ(levels.levels.size(), 3U);
    EXPECT_EQ(std::get<Image>(*levels.levels[1].surface), flat(4, 2, 2));
    EXPECT_EQ(std::get<Image>(*levels.levels[2].surface), flat(3, 5, 3));
    EXPECT_EQ(levels.levels[2].number, 2);
    EXPECT_THAT(planned(),
                ElementsAre(PlannedLevel{0, 8, 4, 1}, PlannedLevel{1, 4, 2, 1}, PlannedLevel{2, 3, 5, 1}));
}

TEST_F(GivenLevels, OfPatternsGetTheSizeThatTheyHaveToHave) {
    give("base", flat(40, 6, 1));
    texture_.npot = NpotPolicy::PowerOfTwo; // 32 x 8, as it is uploaded
    give(Pattern::Checker);
    give(Pattern::Brick);
    const TextureLevels levels = made();
    ASSERT_EQ(levels.levels.size(), 3U);
    EXPECT_EQ(std::get<Image>(*levels.levels[1].surface),
              scaleByCoverage(drawPattern(Pattern::Checker), 16, 4));
    EXPECT_EQ(std::get<Image>(*levels.levels[2].surface), scaleByCoverage(drawPattern(Pattern::Brick), 8, 2));
    EXPECT_THAT(planned(),
                ElementsAre(PlannedLevel{0, 32, 8, 1}, PlannedLevel{1, 16, 4, 1}, PlannedLevel{2, 8, 2, 1}));
}

TEST_F(GivenLevels, OfTheBasesPatternAreSmallerThanTheBase) {
    texture_.source = SourceKind::Pattern; // 64 x 64
    give(Pattern::Checker);
    const TextureLevels levels = made();
    ASSERT_EQ(levels.levels.size(), 2U);
    EXPECT_TRUE(levels.levels[0].surface.isLent());
    EXPECT_EQ(std::get<Image>(*levels.levels[1].surface),
              scaleByCoverage(drawPattern(Pattern::Checker), 32, 32));
}

TEST_F(GivenLevels, ThatAreNotLoadedAreMissing) {
    give("base", flat(8, 8, 1));
    texture_.levels = {{.source = SourceKind::File, .file = "gone.png"}, {}, {.source = SourceKind::File}};
    const TextureLevels levels = made();
    ASSERT_EQ(levels.levels.size(), 2U);
    EXPECT_EQ(levels.levels[1].number, 2);
    EXPECT_THAT(levels.notes, ElementsAre("levels[0]: gone.png is not loaded; uploaded without it",
                                          "levels[2]: no file is chosen; uploaded without it"));
}

struct FlipRow {
    FlipMode flip;
    std::string_view file;    ///< how the rows "ab" of a file arrive that begins with b, the top one
    std::string_view pattern; ///< the same for a picture without a file
};

// A base from a file that begins at the top: a later flip needs all levels with the top row first.
TEST_F(GivenLevels, AreTheRightWayUpAsTheBaseIs) {
    for (const FlipRow& row : {FlipRow{FlipMode::Blocks, "ab", "ab"}, FlipRow{FlipMode::Pixels, "ab", "ab"},
                               FlipRow{FlipMode::Coordinates, "ba", "ba"},
                               FlipRow{FlipMode::Matrix, "ba", "ba"}, FlipRow{FlipMode::None, "ba", "ab"}}) {
        texture_.levels.clear();
        texture_.flip = row.flip;
        give("base", column("abcd"));
        give("half", column("ab"));
        images_.put("drawn", column("ab")); // has no file
        texture_.levels.push_back({.source = SourceKind::File, .file = "drawn"});
        const TextureLevels levels = made();
        ASSERT_EQ(levels.levels.size(), 3U);
        EXPECT_EQ(rowsOf(levels.levels[0].surface), row.file == "ab" ? "abcd" : "dcba");
        EXPECT_EQ(rowsOf(levels.levels[1].surface), row.file) << rowOf(row.flip).name;
        EXPECT_EQ(rowsOf(levels.levels[2].surface), row.pattern) << rowOf(row.flip).name;
    }
}

TEST_F(GivenLevels, OfALineAreTheMiddleRows) {
    give("base", flat(8, 3, 1));
    Image rows = flat(4, 3, 0);
    std::ranges::fill(rows.at(0, 1).first(1), std::byte{7});
    give("half", rows);
    give(Pattern::ColorLine);
    const TextureLevels levels = made(Target::Texture1D);
    ASSERT_EQ(levels.levels.size(), 3U);
    EXPECT_EQ(std::get<Image>(*levels.levels[1].surface).height, 1);
    EXPECT_EQ(std::get<Image>(*levels.levels[1].surface).pixels[0], std::byte{7});
    EXPECT_THAT(planned(Target::Texture1D),
                ElementsAre(PlannedLevel{0, 8, 1, 1}, PlannedLevel{1, 4, 1, 1}, PlannedLevel{2, 2, 1, 1}));
}

TEST_F(GivenLevels, OfAVolumeHaveADepth) {
    give("base", flat(8, 8, 1, 4));
    give("half", flat(4, 4, 2, 2));
    give(Pattern::Marble);
    EXPECT_THAT(planned(Target::Texture3D),
                ElementsAre(PlannedLevel{0, 8, 8, 4}, PlannedLevel{1, 4, 4, 2}, PlannedLevel{2, 2, 2, 1}));
    EXPECT_EQ(depthOf(made(Target::Texture3D).levels[1].surface), 2);
    EXPECT_EQ(depthOf(made(Target::Texture2D).levels[1].surface), 1) << "the middle slice";
}

TEST_F(GivenLevels, OfACubeMapHaveSixFaces) {
    give("base", flat(32, 24, 1)); // a cross of faces of 8 texels
    give("strip", flat(24, 4, 2)); // a row of faces of 4
    give(Pattern::CubeFaces);
    const TextureLevels levels = made(Target::CubeMap);
    ASSERT_EQ(levels.levels.size(), 18U);
    std::map<int, int> widths;
    for (const TextureLevel& level : levels.levels)
        widths[level.number] += widthOf(level.surface);
    EXPECT_EQ(widths, (std::map<int, int>{{0, 48}, {1, 24}, {2, 12}}));
    // The pattern's faces, not its flat picture: +x and -x differ.
    EXPECT_NE(*levels.levels[2].surface, *levels.levels[5].surface);
    EXPECT_EQ(planned(Target::CubeMap).back(), (PlannedLevel{2, 2, 2, 1}));
}

TEST_F(GivenLevels, HaveTheirBorders) {
    texture_.border = 1;
    give("base", flat(10, 18, 1)); // 8 x 16 and a border
    give("half", flat(6, 10, 2));  // 4 x 8 and a border
    give("bare", flat(2, 4, 3));   // gets one
    give(Pattern::Checker);
    EXPECT_THAT(planned(), ElementsAre(PlannedLevel{0, 8, 16, 1}, PlannedLevel{1, 4, 8, 1},
                                       PlannedLevel{2, 2, 4, 1}, PlannedLevel{3, 1, 2, 1}));
    const TextureLevels levels = made();
    ASSERT_EQ(levels.levels.size(), 4U);
    EXPECT_EQ(heightOf(levels.levels[1].surface), 10);
    EXPECT_EQ(heightOf(levels.levels[2].surface), 6);
    EXPECT_EQ(heightOf(levels.levels[3].surface), 4);
}

TextureImage compressed(int width, int height, BlockFormat format) {
    TextureImage texture;
    texture.format = "DDS";
    texture.topFirst = true;
    texture.surfaces.emplace_back(*encodeBlocks(randomImage(width, height), format, EncodeQuality::Fast));
    return texture;
}

TEST_F(GivenLevels, KeepTheirBlocksWhereAllHaveTheSame) {
    images_.put("base", compressed(8, 8, BlockFormat::Dxt1));
    images_.put("half", compressed(4, 4, BlockFormat::Dxt1));
    texture_.levels = {{.source = SourceKind::File, .file = "half"}};
    const TextureLevels kept = made();
    EXPECT_TRUE(std::holds_alternative<BlockImage>(*kept.levels.at(1).surface));
    EXPECT_THAT(kept.notes, IsEmpty());
    EXPECT_EQ(planLevels(texture_, images_.picturesOf(texture_), Target::Texture2D).blocks,
              BlockFormat::Dxt1);

    images_.put("half", compressed(4, 4, BlockFormat::Dxt5));
    const TextureLevels mixed = made();
    EXPECT_TRUE(std::holds_alternative<Image>(*mixed.levels.at(0).surface));
    EXPECT_THAT(mixed.notes,
                ElementsAre("the base level is compressed as GL_COMPRESSED_RGB_S3TC_DXT1_EXT and level 1 is "
                            "not: all are decompressed"));
}

TEST_F(GivenLevels, AreCompressedEachForItself) {
    texture_.compression = Compression::Cached;
    give("base", randomImage(8, 8));
    give("wrong", randomImage(5, 7));
    const TextureLevels levels = made();
    ASSERT_EQ(levels.levels.size(), 2U);
    EXPECT_TRUE(std::holds_alternative<BlockImage>(*levels.levels[1].surface));
    EXPECT_EQ(widthOf(levels.levels[1].surface), 5);
}

TEST_F(GivenLevels, NeedPicturesThatTheSourceHas) {
    give(Pattern::Checker);
    texture_.levels.push_back({.source = SourceKind::File, .file = "late"});
    TexturePictures pictures = images_.picturesOf(texture_);
    EXPECT_EQ(pictures.levels.size(), 2U);
    EXPECT_NE(pictures.level(0), nullptr);
    EXPECT_EQ(pictures.level(1), nullptr);
    EXPECT_EQ(pictures, images_.picturesOf(texture_));
    images_.put("late", flat(1, 1, 1));
    EXPECT_NE(pictures, images_.picturesOf(texture_)) << "they key a cache";
    texture_.mipmaps = MipPolicy::Generated;
    EXPECT_TRUE(images_.picturesOf(texture_).levels.empty());
}

TEST_F(GivenLevels, StayWithinWhatImagesMayTake) {
    give("base", flat(2, 2, 1));
    give("large", {});
    TextureImage outline = fileOf(Image{PixelFormat::Luminance8, 16384, 16384, 1, {}}); // 256 MiB
    images_.put("large", std::make_shared<const TextureImage>(std::move(outline)));
    texture_.levels.resize(9, texture_.levels.front());
    const auto levels = prepareLevels(texture_, images_.picturesOf(texture_));
    ASSERT_FALSE(levels);
    EXPECT_EQ(levels.error().code, ErrorCode::TooLarge);
    EXPECT_EQ(levels.error().message, "the images of the levels above the base need 2415919104 bytes, but "
                                      "may have at most 2 GiB together");
}

class PreparedTexture : public GivenLevels {
protected:
    static ImageStep step(ImageOp op) { return {.op = op}; }
    static ImageStep half() { return {.op = ImageOp::Scale, .factor = {0.5F, 0.5F, 0.5F, 1}}; }
    std::string firstBytes(int level) {
        const Image image = toImage(made().levels.at(static_cast<std::size_t>(level)).surface);
        return std::to_string(std::to_integer<int>(image.pixels.at(0)));
    }
};

TEST_F(PreparedTexture, TakesItsStepsInTheirOrder) {
    give("base", flat(2, 2, 55));
    texture_.preparation = {step(ImageOp::Invert), half()};
    EXPECT_EQ(firstBytes(0), "100"); // 200 / 2
    texture_.preparation = {half(), step(ImageOp::Invert)};
    EXPECT_EQ(firstBytes(0), "227"); // 255 - 28: 27.5 is rounded to the even number
}

TEST_F(PreparedTexture, HasAllItsLevelsPrepared) {
    give("base", flat(4, 4, 55));
    give("half", flat(2, 2, 10));
    texture_.preparation = {step(ImageOp::Invert)};
    EXPECT_EQ(firstBytes(0), "200");
    EXPECT_EQ(firstBytes(1), "245");
    texture_.mipmaps = MipPolicy::Generated;
    EXPECT_EQ(firstBytes(2), "200") << "made of the prepared base";
}

TEST_F(PreparedTexture, IsPreparedBeforeItsTransparencyIsFound) {
    give("base", flat(1, 1, 255));
    texture_.preparation = {step(ImageOp::Invert)};
    texture_.transparency = Transparency::Stencil; // of black
    const Image image = toImage(made().levels.at(0).surface);
    EXPECT_EQ(image.format, PixelFormat::LuminanceAlpha8);
    EXPECT_EQ(image.pixels.at(1), std::byte{0});
}

TEST_F(PreparedTexture, GrowsNoLargerThanAnImageMayBe) {
    give("base", flat(1, 1, 1));
    images_.put("base", Image::uninitialised(PixelFormat::Luminance8, 1, 1, 1024));
    texture_.preparation = {{.op = ImageOp::Resize, .share = 1, .width = 1024, .height = 1024}};
    const auto levels = prepareLevels(texture_, images_.picturesOf(texture_), Target::Texture3D);
    ASSERT_FALSE(levels);
    EXPECT_EQ(levels.error().code, ErrorCode::TooLarge);
    EXPECT_EQ(levels.error().message, "preparation[0]: an image of 1073741824 texels needs more than 2 GiB");
}

TEST_F(PreparedTexture, TakesAlphaTheRightWayUp) {
    give("base", column("abcd"));
    images_.put("mask", fileOf(column("wxyz")));
    texture_.preparation = {
        {.op = ImageOp::AlphaFrom, .source = SourceKind::File, .file = "mask"},
    };
    for (const EnumRow& flip : flipModeRows) {
        texture_.flip = static_cast<FlipMode>(flip.value);
        const Image image = toImage(made().levels.at(0).surface);
        ASSERT_EQ(image.format, PixelFormat::LuminanceAlpha8);
        for (int y = 0; y < 4; ++y) // 'w' belongs to 'a'
            EXPECT_EQ(std::to_integer<int>(image.at(0, y)[1]) - 'w',
                      std::to_integer<int>(image.at(0, y)[0]) - 'a')
                << flip.name;
    }
}

TEST_F(PreparedTexture, DoesWithoutAlphaThatIsNotLoaded) {
    give("base", flat(1, 1, 9));
    texture_.preparation = {{.op = ImageOp::AlphaFrom, .source = SourceKind::File, .file = "gone.png"}};
    EXPECT_THAT(made().notes, ElementsAre("preparation[0]: gone.png is not loaded; skipped"));
    EXPECT_EQ(firstBytes(0), "9");
}

TEST_F(PreparedTexture, IsDecompressedForIt) {
    images_.put("base", compressed(8, 8, BlockFormat::Dxt1));
    texture_.mipmaps = MipPolicy::None;
    texture_.preparation = {step(ImageOp::Invert)};
    const TextureLevels levels = made();
    EXPECT_TRUE(std::holds_alternative<Image>(*levels.levels.at(0).surface));
    EXPECT_THAT(levels.notes, ElementsAre(HasSubstr("needs pixels: decompressed")));
}

TEST_F(PreparedTexture, StopsBetweenItsSteps) {
    give("base", flat(2, 2, 55));
    texture_.preparation = {step(ImageOp::Invert), half()};
    std::stop_source source;
    const LevelWork work{.cache = {}, .stop = source.get_token()};
    EXPECT_TRUE(prepareLevels(texture_, images_.picturesOf(texture_), Target::Texture2D, work));
    int seen = 0;
    const auto stopAtOnce = [&](const Image&) { seen += source.request_stop() ? 1 : 10; };
    eachPreparationStep(texture_, images_.picturesOf(texture_), stopAtOnce, source.get_token());
    EXPECT_EQ(seen, 1);
    const auto stopped = prepareLevels(texture_, images_.picturesOf(texture_), Target::Texture2D, work);
    ASSERT_FALSE(stopped);
    EXPECT_EQ(stopped.error().code, ErrorCode::Cancelled);
}

TEST_F(PreparedTexture, ShowsEachStep) {
    give("base", flat(2, 1, 55));
    texture_.preparation = {step(ImageOp::Invert), half(), step(ImageOp::LuminanceToAlpha)};
    std::vector<Image> steps;
    const auto keep = [&steps](const Image& image) { steps.push_back(image); };
    eachPreparationStep(texture_, images_.picturesOf(texture_), keep);
    ASSERT_EQ(steps.size(), 4U);
    EXPECT_EQ(steps[0], flat(2, 1, 55));
    EXPECT_EQ(steps[1], flat(2, 1, 200));
    EXPECT_EQ(steps[2], flat(2, 1, 100));
    EXPECT_EQ(steps[3].format, PixelFormat::LuminanceAlpha8);
    steps.clear();
    eachPreparationStep(texture_, {}, keep);
    EXPECT_THAT(steps, IsEmpty());
}

TEST_F(PreparedTexture, ShowsEachStepWhileItIsTaken) {
    give("base", column("ab"));
    texture_.flip = FlipMode::None; // the file's first row, its top one, goes to t = 0
    texture_.preparation = {step(ImageOp::Invert), step(ImageOp::Invert)};
    std::vector<std::pair<std::string, bool>> seen;
    const LevelWork work{.cache = {}, .step = [&](const Image& image, bool topFirst) {
                             seen.emplace_back(rowsOf(image), topFirst);
                         }};
    ASSERT_TRUE(prepareLevels(texture_, images_.picturesOf(texture_), Target::Texture2D, work));
    EXPECT_THAT(seen, ElementsAre(Pair("ba", true), Pair("\x9D\x9E", true), Pair("ba", true)));
    seen.clear();
    texture_.preparation.clear();
    ASSERT_TRUE(prepareLevels(texture_, images_.picturesOf(texture_), Target::Texture2D, work));
    EXPECT_THAT(seen, IsEmpty());
}

} // namespace
} // namespace texplorer::given_levels_test

// What is drawn of an image that is larger than the driver's limit, against levels worked out by hand.

#include "texplorer/s3tc/encode.h"
#include "texplorer/texture/image_source.h"
#include "texplorer/texture/level_plan.h"
#include "texplorer/texture/texture_levels.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace texplorer::smaller_levels_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Image imageOf(int width, int height, int depth, const std::vector<int>& greys) {
    Image image = Image::uninitialised(PixelFormat::Luminance8, width, height, depth);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        image.pixels[i] = static_cast<std::byte>(greys[i % greys.size()]);
    return image;
}

std::vector<int> greysOf(const Surface& surface) {
    std::vector<int> greys;
    for (const std::byte each : std::get<Image>(surface).pixels)
        greys.push_back(std::to_integer<int>(each));
    return greys;
}

/// Level k is flat and has the grey 10 * face + k.
TextureImage file(int width, int height, int levels, int faces = 1) {
    TextureImage made;
    made.format = "DDS";
    made.levels = levels;
    made.faces = faces;
    made.fileTopFirst = false;
    for (int face = 0; face < faces; ++face)
        for (int level = 0; level < levels; ++level)
            made.surfaces.emplace_back(
                imageOf(std::max(1, width >> level), std::max(1, height >> level), 1, {10 * face + level}));
    return made;
}

class SmallerLevels : public testing::Test {
protected:
    SmallerLevels() {
        texture_.source = SourceKind::File;
        texture_.file = "base";
        texture_.oversize = Oversize::Smaller;
    }

    void show(TextureImage image) { images_.put("base", std::move(image)); }
    void show(Image image) { images_.put("base", std::move(image)); }
    void limitTo(int texels) { images_.setLimits({.size = texels}); }

    TextureLevels made(Target target = Target::Texture2D) {
        const TexturePictures pictures = images_.picturesOf(texture_);
        Result<TextureLevels> levels = prepareLevels(texture_, pictures, target);
        EXPECT_TRUE(levels);
        if (!levels)
            return {};
        const LevelPlan plan = planLevels(texture_, pictures, target);
        EXPECT_EQ(plan.lastLevel, levels->lastLevel);
        EXPECT_EQ(plan.fallback.empty() ? std::string() : plan.fallback.english(),
                  levels->notes.empty() ? std::string() : levels->notes.front().english());
        EXPECT_EQ(plan.levels.size() * static_cast<std::size_t>(facesOf(target)), levels->levels.size());
        return *std::move(levels);
    }
    /// Each level's number, extents and grey: "0: 4 × 2, 2".
    static std::vector<std::string> listed(const TextureLevels& levels) {
        std::vector<std::string> all;
        for (const TextureLevel& each : levels.levels)
            all.push_back(std::to_string(each.number) + ": " + std::to_string(widthOf(each.surface)) + " × " +
                          std::to_string(heightOf(each.surface)) + ", " +
                          std::to_string(greysOf(each.surface).front()));
        return all;
    }

    Texture texture_;
    ImageSource images_;
};

TEST_F(SmallerLevels, OfAFileAreThoseThatFit) {
    show(file(16, 8, 5));
    limitTo(4);
    texture_.mipmaps = MipPolicy::FromFile;
    const TextureLevels levels = made();
    EXPECT_THAT(listed(levels), ElementsAre("0: 4 × 2, 2", "1: 2 × 1, 3", "2: 1 × 1, 4"));
    EXPECT_EQ(levels.lastLevel, 2);
    ASSERT_EQ(levels.notes.size(), 1U);
    EXPECT_EQ(levels.notes[0].english(), "16 × 8 texels exceed the driver's 4 for GL_TEXTURE_2D: drawn from "
                                         "level 2, which has 4 × 2");
}

TEST_F(SmallerLevels, AreNotTakenUnlessTheyAreNeededAndAskedFor) {
    show(file(16, 8, 5));
    limitTo(16);
    EXPECT_THAT(listed(made()), ElementsAre("0: 16 × 8, 0"));
    EXPECT_THAT(made().notes, IsEmpty());
    limitTo(4);
    texture_.oversize = Oversize::None;
    EXPECT_THAT(listed(made()), ElementsAre("0: 16 × 8, 0"));
    EXPECT_EQ(images_.picturesOf(texture_).limits, TextureLimits());
}

TEST_F(SmallerLevels, AreTheBaseOfThoseThatAreMade) {
    show(file(16, 8, 5));
    limitTo(7);
    EXPECT_THAT(listed(made()), ElementsAre("0: 4 × 2, 2"));
    texture_.mipmaps = MipPolicy::Generated;
    EXPECT_THAT(listed(made()), ElementsAre("0: 4 × 2, 2", "1: 2 × 1, 2", "2: 1 × 1, 2"));
}

TEST_F(SmallerLevels, OfAPictureAreMeansOfFour) {
    show(imageOf(4, 2, 1, {10, 20, 30, 40, 50, 60, 70, 80}));
    limitTo(2);
    const TextureLevels levels = made();
    ASSERT_EQ(levels.levels.size(), 1U);
    EXPECT_EQ(greysOf(levels.levels[0].surface), (std::vector{35, 55}));
    EXPECT_EQ(levels.notes.at(0).english(),
              "4 × 2 texels exceed the driver's 2 for GL_TEXTURE_2D: scaled down to 2 × 1");
    limitTo(1);
    EXPECT_EQ(greysOf(made().levels.at(0).surface), std::vector{45});
}

TEST_F(SmallerLevels, OfAFileWithTooFewAreHalvesOfTheLast) {
    show(file(16, 8, 2));
    limitTo(2);
    texture_.mipmaps = MipPolicy::FromFile;
    const TextureLevels levels = made();
    EXPECT_THAT(listed(levels), ElementsAre("0: 2 × 1, 1"));
    EXPECT_EQ(levels.lastLevel, 0);
}

TEST_F(SmallerLevels, OfALineHaveMeansOfTwo) {
    show(imageOf(4, 2, 1, {10, 20, 30, 40, 50, 60, 70, 80}));
    limitTo(2);
    const TextureLevels levels = made(Target::Texture1D); // the second row: imageForTarget
    ASSERT_EQ(levels.levels.size(), 1U);
    EXPECT_EQ(greysOf(levels.levels[0].surface), (std::vector{55, 75}));
}

TEST_F(SmallerLevels, OfAVolumeAreMeansOfEight) {
    show(imageOf(2, 2, 2, {10, 20, 30, 40, 50, 60, 70, 80}));
    limitTo(1); // of pictures: a volume has a limit of its own
    EXPECT_EQ(depthOf(made(Target::Texture3D).levels.at(0).surface), 2);
    EXPECT_THAT(made(Target::Texture3D).notes, IsEmpty());
    images_.setLimits({.size3D = 1});
    EXPECT_EQ(greysOf(made(Target::Texture3D).levels.at(0).surface), std::vector{45});
}

TEST_F(SmallerLevels, OfACubeMapAreThoseOfEachFace) {
    show(file(8, 8, 4, 6));
    images_.setLimits({.sizeOfCubeMap = 2});
    texture_.mipmaps = MipPolicy::FromFile;
    const TextureLevels levels = made(Target::CubeMap);
    ASSERT_EQ(levels.levels.size(), 12U);
    for (int face = 0; face < 6; ++face) {
        const auto first = static_cast<std::size_t>(face) * 2;
        EXPECT_EQ(greysOf(levels.levels[first].surface), std::vector(4, 10 * face + 2));
        EXPECT_EQ(greysOf(levels.levels[first + 1].surface), std::vector{10 * face + 3});
    }
}

TEST_F(SmallerLevels, ThatAreGivenOneByOneMoveUp) {
    show(imageOf(16, 4, 1, {1}));
    images_.put("half", imageOf(8, 2, 1, {2}));
    texture_.mipmaps = MipPolicy::Given;
    texture_.levels = {{.source = SourceKind::File, .file = "half"}, {.pattern = Pattern::Gradient}, {}};
    limitTo(8);
    TextureLevels levels = made();
    ASSERT_EQ(levels.levels.size(), 3U);
    EXPECT_EQ(greysOf(levels.levels[0].surface), std::vector(16, 2));
    for (int k = 1; k < 3; ++k) // patterns have the size that a level of the scene's base has
        EXPECT_EQ(widthOf(levels.levels[static_cast<std::size_t>(k)].surface), 8 >> k);
    limitTo(4);
    levels = made();
    ASSERT_EQ(levels.levels.size(), 2U);
    EXPECT_EQ(widthOf(levels.levels[0].surface), 4);
    EXPECT_EQ(heightOf(levels.levels[0].surface), 1);
}

TEST_F(SmallerLevels, HaveTheSizeThatAStepGivesTheirNumber) {
    show(file(16, 16, 5));
    limitTo(4);
    texture_.mipmaps = MipPolicy::FromFile;
    texture_.preparation = {{.op = ImageOp::Resize, .width = 8, .height = 8}};
    EXPECT_THAT(listed(made()), ElementsAre("0: 4 × 4, 1", "1: 2 × 2, 2", "2: 1 × 1, 3"));
}

TEST_F(SmallerLevels, OfBlocksAreTheFilesOwnUnlessTheyAreScaled) {
    TextureImage blocks = file(16, 16, 2);
    for (Surface& surface : blocks.surfaces)
        surface = *encodeBlocks(std::get<Image>(surface), BlockFormat::Dxt1, EncodeQuality::Fast);
    const Surface second = blocks.surfaces[1];
    show(blocks);
    limitTo(8);
    EXPECT_EQ(*made().levels.at(0).surface, second);
    limitTo(4);
    const TextureLevels levels = made();
    EXPECT_TRUE(std::holds_alternative<Image>(*levels.levels.at(0).surface));
    EXPECT_THAT(levels.notes.at(1).english(), HasSubstr("scaling the image down needs pixels"));
}

TEST_F(SmallerLevels, OfTheSizeThatIsAPowerOfTwoFit) {
    show(imageOf(90, 90, 1, {7})); // 64; with half of it 45, of which 32 is the nearest
    texture_.npot = NpotPolicy::PowerOfTwo;
    limitTo(64);
    EXPECT_THAT(listed(made()), ElementsAre("0: 64 × 64, 7"));
    limitTo(63);
    EXPECT_THAT(listed(made()), ElementsAre("0: 32 × 32, 7"));
}

} // namespace
} // namespace texplorer::smaller_levels_test

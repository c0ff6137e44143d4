// The levels of depth textures.

#include "texplorer/image/depth_pixels.h"
#include "texplorer/texture/image_source.h"
#include "texplorer/texture/level_plan.h"
#include "texplorer/texture/texture_levels.h"

#include <gmock/gmock.h>

namespace texplorer::depth_levels_test {
namespace {

using testing::Contains;
using testing::HasSubstr;

Texture depthTexture(InternalFormat format = InternalFormat::DepthComponent16) {
    Texture texture;
    texture.internalFormat = format;
    return texture;
}

const Image& imageOf(const TextureLevels& levels, std::size_t index = 0) {
    return std::get<Image>(*levels.levels[index].surface);
}

TEST(DepthLevels, AreTheRedOfAPicture) {
    Image picture = Image::uninitialised(PixelFormat::Rgb8, 2, 1);
    picture.pixels = {std::byte{51}, std::byte{1}, std::byte{2}, std::byte{255}, std::byte{3}, std::byte{4}};
    const Result<TextureLevels> levels = prepareLevels(depthTexture(), textureOf(picture, {}));
    ASSERT_TRUE(levels);
    EXPECT_EQ(levels->internalFormat, InternalFormat::DepthComponent16);
    EXPECT_EQ(imageOf(*levels).format, PixelFormat::Depth32);
    EXPECT_EQ(depthAt(imageOf(*levels).at(0, 0).data()), farthestDepth32 / 5);
    EXPECT_EQ(depthAt(imageOf(*levels).at(1, 0).data()), farthestDepth32);
}

TEST(DepthLevels, OfPicturesHaveMipmaps) {
    Texture texture = depthTexture();
    texture.mipmaps = MipPolicy::Generated;
    const Result<TextureLevels> levels = prepareLevels(texture, *ImageSource().find(texture));
    ASSERT_TRUE(levels);
    EXPECT_GT(levels->levels.size(), 3U);
    for (std::size_t i = 0; i < levels->levels.size(); ++i)
        EXPECT_EQ(imageOf(*levels, i).format, PixelFormat::Depth32);
}

TEST(DepthLevels, AreThereForLinesAndPicturesAlone) {
    const Texture texture = depthTexture();
    for (const Target target : {Target::Texture3D, Target::CubeMap}) {
        const Result<TextureLevels> levels = prepareLevels(texture, *ImageSource().find(texture), target);
        ASSERT_FALSE(levels);
        EXPECT_EQ(levels.error().code, ErrorCode::Unsupported);
        EXPECT_THAT(levels.error().message, HasSubstr(std::string(rowOf(target).name)));
        EXPECT_TRUE(planLevels(texture, ImageSource().find(texture), target).levels.empty());
    }
    EXPECT_TRUE(prepareLevels(texture, *ImageSource().find(texture), Target::Texture1D));
}

TEST(DepthLevels, AreNotCompressed) {
    Texture texture = depthTexture();
    for (const Compression compression : {Compression::Driver, Compression::Cached}) {
        texture.compression = compression;
        const Result<TextureLevels> levels = prepareLevels(texture, *ImageSource().find(texture));
        ASSERT_TRUE(levels);
        EXPECT_FALSE(levels->driverFormat);
        EXPECT_EQ(imageOf(*levels).format, PixelFormat::Depth32);
        EXPECT_THAT(levels->notes, Contains(HasSubstr("no compressed depth textures")));
        EXPECT_FALSE(planLevels(texture, ImageSource().find(texture), Target::Texture2D).blocks);
    }
}

Texture lightTexture(int size) {
    Texture texture = depthTexture(InternalFormat::DepthComponent24);
    texture.source = SourceKind::LightDepth;
    texture.depthSize = size;
    return texture;
}

TEST(DepthLevels, OfTheLightAreLentAsTheyAre) {
    const Texture texture = lightTexture(3); // no power of two
    const auto image = ImageSource().find(texture);
    ASSERT_TRUE(image);
    EXPECT_EQ(ImageSource().find(texture), image) << "one for each size";
    const Result<TextureLevels> levels = prepareLevels(texture, image);
    ASSERT_TRUE(levels);
    EXPECT_EQ(&imageOf(*levels), &std::get<Image>(image->surface(0, 0)));
    EXPECT_EQ(depthAt(imageOf(*levels).at(2, 2).data()), farthestDepth32) << "it was not drawn";
    EXPECT_TRUE(levels->notes.empty());
}

TEST(DepthLevels, OfTheLightAreNeitherAveragedNorScaled) {
    Texture texture = lightTexture(6);
    texture.mipmaps = MipPolicy::Generated;
    texture.npot = NpotPolicy::PowerOfTwo;
    texture.transparency = Transparency::Solid;
    const auto image = ImageSource().find(texture);
    const Result<TextureLevels> levels = prepareLevels(texture, image);
    ASSERT_TRUE(levels);
    EXPECT_EQ(levels->levels.size(), 1U);
    EXPECT_EQ(imageOf(*levels), std::get<Image>(image->surface(0, 0)));
    EXPECT_THAT(levels->notes, Contains(HasSubstr("no mip levels")));
    EXPECT_EQ(planLevels(texture, image, Target::Texture2D).levels.size(), 1U);
    texture.mipmaps = MipPolicy::FromFile;
    EXPECT_EQ(prepareLevels(texture, image)->lastLevel, 0) << "complete for every filter";
    EXPECT_TRUE(prepareLevels(texture, image)->notes.empty());
}

TEST(DepthLevels, OfTheLightAreGreysInATextureOfColours) {
    Texture texture = lightTexture(4);
    texture.internalFormat = InternalFormat::Rgba;
    texture.mipmaps = MipPolicy::Generated;
    const Result<TextureLevels> levels = prepareLevels(texture, ImageSource().find(texture));
    ASSERT_TRUE(levels);
    EXPECT_EQ(levels->levels.size(), 3U);
    EXPECT_EQ(imageOf(*levels).format, PixelFormat::Luminance8);
    EXPECT_EQ(imageOf(*levels).pixels[5], std::byte{255});
}

} // namespace
} // namespace texplorer::depth_levels_test

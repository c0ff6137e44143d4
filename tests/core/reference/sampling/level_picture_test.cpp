#include "texplorer/reference/sampling/level_picture.h"

#include <gtest/gtest.h>

namespace texplorer::reference::level_picture_test {
namespace {

using Texel = std::array<int, 4>;

/// Bottom row first.
Image rgbaImage(int width, int height, const std::vector<Texel>& texels) {
    Image image = Image::uninitialised(PixelFormat::Rgba8, width, height);
    for (std::size_t i = 0; i < texels.size(); ++i) {
        for (std::size_t component = 0; component < 4; ++component)
            image.pixels[4 * i + component] = static_cast<std::byte>(texels[i][component]);
    }
    return image;
}

std::vector<Texel> texelsOf(const Image& image) {
    std::vector<Texel> texels(image.pixels.size() / 4);
    for (std::size_t i = 0; i < texels.size(); ++i) {
        for (std::size_t component = 0; component < 4; ++component)
            texels[i][component] = std::to_integer<int>(image.pixels[4 * i + component]);
    }
    return texels;
}

TextureLevels levelsOf(const Texture& texture, Image image, Target target = Target::Texture2D) {
    return prepareLevels(texture, textureOf(std::move(image), "test"), target).value();
}

const std::vector<Texel> fourTexels{{255, 0, 0, 0}, {0, 255, 0, 64}, {0, 0, 255, 128}, {255, 255, 255, 255}};

// OpenGL 2.1, table 3.20: which components of the texel each base format keeps, and what stands for others.
TEST(LevelPicture, IsWhatTheFormatKeeps) {
    const Image image = rgbaImage(2, 1, {{10, 20, 30, 40}, {50, 60, 70, 80}});
    const auto shown = [&](InternalFormat format) {
        Texture texture;
        texture.internalFormat = format;
        return texelsOf(levelPicture(levelsOf(texture, image), 0, Target::Texture2D).value());
    };
    using Texels = std::vector<Texel>;
    EXPECT_EQ(shown(InternalFormat::Rgba), (Texels{{10, 20, 30, 40}, {50, 60, 70, 80}}));
    EXPECT_EQ(shown(InternalFormat::Rgb), (Texels{{10, 20, 30, 255}, {50, 60, 70, 255}}));
    EXPECT_EQ(shown(InternalFormat::Luminance), (Texels{{10, 10, 10, 255}, {50, 50, 50, 255}}));
    EXPECT_EQ(shown(InternalFormat::LuminanceAlpha), (Texels{{10, 10, 10, 40}, {50, 50, 50, 80}}));
    EXPECT_EQ(shown(InternalFormat::Intensity), (Texels{{10, 10, 10, 10}, {50, 50, 50, 50}}));
    EXPECT_EQ(shown(InternalFormat::Alpha), (Texels{{0, 0, 0, 40}, {0, 0, 0, 80}}));
}

TEST(LevelPicture, IsUprightWhateverIsDoneLater) {
    for (const FlipMode flip : {FlipMode::Pixels, FlipMode::Coordinates, FlipMode::Matrix}) {
        Texture texture;
        texture.flip = flip;
        const Image image = rgbaImage(1, 2, {{1, 1, 1, 255}, {2, 2, 2, 255}});
        EXPECT_EQ(levelPicture(levelsOf(texture, image), 0, Target::Texture2D).value(), image);
    }
}

TEST(LevelPicture, IsThatOfItsLevel) {
    Texture texture;
    texture.mipmaps = MipPolicy::Generated;
    const TextureLevels levels = levelsOf(texture, rgbaImage(2, 2, fourTexels));
    // Each mean of the four: 127.5, 127.5, 127.5 and 111.75.
    const Texel mean = texelsOf(levelPicture(levels, 1, Target::Texture2D).value()).front();
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(mean[i], 127.5, 0.51);
    EXPECT_NEAR(mean[3], 111.75, 0.51);
    const Result<Image> none = levelPicture(levels, 2, Target::Texture2D);
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().message, "there is no level 2");
}

// The border is put around the image: 4 x 4 texels are uploaded, of which the picture shows the 2 x 2 within.
TEST(LevelPicture, HasNoBorder) {
    Texture texture;
    texture.border = 1;
    const Image image = rgbaImage(2, 2, fourTexels);
    const TextureLevels levels = levelsOf(texture, image);
    ASSERT_EQ(widthOf(levels.levels.front().surface), 4);
    EXPECT_EQ(levelPicture(levels, 0, Target::Texture2D).value(), image);
}

// +x in the third column of the middle row, +y above the second (core/image/cube_faces.h).
TEST(LevelPicture, OfACubeMapIsACross) {
    std::vector<Texel> strip;
    for (int face = 0; face < 6; ++face)
        strip.push_back({face + 1, 0, 0, 255});
    const Image cross =
        levelPicture(levelsOf(Texture{}, rgbaImage(6, 1, strip), Target::CubeMap), 0, Target::CubeMap)
            .value();
    ASSERT_EQ(cross.width, 4);
    ASSERT_EQ(cross.height, 3);
    EXPECT_EQ(cross.at(2, 1)[0], std::byte{1});
    EXPECT_EQ(cross.at(0, 1)[0], std::byte{2});
    EXPECT_EQ(cross.at(1, 2)[0], std::byte{3}) << "bottom row first";
    EXPECT_EQ(cross.at(1, 0)[0], std::byte{4});
    EXPECT_EQ(cross.at(0, 0)[3], std::byte{0}) << "no face is there";
}

TEST(TexelStatistics, OfFourTexels) {
    const TexelStatistics statistics = statisticsOf(rgbaImage(2, 2, fourTexels));
    const auto& [red, green, blue, alpha, luminance] = statistics.components;
    EXPECT_EQ(red.counts[0], 2U);
    EXPECT_EQ(red.counts[255], 2U);
    EXPECT_EQ(red.mean, 127.5);
    EXPECT_EQ(green.mean, 127.5);
    EXPECT_EQ(blue.most, 255);
    EXPECT_EQ(alpha.least, 0);
    EXPECT_EQ(alpha.mean, 111.75);
    // ITU-R BT.709: 0.2126 * 255 = 54.2, 0.7152 * 255 = 182.4, 0.0722 * 255 = 18.4.
    EXPECT_EQ(luminance.least, 18);
    EXPECT_EQ(luminance.most, 255);
    EXPECT_EQ(luminance.counts[54], 1U);
    EXPECT_EQ(luminance.counts[182], 1U);
    EXPECT_EQ(luminance.mean, (54 + 182 + 18 + 255) / 4.0);
}

} // namespace
} // namespace texplorer::reference::level_picture_test

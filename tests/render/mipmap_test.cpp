// Which mip level is sampled, at a known number of texels a pixel: section 3.8.8 of the OpenGL 2.1
// specification. The texture has 64 x 64 texels and the coloured mip set, so that the colour says the level.

#include "app/render/gl_handle.h"
#include "app/render/texture_object.h"
#include "tests/support/flat_scene.h"
#include "tests/support/render_fixture.h"
#include "texplorer/image/mip_colors.h"
#include "texplorer/image/mipmaps.h"
#include "texplorer/image/patterns/pattern.h"
#include "texplorer/texture/texture_levels.h"

#include <glm/common.hpp>
#include <gmock/gmock.h>

namespace texplorer::mipmap_test {
namespace {

using namespace test;

constexpr int texels = 64;
constexpr int pixels = 16;

glm::vec4 colorOfLevel(int level) {
    const auto color = mipColor(level);
    return glm::vec4(color[0], color[1], color[2], color[3]) / 255.0F;
}

struct Case {
    const char* name;
    float texelsPerPixel;
    MinFilter filter = MinFilter::NearestMipmapNearest;
    float bias = 0;        ///< of the unit
    float textureBias = 0; ///< of the texture object
    float minLod = -1000;
    float maxLod = 1000;
    int baseLevel = 0;
    int maxLevel = 1000;
    int expectedLevel = 0;
    float shareOfNextLevel = 0;
};

class MipLevel : public RenderTest, public testing::WithParamInterface<Case> {};

TEST_P(MipLevel, IsTheOneOfTheSpecification) {
    const Case& row = GetParam();
    const glm::vec4 base = colorOfLevel(0) * 255.0F;
    images.put("image", plainImage(texels, texels, {int(base.r), int(base.g), int(base.b), int(base.a)}));
    Scene scene = texturedScene();
    Texture& texture = scene.textures[0];
    texture.mipmaps = MipPolicy::Colored;
    texture.minFilter = row.filter;
    texture.minLod = row.minLod;
    texture.maxLod = row.maxLod;
    texture.baseLevel = row.baseLevel;
    texture.maxLevel = row.maxLevel;
    scene.passes[0].units[0].lodBias = row.bias;
    texture.lodBias = row.textureBias;
    const float repeats = row.texelsPerPixel * pixels / texels;
    scene.models[0].texCoords[0] = quadCoords({0, 0, 0, 1}, {repeats, repeats, 0, 1});

    const glm::vec4 expected =
        glm::mix(colorOfLevel(row.expectedLevel), colorOfLevel(row.expectedLevel + 1), row.shareOfNextLevel);
    const glm::vec4 found = onlyColor(scene, pixels);
    EXPECT_TRUE(isColor(found, expected, row.shareOfNextLevel > 0 ? 2 : 0));
    EXPECT_THAT(problems, testing::IsEmpty());
}

using M = MinFilter;

// lambda is log2(texels per pixel), plus the bias, clamped to [minLod, maxLod].
INSTANTIATE_TEST_SUITE_P(Scale, MipLevel,
                         testing::Values(Case{.name = "Half", .texelsPerPixel = 0.5F, .expectedLevel = 0},
                                         Case{.name = "One", .texelsPerPixel = 1, .expectedLevel = 0},
                                         Case{.name = "Two", .texelsPerPixel = 2, .expectedLevel = 1},
                                         Case{.name = "Four", .texelsPerPixel = 4, .expectedLevel = 2},
                                         Case{.name = "Eight", .texelsPerPixel = 8, .expectedLevel = 3},
                                         Case{.name = "Sixteen", .texelsPerPixel = 16, .expectedLevel = 4},
                                         Case{.name = "ThirtyTwo", .texelsPerPixel = 32, .expectedLevel = 5},
                                         Case{.name = "SixtyFour", .texelsPerPixel = 64, .expectedLevel = 6},
                                         // There is no level 7.
                                         Case{.name = "More", .texelsPerPixel = 128, .expectedLevel = 6}),
                         [](const auto& test) { return std::string(test.param.name); });

// Four texels a pixel: lambda is 2, or 2.5 and 2.25 and 2.75 with a bias.
INSTANTIATE_TEST_SUITE_P(
    Filter, MipLevel,
    testing::Values(Case{.name = "Nearest", .texelsPerPixel = 4, .filter = M::Nearest, .expectedLevel = 0},
                    Case{.name = "Linear", .texelsPerPixel = 4, .filter = M::Linear, .expectedLevel = 0},
                    Case{.name = "NearestMipmapNearest", .texelsPerPixel = 4, .expectedLevel = 2},
                    Case{.name = "LinearMipmapNearest",
                         .texelsPerPixel = 4,
                         .filter = M::LinearMipmapNearest,
                         .expectedLevel = 2},
                    Case{.name = "NearestMipmapLinear",
                         .texelsPerPixel = 4,
                         .filter = M::NearestMipmapLinear,
                         .expectedLevel = 2},
                    Case{.name = "LinearMipmapLinear",
                         .texelsPerPixel = 4,
                         .filter = M::LinearMipmapLinear,
                         .expectedLevel = 2},
                    Case{.name = "NearestMipmapLinearHalfWay",
                         .texelsPerPixel = 4,
                         .filter = M::NearestMipmapLinear,
                         .bias = 0.5F,
                         .expectedLevel = 2,
                         .shareOfNextLevel = 0.5F},
                    Case{.name = "LinearMipmapLinearHalfWay",
                         .texelsPerPixel = 4,
                         .filter = M::LinearMipmapLinear,
                         .bias = 0.5F,
                         .expectedLevel = 2,
                         .shareOfNextLevel = 0.5F},
                    Case{.name = "LinearMipmapLinearQuarterWay",
                         .texelsPerPixel = 4,
                         .filter = M::LinearMipmapLinear,
                         .bias = 0.25F,
                         .expectedLevel = 2,
                         .shareOfNextLevel = 0.25F},
                    Case{.name = "RoundsDown", .texelsPerPixel = 4, .bias = 0.25F, .expectedLevel = 2},
                    Case{.name = "RoundsUp", .texelsPerPixel = 4, .bias = 0.75F, .expectedLevel = 3}),
    [](const auto& test) { return std::string(test.param.name); });

INSTANTIATE_TEST_SUITE_P(
    Limits, MipLevel,
    testing::Values(
        Case{.name = "BiasPlusOne", .texelsPerPixel = 4, .bias = 1, .expectedLevel = 3},
        Case{.name = "BiasMinusOne", .texelsPerPixel = 4, .bias = -1, .expectedLevel = 1},
        Case{.name = "TextureBiasPlusOne", .texelsPerPixel = 4, .textureBias = 1, .expectedLevel = 3},
        Case{.name = "TextureBiasMinusOne", .texelsPerPixel = 4, .textureBias = -1, .expectedLevel = 1},
        Case{.name = "BiasesAddUp", .texelsPerPixel = 4, .bias = -3, .textureBias = 4, .expectedLevel = 3},
        Case{.name = "TextureBiasMagnifies",
             .texelsPerPixel = 4,
             .filter = M::LinearMipmapLinear,
             .textureBias = -2.5F,
             .expectedLevel = 0},
        Case{.name = "TextureBiasBetweenLevels",
             .texelsPerPixel = 4,
             .filter = M::LinearMipmapLinear,
             .bias = 0.125F,
             .textureBias = 0.125F,
             .expectedLevel = 2,
             .shareOfNextLevel = 0.25F},
        Case{.name = "TextureBiasBeyondMaxLod",
             .texelsPerPixel = 4,
             .textureBias = 2,
             .maxLod = 3,
             .expectedLevel = 3},
        // lambda is -12 before the biases: their sum is clamped to 16 (GL_MAX_TEXTURE_LOD_BIAS), and neither
        // alone.
        Case{.name = "OneBiasIsClamped", .texelsPerPixel = 1.0F / 4096, .bias = 16, .expectedLevel = 4},
        Case{.name = "TheSumOfBiasesIsClamped",
             .texelsPerPixel = 1.0F / 4096,
             .bias = 10,
             .textureBias = 8,
             .expectedLevel = 4},
        Case{.name = "TheSumOfBiasesIsClampedBelow", // lambda is 20 before them
             .texelsPerPixel = 1 << 20,
             .bias = -12,
             .textureBias = -12,
             .expectedLevel = 4},
        Case{.name = "ABiasThatTakesTheOtherBack",
             .texelsPerPixel = 4,
             .bias = -16,
             .textureBias = 16,
             .expectedLevel = 2},
        Case{.name = "MinLod", .texelsPerPixel = 2, .minLod = 3, .expectedLevel = 3},
        Case{.name = "MaxLod", .texelsPerPixel = 8, .maxLod = 1, .expectedLevel = 1},
        // The bias comes first, then the clamp.
        Case{.name = "BiasBeyondMaxLod", .texelsPerPixel = 4, .bias = 2, .maxLod = 3, .expectedLevel = 3},
        // Level 2 has 16 x 16 texels: magnified where there is a quarter of a texel a pixel ...
        Case{.name = "BaseLevelMagnified", .texelsPerPixel = 1, .baseLevel = 2, .expectedLevel = 2},
        // ... and lambda counts from the base level: 16 texels of level 0 are 4 of level 2.
        Case{.name = "BaseLevelMinified", .texelsPerPixel = 16, .baseLevel = 2, .expectedLevel = 4},
        Case{.name = "MinLodCountsFromBaseLevel",
             .texelsPerPixel = 4,
             .minLod = 1,
             .baseLevel = 2,
             .expectedLevel = 3},
        Case{.name = "MaxLevel", .texelsPerPixel = 16, .maxLevel = 2, .expectedLevel = 2},
        Case{.name = "BaseIsMax", .texelsPerPixel = 16, .baseLevel = 3, .maxLevel = 3, .expectedLevel = 3}),
    [](const auto& test) { return std::string(test.param.name); });

class Mipmaps : public RenderTest {};

TEST_F(Mipmaps, TheStrongerMinifiedAxisDecides) {
    images.put("image", plainImage(texels, texels, {255, 0, 0, 255}));
    Scene scene = texturedScene();
    scene.textures[0].mipmaps = MipPolicy::Colored;
    scene.textures[0].minFilter = MinFilter::NearestMipmapNearest;
    scene.models[0].texCoords[0] = quadCoords({0, 0, 0, 1}, {0.25F, 2, 0, 1}); // 1 texel a pixel, and 8
    EXPECT_TRUE(isColor(onlyColor(scene, pixels), colorOfLevel(3), 0));
}

TEST_F(Mipmaps, AnisotropySamplesALowerLevelThere) {
    images.put("image", plainImage(texels, texels, {255, 0, 0, 255}));
    Scene scene = texturedScene();
    scene.textures[0].mipmaps = MipPolicy::Colored;
    scene.textures[0].minFilter = MinFilter::LinearMipmapLinear;
    scene.textures[0].maxAnisotropy = capabilities.maxAnisotropy;
    scene.models[0].texCoords[0] = quadCoords({0, 0, 0, 1}, {0.25F, 2, 0, 1});
    // Eight samples along t, each as wide as a texel: level 0 (EXT_texture_filter_anisotropic).
    EXPECT_TRUE(isColor(onlyColor(scene, pixels), {1, 0, 0, 1}));
}

TEST_F(Mipmaps, AMipFilterWithoutMipsIsIncompleteAndDrawsAsIfTexturingWereOff) {
    images.put("image", plainImage(4, 4, {255, 0, 0, 255}));
    Scene scene = texturedScene();
    scene.material.color = {0.2F, 0.4F, 0.6F, 0.8F};
    scene.textures[0].minFilter = MinFilter::NearestMipmapLinear;
    EXPECT_TRUE(isColor(onlyColor(scene), scene.material.color));
    EXPECT_THAT(problems, testing::IsEmpty());
}

TEST_F(Mipmaps, TakenAwayAgainLeaveNoLevelBehind) {
    images.put("image", plainImage(4, 4, {255, 0, 0, 255}));
    Scene scene = texturedScene();
    scene.material.color = {0.2F, 0.4F, 0.6F, 0.8F};
    scene.textures[0].minFilter = MinFilter::NearestMipmapLinear;
    scene.textures[0].mipmaps = MipPolicy::Generated;
    EXPECT_TRUE(isColor(onlyColor(scene), {1, 0, 0, 1}));
    scene.textures[0].mipmaps = MipPolicy::None;
    EXPECT_TRUE(isColor(onlyColor(scene), scene.material.color));
}

struct ChainCase {
    const char* name;
    int width;
    int height;
    std::size_t levels;
};

class MipChainOracle : public RenderTest, public testing::WithParamInterface<ChainCase> {};

// The driver's own box filter, which halves a power of two without any choice. Each of our levels is halved
// by it once: it rounds in its own way, and over several levels that would add up.
TEST_P(MipChainOracle, AgreesWithGlGenerateMipmap) {
    Image base = Image::uninitialised(PixelFormat::Rgba8, GetParam().width, GetParam().height);
    unsigned state = 12345;
    for (std::byte& each : base.pixels) {
        state = state * 1664525U + 1013904223U; // the generator of "Numerical Recipes"
        each = static_cast<std::byte>(state >> 24);
    }
    const MipChain chain = buildMipChain(std::move(base));
    ASSERT_EQ(chain.size(), GetParam().levels);

    const render::TextureHandle texture = render::TextureHandle::create();
    glBindTexture(GL_TEXTURE_2D, texture.name());
    for (std::size_t level = 1; level < chain.size(); ++level) {
        const Image& above = chain[level - 1];
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, above.width, above.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                     above.pixels.data());
        glGenerateMipmap(GL_TEXTURE_2D);
        Image theirs = Image::uninitialised(PixelFormat::Rgba8, chain[level].width, chain[level].height);
        glGetTexImage(GL_TEXTURE_2D, 1, GL_RGBA, GL_UNSIGNED_BYTE, theirs.pixels.data());
        ASSERT_EQ(glGetError(), unsigned{GL_NO_ERROR});
        int worst = 0;
        for (std::size_t i = 0; i < theirs.pixels.size(); ++i)
            worst = std::max(worst, std::abs(std::to_integer<int>(theirs.pixels[i]) -
                                             std::to_integer<int>(chain[level].pixels[i])));
        EXPECT_LE(worst, 1) << "level " << level;
    }
}

INSTANTIATE_TEST_SUITE_P(All, MipChainOracle,
                         testing::Values(ChainCase{"Square", 64, 64, 7}, ChainCase{"Wide", 128, 8, 8},
                                         ChainCase{"Tall", 4, 64, 7}, ChainCase{"Line", 32, 1, 6}),
                         [](const auto& test) { return std::string(test.param.name); });

/// Random texels, the same with every call.
TextureImage noise(int width, int height) {
    Image image = Image::uninitialised(PixelFormat::Rgba8, width, height);
    unsigned state = 12345;
    for (std::byte& each : image.pixels) {
        state = state * 1664525U + 1013904223U; // the generator of "Numerical Recipes"
        each = static_cast<std::byte>(state >> 24);
    }
    return textureOf(std::move(image), {});
}

int largestDifference(const Image& one, const Image& other) {
    int largest = 0;
    for (std::size_t i = 0; i < one.pixels.size(); ++i)
        largest = std::max(
            largest, std::abs(std::to_integer<int>(one.pixels[i]) - std::to_integer<int>(other.pixels[i])));
    return largest;
}

struct DriverCase {
    const char* name;
    MipPolicy policy;
    InternalFormat format;
    int width, height;
};

class DriverMipmaps : public RenderTest, public testing::WithParamInterface<DriverCase> {
protected:
    /// What OpenGL itself makes of the base, by the call or the parameter of the policy.
    static std::vector<Image> chainOf(const Image& base) {
        const render::TextureHandle texture = render::TextureHandle::create();
        glBindTexture(GL_TEXTURE_2D, texture.name());
        const bool onUpload = GetParam().policy == MipPolicy::OnUpload;
        glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, onUpload ? GL_TRUE : GL_FALSE);
        const bool isSrgbFormat = isSrgb(GetParam().format);
        glTexImage2D(GL_TEXTURE_2D, 0, isSrgbFormat ? GL_SRGB8_ALPHA8 : GL_RGBA8, base.width, base.height, 0,
                     GL_RGBA, GL_UNSIGNED_BYTE, base.pixels.data());
        if (!onUpload)
            glGenerateMipmap(GL_TEXTURE_2D);
        std::vector<Image> chain;
        for (int level = 0; level < mipLevelCount(base.width, base.height); ++level) {
            Image image = Image::uninitialised(PixelFormat::Rgba8, std::max(1, base.width >> level),
                                               std::max(1, base.height >> level));
            glGetTexImage(GL_TEXTURE_2D, level, GL_RGBA, GL_UNSIGNED_BYTE, image.pixels.data());
            chain.push_back(std::move(image));
        }
        EXPECT_EQ(glGetError(), unsigned{GL_NO_ERROR});
        return chain;
    }
};

// The object's levels are the driver's own, byte for byte; those that other renderers have differ by its
// rounding, once for each level.
TEST_P(DriverMipmaps, AreWhatTheDriverMakes) {
    const DriverCase& row = GetParam();
    Texture texture;
    texture.mipmaps = row.policy;
    texture.internalFormat = row.format;
    texture.mipFilter = MipFilter::Cubic; // has no effect
    const TextureImage image = noise(row.width, row.height);
    const Result<TextureLevels> levels = prepareLevels(texture, image);
    ASSERT_TRUE(levels);
    render::GlErrors errors;
    const render::TextureObject object(Target::Texture2D, *levels, "test", errors);
    EXPECT_THAT(errors.sentences(), testing::IsEmpty());
    const std::vector<Image> expected = chainOf(std::get<Image>(*levels->levels.front().surface));
    const Result<std::vector<TextureLevel>> found = object.read();
    ASSERT_TRUE(found);
    ASSERT_EQ(found->size(), expected.size());
    ASSERT_EQ(levels->levels.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        const Image& made = std::get<Image>(*(*found)[i].surface);
        EXPECT_EQ(made, expected[i]) << "level " << i;
        EXPECT_LE(largestDifference(made, std::get<Image>(*levels->levels[i].surface)), static_cast<int>(i))
            << "level " << i;
    }
}

// Of blocks and depths a driver makes none, and of few bits it has more: all renderers have Texplorer's
// levels.
TEST(DriverLevels, AreOfColoursOfEightBitsAlone) {
    const auto isMadeByDriver = [](const auto& change) {
        Texture texture;
        texture.mipmaps = MipPolicy::GenerateMipmap;
        change(texture);
        return prepareLevels(texture, noise(16, 16))->madeByDriver;
    };
    EXPECT_TRUE(isMadeByDriver([](Texture&) {}));
    EXPECT_TRUE(isMadeByDriver([](Texture& x) { x.compression = Compression::Driver; }));
    EXPECT_FALSE(isMadeByDriver([](Texture& x) { x.compression = Compression::Cached; }));
    EXPECT_FALSE(isMadeByDriver([](Texture& x) { x.internalFormat = InternalFormat::Rgba2; }));
    EXPECT_FALSE(isMadeByDriver([](Texture& x) { x.internalFormat = InternalFormat::DepthComponent24; }));
    EXPECT_FALSE(isMadeByDriver([](Texture& x) { x.mipmaps = MipPolicy::Generated; }));
}

INSTANTIATE_TEST_SUITE_P(
    All, DriverMipmaps,
    testing::Values(DriverCase{"Call", MipPolicy::GenerateMipmap, InternalFormat::Rgba, 64, 16},
                    DriverCase{"Parameter", MipPolicy::OnUpload, InternalFormat::Rgba, 16, 64},
                    DriverCase{"Srgb", MipPolicy::GenerateMipmap, InternalFormat::Srgb8Alpha8, 32, 32}),
    [](const auto& test) { return std::string(test.param.name); });

} // namespace
} // namespace texplorer::mipmap_test

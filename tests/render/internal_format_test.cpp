// What OpenGL makes of each internal format, against numbers from the specification: a texture of four texels
// that fills the picture, with each of OpenGL's renderers.

#include "app/render/gl_handle.h"
#include "tests/support/flat_scene.h"
#include "tests/support/render_fixture.h"
#include "texplorer/reference/draw.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

namespace texplorer::internal_format_test {
namespace {

using namespace test;

struct FormatCase {
    InternalFormat format;
    std::array<float, 4> expected; ///< of the texel (100, 150, 200, 60) over white
};

class InternalFormats : public RenderTest, public testing::WithParamInterface<FormatCase> {
protected:
    /// One texel of that colour everywhere, in the place of the fragment's.
    Scene oneTexel() {
        images.put("image", plainImage(1, 1, {100, 150, 200, 60}));
        Scene scene = texturedScene();
        scene.passes[0].units[0].envMode = EnvMode::Replace;
        scene.textures[0].internalFormat = GetParam().format;
        return scene;
    }
};

// Section 2.14.9: the nearest number of so many bits, over the largest; EXT_texture_sRGB: ((c + 0.055)
// / 1.055)^2.4 for colours alone. What a format lacks is the fragment's, 1 (table 3.21).
TEST_P(InternalFormats, GiveWhatTheirNumbersStandFor) {
    const glm::vec4 found = onlyColor(oneTexel());
    EXPECT_THAT(problems, testing::IsEmpty());
    for (int c = 0; c < 4; ++c)
        EXPECT_NEAR(found[c], GetParam().expected.at(static_cast<std::size_t>(c)), 1.01 / 255)
            << "component " << c;
}

// Two texels, black and of that colour, half and half: decoded or rounded before the filter and not after it.
TEST_P(InternalFormats, AreFilteredAfterwards) {
    Image image = plainImage(2, 1, {0, 0, 0, 0});
    std::ranges::copy(plainImage(1, 1, {100, 150, 200, 60}).at(0, 0), image.at(1, 0).begin());
    images.put("image", image);
    Scene scene = texturedScene();
    scene.passes[0].units[0].envMode = EnvMode::Replace;
    scene.textures[0].internalFormat = GetParam().format;
    scene.textures[0].magFilter = MagFilter::Linear;
    scene.textures[0].minFilter = MinFilter::Linear;
    scene.models[0].texCoords[0] = TexCoords(4, {0.5F, 0.5F, 0, 1}); // half-way between both
    const glm::vec4 found = onlyColor(scene);
    const BaseFormat base = baseFormat(GetParam().format);
    for (int c = 0; c < 4; ++c) {
        const bool hasColor = base != BaseFormat::Alpha;
        const bool hasAlpha = base != BaseFormat::Rgb && base != BaseFormat::Luminance;
        const float whole = GetParam().expected.at(static_cast<std::size_t>(c));
        const bool stored = c < 3 ? hasColor : hasAlpha;
        EXPECT_NEAR(found[c], stored ? whole / 2 : whole, 1.51 / 255) << "component " << c;
    }
}

// The gradient from one end of the numbers to the other.
TEST_P(InternalFormats, AgreeWithTheReference) {
    Scene scene = texturedScene();
    scene.textures[0] = {};
    scene.textures[0].pattern = Pattern::Gradient;
    scene.textures[0].internalFormat = GetParam().format;
    scene.textures[0].mipmaps = MipPolicy::Generated;
    scene.textures[0].magFilter = MagFilter::Nearest;
    scene.textures[0].minFilter = MinFilter::NearestMipmapNearest;
    scene.passes[0].units[0].envMode = EnvMode::Replace;
    for (const int extent : {256, 64}) {
        const Image theirs = picture(scene, extent, 0);
        const Result<Frame> ours = reference::drawReference({scene, images, 0, extent, extent});
        ASSERT_TRUE(ours) << describe(ours.error());
        int most = 0;
        for (std::size_t i = 0; i < theirs.pixels.size(); ++i)
            most = std::max(most, std::abs(std::to_integer<int>(theirs.pixels[i]) -
                                           std::to_integer<int>(ours->image.pixels[i])));
        EXPECT_LE(most, 1) << extent;
    }
}

constexpr float light100 = 0.127438F;
constexpr float light150 = 0.304987F;
constexpr float light200 = 0.577580F;
constexpr float alpha60 = 60 / 255.0F;
constexpr float c100 = 100 / 255.0F;
constexpr float c150 = 150 / 255.0F;
constexpr float c200 = 200 / 255.0F;
using I = InternalFormat;
INSTANTIATE_TEST_SUITE_P(
    All, InternalFormats,
    testing::Values(
        FormatCase{I::Rgb5A1, {12 / 31.0F, 18 / 31.0F, 24 / 31.0F, 0}},
        FormatCase{I::Rgba4, {6 / 15.0F, 9 / 15.0F, 12 / 15.0F, 4 / 15.0F}},
        FormatCase{I::Rgba2, {1 / 3.0F, 2 / 3.0F, 2 / 3.0F, 1 / 3.0F}},
        FormatCase{I::Rgb5, {12 / 31.0F, 18 / 31.0F, 24 / 31.0F, 1}},
        FormatCase{I::Rgb4, {6 / 15.0F, 9 / 15.0F, 12 / 15.0F, 1}},
        FormatCase{I::R3G3B2, {3 / 7.0F, 4 / 7.0F, 2 / 3.0F, 1}},
        FormatCase{I::Luminance4, {6 / 15.0F, 6 / 15.0F, 6 / 15.0F, 1}},
        FormatCase{I::Luminance4Alpha4, {6 / 15.0F, 6 / 15.0F, 6 / 15.0F, 4 / 15.0F}},
        FormatCase{I::Intensity4, {6 / 15.0F, 6 / 15.0F, 6 / 15.0F, 6 / 15.0F}},
        FormatCase{I::Alpha4, {1, 1, 1, 4 / 15.0F}}, FormatCase{I::Rgb10A2, {c100, c150, c200, 1 / 3.0F}},
        FormatCase{I::Luminance6Alpha2, {25 / 63.0F, 25 / 63.0F, 25 / 63.0F, 1 / 3.0F}},
        FormatCase{I::Luminance12Alpha4, {c100, c100, c100, 4 / 15.0F}},
        FormatCase{I::Components4, {c100, c150, c200, alpha60}},
        FormatCase{I::Components3, {c100, c150, c200, 1}},
        FormatCase{I::Components2, {c100, c100, c100, alpha60}},
        FormatCase{I::Components1, {c100, c100, c100, 1}}, FormatCase{I::Rgba8, {c100, c150, c200, alpha60}},
        FormatCase{I::Rgba16, {c100, c150, c200, alpha60}}, FormatCase{I::Rgb12, {c100, c150, c200, 1}},
        FormatCase{I::Luminance16, {c100, c100, c100, 1}},
        FormatCase{I::Luminance12Alpha12, {c100, c100, c100, alpha60}},
        FormatCase{I::Intensity16, {c100, c100, c100, c100}}, FormatCase{I::Alpha12, {1, 1, 1, alpha60}},
        FormatCase{I::Rgba32F, {c100, c150, c200, alpha60}}, FormatCase{I::Rgb32F, {c100, c150, c200, 1}},
        FormatCase{I::Luminance32F, {c100, c100, c100, 1}},
        FormatCase{I::LuminanceAlpha32F, {c100, c100, c100, alpha60}},
        FormatCase{I::Intensity32F, {c100, c100, c100, c100}}, FormatCase{I::Alpha32F, {1, 1, 1, alpha60}},
        FormatCase{I::Rgba16F, {c100, c150, c200, alpha60}}, FormatCase{I::Rgb16F, {c100, c150, c200, 1}},
        FormatCase{I::Luminance16F, {c100, c100, c100, 1}},
        FormatCase{I::LuminanceAlpha16F, {c100, c100, c100, alpha60}},
        FormatCase{I::Intensity16F, {c100, c100, c100, c100}}, FormatCase{I::Alpha16F, {1, 1, 1, alpha60}},
        FormatCase{I::SrgbAlpha, {light100, light150, light200, alpha60}},
        FormatCase{I::Sluminance, {light100, light100, light100, 1}},
        FormatCase{I::Srgb8Alpha8, {light100, light150, light200, alpha60}},
        FormatCase{I::Srgb8, {light100, light150, light200, 1}},
        FormatCase{I::Sluminance8Alpha8, {light100, light100, light100, alpha60}},
        FormatCase{I::Sluminance8, {light100, light100, light100, 1}}),
    [](const auto& test) { return std::string(rowOf(test.param.format).name); });

struct FloatCase {
    EnvMode mode;
    std::array<float, 4> expected;
};

class FloatTexels : public RenderTest, public testing::WithParamInterface<FloatCase> {};

// The texel (2, -1, 0.5, 1.5) on a fragment of 0.25 everywhere, with the constant 0.3: tables 3.21 and 3.22,
// of which only the result is limited to 0 ... 1.
TEST_P(FloatTexels, AreNotLimitedBeforeTheEnvironment) {
    for (const InternalFormat format : {InternalFormat::Rgba32F, InternalFormat::Rgba16F}) {
        images.put("image", plainImage(4, 4, {255, 0, 0, 255}));
        Scene scene = texturedScene();
        scene.material.color = glm::vec4(0.25F);
        Texture& texture = scene.textures[0];
        texture.internalFormat = format;
        texture.upload = {.custom = true, .scale = {2, 1, 1, 1.5F}, .bias = {0, -1, 0.5F, 0}};
        Unit& unit = scene.passes[0].units[0];
        unit.envMode = GetParam().mode;
        unit.envColor = glm::vec4(0.3F);
        const Result<Frame> ours = reference::drawReference({scene, images, 0, 8, 8});
        ASSERT_TRUE(ours) << describe(ours.error());
        EXPECT_EQ(picture(scene, 8, 0), ours->image);
        const glm::vec4 found = onlyColor(scene);
        for (int c = 0; c < 4; ++c)
            EXPECT_NEAR(found[c], GetParam().expected.at(static_cast<std::size_t>(c)), 1.01 / 255) << c;
    }
}

INSTANTIATE_TEST_SUITE_P(All, FloatTexels,
                         testing::Values(FloatCase{EnvMode::Replace, {1, 0, 0.5F, 1}},
                                         FloatCase{EnvMode::Modulate, {0.5F, 0, 0.125F, 0.375F}},
                                         FloatCase{EnvMode::Decal, {1, 0, 0.625F, 0.25F}},
                                         FloatCase{EnvMode::Blend, {0.35F, 0.2F, 0.275F, 0.375F}},
                                         FloatCase{EnvMode::Add, {1, 0, 0.75F, 0.375F}}),
                         [](const auto& test) { return std::string(rowOf(test.param.mode).name); });

class NamesOfInternalFormats : public RenderTest {
protected:
    /// What OpenGL says of glTexImage2D, called directly.
    static GLenum errorOf(GLint format, bool isDepth = false, int border = 0) {
        const render::TextureHandle texture = render::TextureHandle::create();
        glBindTexture(GL_TEXTURE_2D, texture.name());
        glTexImage2D(GL_TEXTURE_2D, 0, format, 4 + 2 * border, 4 + 2 * border, border,
                     static_cast<GLenum>(isDepth ? GL_DEPTH_COMPONENT : GL_RGBA), GL_UNSIGNED_BYTE, nullptr);
        return glGetError();
    }
    Scene oneTexel(InternalFormat format) {
        images.put("image", plainImage(8, 8, {100, 150, 200, 60}));
        Scene scene = texturedScene();
        scene.textures[0].internalFormat = format;
        scene.passes[0].units[0].envMode = EnvMode::Replace;
        return scene;
    }
};

TEST_F(NamesOfInternalFormats, AreAcceptedOrRefusedByOpenGl) {
    for (const FormatFacts& facts : formatFacts) {
        if (facts.format == InternalFormat::Bgra)
            continue; // refused by OpenGL 2.1, taken by Mesa 25, which names no extension for it
        EXPECT_EQ(errorOf(static_cast<GLint>(facts.format), isDepth(facts.format)),
                  static_cast<GLenum>(isRefused(facts.format) ? GL_INVALID_VALUE : GL_NO_ERROR))
            << rowOf(facts.format).name;
    }
    EXPECT_EQ(errorOf(GL_RGB, false, 1), static_cast<GLenum>(GL_NO_ERROR));
    EXPECT_EQ(errorOf(GL_RGB, false, 2), static_cast<GLenum>(GL_INVALID_VALUE));
}

// Section 3.8.10: a texture without an image is incomplete. The fragment stays as it is, white.
TEST_F(NamesOfInternalFormats, ThatAreRefusedLeaveNoImage) {
    const auto expectWhite = [&](const Scene& scene, const char* why) {
        EXPECT_EQ(onlyColor(scene), glm::vec4(1)) << why;
        EXPECT_THAT(problems, testing::Contains(testing::HasSubstr("GL_INVALID_VALUE"))) << why;
        const Result<Frame> ours = reference::drawReference({scene, images, 0, 8, 8});
        ASSERT_TRUE(ours) << describe(ours.error());
        EXPECT_EQ(ours->image, picture(scene, 8, 0)) << why;
    };
    for (const InternalFormat format : {InternalFormat::Bgr, InternalFormat::UnsignedByte,
                                        InternalFormat::Components0, InternalFormat::Components5})
        expectWhite(oneTexel(format), rowOf(format).name.data());
    Scene scene = oneTexel(InternalFormat::Rgb);
    scene.textures[0].border = 2;
    expectWhite(scene, "border");
}

// What the driver chose is said, and is not far from the image.
TEST_F(NamesOfInternalFormats, LeaveTheFormatToTheDriver) {
    for (const auto& [format, expected] :
         {std::pair{InternalFormat::CompressedRgb, glm::vec4(100, 150, 200, 255)},
          std::pair{InternalFormat::CompressedRgba, glm::vec4(100, 150, 200, 60)},
          std::pair{InternalFormat::CompressedLuminanceAlpha, glm::vec4(100, 100, 100, 60)},
          std::pair{InternalFormat::CompressedAlpha, glm::vec4(255, 255, 255, 60)}}) {
        const glm::vec4 found = onlyColor(oneTexel(format)) * 255.0F;
        for (int c = 0; c < 4; ++c)
            EXPECT_NEAR(found[c], expected[c], 255 / 31.0F) << rowOf(format).name << " component " << c;
        const Result<view::Frame> frame = renderer->draw(oneTexel(format), images, 0, {8, 8});
        ASSERT_TRUE(frame) << describe(frame.error());
        const auto stored = frame->stored.find({0, Target::Texture2D});
        ASSERT_NE(stored, frame->stored.end()) << rowOf(format).name;
        EXPECT_THAT(stored->second->levels.at(0).internalFormat, testing::StartsWith("GL_"));
    }
}

} // namespace
} // namespace texplorer::internal_format_test

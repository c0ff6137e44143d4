// Each parameter of a Texture is what glGetTexParameter answers afterwards.

#include "app/render/texture_object.h"
#include "tests/support/flat_scene.h"
#include "tests/support/render_fixture.h"

#include <glm/gtc/type_ptr.hpp>
#include <gmock/gmock.h>

namespace texplorer::render::texture_object_test {
namespace {

using namespace test;

class TextureParameters : public RenderTest, public testing::WithParamInterface<Target> {
protected:
    TextureObject make(MipPolicy mipmaps) {
        Texture texture;
        texture.mipmaps = mipmaps;
        return TextureObject(
            GetParam(),
            *prepareLevels(texture, textureOf(plainImage(8, 8, {10, 20, 30, 40}), {}), GetParam()), "test",
            errors);
    }
    float parameter(GLenum name) const {
        GLfloat value = -1;
        glGetTexParameterfv(static_cast<GLenum>(GetParam()), name, &value);
        return value;
    }
    GlErrors errors;
};

TEST_P(TextureParameters, AreReadBackEqual) {
    Texture texture;
    texture.magFilter = MagFilter::Nearest;
    texture.minFilter = MinFilter::LinearMipmapNearest;
    texture.wrapS = Wrap::Clamp;
    texture.wrapT = Wrap::MirroredRepeat;
    texture.wrapR = Wrap::ClampToBorder;
    texture.borderColor = {0.25F, 0.5F, 0.75F, 1};
    texture.baseLevel = 1;
    texture.maxLevel = 2;
    texture.minLod = -3.5F;
    texture.maxLod = 4.5F;
    texture.maxAnisotropy = 2;
    texture.priority = 0.5F;
    TextureObject object = make(MipPolicy::Generated);
    object.apply(texture, capabilities.maxAnisotropy, "test", errors);
    ASSERT_THAT(errors.sentences(), testing::IsEmpty());

    const auto target = static_cast<GLenum>(GetParam());
    glBindTexture(target, object.name());
    EXPECT_EQ(parameter(GL_TEXTURE_MAG_FILTER), GL_NEAREST);
    EXPECT_EQ(parameter(GL_TEXTURE_MIN_FILTER), GL_LINEAR_MIPMAP_NEAREST);
    EXPECT_EQ(parameter(GL_TEXTURE_WRAP_S), GL_CLAMP);
    EXPECT_EQ(parameter(GL_TEXTURE_WRAP_T), GL_MIRRORED_REPEAT);
    EXPECT_EQ(parameter(GL_TEXTURE_WRAP_R), GL_CLAMP_TO_BORDER);
    EXPECT_EQ(parameter(GL_TEXTURE_BASE_LEVEL), 1);
    EXPECT_EQ(parameter(GL_TEXTURE_MAX_LEVEL), 2);
    EXPECT_EQ(parameter(GL_TEXTURE_MIN_LOD), -3.5F);
    EXPECT_EQ(parameter(GL_TEXTURE_MAX_LOD), 4.5F);
    EXPECT_EQ(parameter(GL_TEXTURE_MAX_ANISOTROPY_EXT), 2);
    EXPECT_EQ(parameter(GL_TEXTURE_PRIORITY), 0.5F);
    glm::vec4 border{-1};
    glGetTexParameterfv(target, GL_TEXTURE_BORDER_COLOR, glm::value_ptr(border));
    EXPECT_EQ(border, texture.borderColor);
}

TEST_P(TextureParameters, BeginWithGlsInitialValues) {
    const TextureHandle fresh = TextureHandle::create();
    const auto target = static_cast<GLenum>(GetParam());
    constexpr std::array names{GL_TEXTURE_MAG_FILTER,
                               GL_TEXTURE_MIN_FILTER,
                               GL_TEXTURE_WRAP_S,
                               GL_TEXTURE_WRAP_T,
                               GL_TEXTURE_WRAP_R,
                               GL_TEXTURE_BASE_LEVEL,
                               GL_TEXTURE_MAX_LEVEL,
                               GL_TEXTURE_MIN_LOD,
                               GL_TEXTURE_MAX_LOD,
                               GL_TEXTURE_PRIORITY,
                               GL_TEXTURE_MAX_ANISOTROPY_EXT};
    TextureObject object = make(MipPolicy::None);
    object.apply(Texture{}, capabilities.maxAnisotropy, "test", errors);
    for (const auto name : names) {
        glBindTexture(target, fresh.name());
        const float initial = parameter(static_cast<GLenum>(name));
        glBindTexture(target, object.name());
        EXPECT_EQ(parameter(static_cast<GLenum>(name)), initial) << "0x" << std::hex << name;
    }
}

TEST_P(TextureParameters, AnisotropyIsClampedToWhatTheDriverHas) {
    TextureObject object = make(MipPolicy::None);
    Texture texture;
    texture.maxAnisotropy = 1000;
    object.apply(texture, capabilities.maxAnisotropy, "test", errors);
    EXPECT_EQ(parameter(GL_TEXTURE_MAX_ANISOTROPY_EXT), capabilities.maxAnisotropy);
    texture.maxAnisotropy = 0;
    object.apply(texture, capabilities.maxAnisotropy, "test", errors);
    EXPECT_EQ(parameter(GL_TEXTURE_MAX_ANISOTROPY_EXT), 1);
    EXPECT_THAT(errors.sentences(), testing::IsEmpty());
}

// Without the extension the parameter does not exist: naming it would be an error.
TEST_P(TextureParameters, AnisotropyIsLeftAloneWhereTheDriverHasNone) {
    TextureObject object = make(MipPolicy::None);
    Texture texture;
    texture.maxAnisotropy = 8;
    object.apply(texture, 1, "test", errors);
    EXPECT_EQ(parameter(GL_TEXTURE_MAX_ANISOTROPY_EXT), 1);
}

INSTANTIATE_TEST_SUITE_P(Targets, TextureParameters,
                         testing::Values(Target::Texture1D, Target::Texture2D, Target::Texture3D,
                                         Target::CubeMap),
                         [](const auto& test) { return std::string(rowOf(test.param).name); });

struct FormatCase {
    InternalFormat format;
    std::array<int, 6> bits; // red, green, blue, alpha, luminance, intensity
};

class TextureFormat : public RenderTest, public testing::WithParamInterface<FormatCase> {
protected:
    /// What the driver says of a texture of that format; -1: nothing.
    std::array<int, 6> storedBits() {
        GlErrors errors;
        Texture texture;
        texture.internalFormat = GetParam().format;
        const TextureObject object(Target::Texture2D,
                                   *prepareLevels(texture, textureOf(plainImage(2, 2, {1, 2, 3, 4}), {})),
                                   "test", errors);
        EXPECT_THAT(errors.sentences(), testing::IsEmpty());
        glBindTexture(GL_TEXTURE_2D, object.name());
        constexpr std::array sizes{GL_TEXTURE_RED_SIZE,       GL_TEXTURE_GREEN_SIZE,
                                   GL_TEXTURE_BLUE_SIZE,      GL_TEXTURE_ALPHA_SIZE,
                                   GL_TEXTURE_LUMINANCE_SIZE, GL_TEXTURE_INTENSITY_SIZE};
        std::array<int, 6> bits{};
        for (std::size_t i = 0; i < sizes.size(); ++i) {
            bits[i] = -1;
            glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, static_cast<GLenum>(sizes[i]), &bits[i]);
        }
        return bits;
    }
};

TEST_P(TextureFormat, StoresEightBitsOfWhatTheBaseFormatHas) {
    EXPECT_EQ(storedBits(), GetParam().bits);
}

INSTANTIATE_TEST_SUITE_P(All, TextureFormat,
                         testing::Values(FormatCase{InternalFormat::Alpha, {0, 0, 0, 8, 0, 0}},
                                         FormatCase{InternalFormat::Luminance, {0, 0, 0, 0, 8, 0}},
                                         FormatCase{InternalFormat::LuminanceAlpha, {0, 0, 0, 8, 8, 0}},
                                         FormatCase{InternalFormat::Intensity, {0, 0, 0, 0, 0, 8}},
                                         FormatCase{InternalFormat::Rgb, {8, 8, 8, 0, 0, 0}},
                                         FormatCase{InternalFormat::Rgba, {8, 8, 8, 8, 0, 0}}),
                         [](const auto& test) { return std::string(rowOf(test.param.format).name); });

using TextureFormatOfFewBits = TextureFormat;

// A driver may keep more bits than a format's name says, but not fewer: the numbers of the pixels would be
// lost.
TEST_P(TextureFormatOfFewBits, StoresNoFewerBitsThanItsNameSays) {
    const std::array<int, 6> bits = storedBits();
    for (std::size_t i = 0; i < bits.size(); ++i) {
        EXPECT_GE(bits[i], GetParam().bits[i]) << "size " << i;
        EXPECT_TRUE(bits[i] == 0 || GetParam().bits[i] > 0 || i == 3) << "size " << i;
    }
}

INSTANTIATE_TEST_SUITE_P(All, TextureFormatOfFewBits,
                         testing::Values(FormatCase{InternalFormat::Rgb5A1, {5, 5, 5, 1, 0, 0}},
                                         FormatCase{InternalFormat::Rgba4, {4, 4, 4, 4, 0, 0}},
                                         FormatCase{InternalFormat::Rgba2, {2, 2, 2, 2, 0, 0}},
                                         FormatCase{InternalFormat::Rgb5, {5, 5, 5, 0, 0, 0}},
                                         FormatCase{InternalFormat::Rgb4, {4, 4, 4, 0, 0, 0}},
                                         FormatCase{InternalFormat::R3G3B2, {3, 3, 2, 0, 0, 0}},
                                         FormatCase{InternalFormat::Luminance4, {0, 0, 0, 0, 4, 0}},
                                         FormatCase{InternalFormat::Luminance4Alpha4, {0, 0, 0, 4, 4, 0}},
                                         FormatCase{InternalFormat::Intensity4, {0, 0, 0, 0, 0, 4}},
                                         FormatCase{InternalFormat::Alpha4, {0, 0, 0, 4, 0, 0}},
                                         FormatCase{InternalFormat::Srgb8Alpha8, {8, 8, 8, 8, 0, 0}},
                                         FormatCase{InternalFormat::Srgb8, {8, 8, 8, 0, 0, 0}},
                                         FormatCase{InternalFormat::Sluminance8Alpha8, {0, 0, 0, 8, 8, 0}},
                                         FormatCase{InternalFormat::Sluminance8, {0, 0, 0, 0, 8, 0}}),
                         [](const auto& test) { return std::string(rowOf(test.param.format).name); });

} // namespace
} // namespace texplorer::render::texture_object_test

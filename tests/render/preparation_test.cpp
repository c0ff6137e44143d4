// What is done to a picture before it is uploaded, against what the driver does while it is uploaded.

#include "tests/support/flat_scene.h"
#include "tests/support/render_fixture.h"
#include "texplorer/image/preparation.h"

#include <GL/glew.h>

#include <array>

namespace texplorer::preparation_on_the_driver_test {
namespace {

using namespace test;

constexpr std::array<GLenum, 4> scales{GL_RED_SCALE, GL_GREEN_SCALE, GL_BLUE_SCALE, GL_ALPHA_SCALE};
constexpr std::array<GLenum, 4> biases{GL_RED_BIAS, GL_GREEN_BIAS, GL_BLUE_BIAS, GL_ALPHA_BIAS};

void setTransfer(const glm::vec4& factor, const glm::vec4& bias) {
    for (int i = 0; i < 4; ++i) {
        glPixelTransferf(scales[static_cast<std::size_t>(i)], factor[i]);
        glPixelTransferf(biases[static_cast<std::size_t>(i)], bias[i]);
    }
}

/// What OpenGL keeps of it as GL_RGBA8.
Image uploaded(const Image& image, GLenum format) {
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, image.width, image.height, 0, format, GL_UNSIGNED_BYTE,
                 image.pixels.data());
    setTransfer(glm::vec4(1), glm::vec4(0));
    Image kept = Image::uninitialised(PixelFormat::Rgba8, image.width, image.height);
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, kept.pixels.data());
    glDeleteTextures(1, &name);
    return kept;
}

class PixelTransfer : public RenderTest {};

/// Every value of every component, and of each format the components that are missing.
TEST_F(PixelTransfer, IsWhatScalingDoesBitForBit) {
    struct Format {
        PixelFormat format;
        GLenum name;
    };
    constexpr std::array formats{Format{PixelFormat::Alpha8, GL_ALPHA},
                                 Format{PixelFormat::Luminance8, GL_LUMINANCE},
                                 Format{PixelFormat::LuminanceAlpha8, GL_LUMINANCE_ALPHA},
                                 Format{PixelFormat::Rgb8, GL_RGB}, Format{PixelFormat::Rgba8, GL_RGBA}};
    const std::array factors{glm::vec4(0.5F), glm::vec4(2, 1.7F, -1, 0.3F), glm::vec4(1, 0.25F, 1, 16)};
    const std::array offsets{glm::vec4(0), glm::vec4(0.1F, -0.25F, 1, 0.5F), glm::vec4(0, 0, 0.002F, -2)};
    for (const auto& [format, name] : formats) {
        Image image = Image::uninitialised(format, 256, 1);
        for (std::size_t i = 0; i < image.pixels.size(); ++i)
            image.pixels[i] =
                static_cast<std::byte>(i / static_cast<std::size_t>(bytesPerPixel(format)) +
                                       64 * (i % static_cast<std::size_t>(bytesPerPixel(format))));
        for (const glm::vec4& factor : factors) {
            for (const glm::vec4& bias : offsets) {
                setTransfer(factor, bias);
                const Image driver = uploaded(image, name);
                const Image made = prepared(image, {.op = ImageOp::Scale, .factor = factor, .bias = bias});
                const auto madeName = std::ranges::find(formats, made.format, &Format::format)->name;
                EXPECT_EQ(uploaded(made, madeName), driver)
                    << rowOf(format).name << " " << factor.x << " " << bias.x;
            }
        }
    }
}

/// A level of another size leaves the unit off, and so does a missing one.
TEST_F(PixelTransfer, GivenLevelsAreAsCompleteAsTheDriverFindsThem) {
    images.put("image", plainImage(8, 8, {255, 0, 0, 255}));
    images.put("half", plainImage(4, 4, {255, 0, 0, 255}));
    images.put("wrong", plainImage(3, 4, {255, 0, 0, 255}));
    Scene scene = texturedScene();
    scene.material.color = {0, 1, 0, 1};
    Texture& texture = scene.textures[0];
    texture.minFilter = MinFilter::LinearMipmapNearest;
    texture.mipmaps = MipPolicy::Given;
    texture.maxLevel = 1;
    EXPECT_TRUE(isColor(onlyColor(scene), {0, 1, 0, 1})) << "the level is missing";
    texture.levels = {{.source = SourceKind::File, .file = "half"}};
    EXPECT_TRUE(isColor(onlyColor(scene), {1, 0, 0, 1}));
    texture.levels[0].file = "wrong";
    EXPECT_TRUE(isColor(onlyColor(scene), {0, 1, 0, 1}));
}

} // namespace
} // namespace texplorer::preparation_on_the_driver_test

// The picture of the texture-space panel is uploaded like the texture: read back, it has the values that
// OpenGL 2.1, table 3.11 and section 3.8.1, gives to each base internal format.

#include "app/offscreen/context.h"
#include "app/render/capabilities.h"
#include "app/render/texture_preview.h"

#include <GL/glew.h>
#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace texplorer::render::texture_preview_test {
namespace {

using Texel = std::array<int, 4>;

struct Case {
    const char* name;
    InternalFormat format;
    Texel expected; // of the pixel (200, 100, 50, 128)
};

class Preview : public testing::TestWithParam<Case> {};

TEST_P(Preview, HasTheComponentsOfItsInternalFormat) {
    const auto context = offscreen::Context::create({4, 4}).value();
    ASSERT_TRUE(loadCapabilities().has_value());
    Image image = Image::uninitialised(PixelFormat::Rgba8, 1, 1);
    constexpr std::array<int, 4> pixel{200, 100, 50, 128};
    for (std::size_t i = 0; i < 4; ++i)
        image.pixels[i] = static_cast<std::byte>(pixel[i]);
    ImageSource images;
    images.put("pixel", image);
    Texture texture;
    texture.source = SourceKind::File;
    texture.file = "pixel";
    texture.internalFormat = GetParam().format;

    TexturePreview preview;
    const unsigned name = preview.show(texture, images);
    ASSERT_NE(name, 0U);
    EXPECT_EQ(preview.show(texture, images), name) << "nothing changed, nothing is uploaded";
    glBindTexture(GL_TEXTURE_2D, name);
    glEnable(GL_TEXTURE_2D);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glColor4f(1, 1, 1, 1);
    glBegin(GL_QUADS);
    glVertex2f(-1, -1);
    glVertex2f(1, -1);
    glVertex2f(1, 1);
    glVertex2f(-1, 1);
    glEnd();
    std::array<unsigned char, 4> drawn{};
    glReadPixels(1, 1, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, drawn.data());
    EXPECT_EQ((Texel{drawn[0], drawn[1], drawn[2], drawn[3]}), GetParam().expected);
}

// REPLACE: missing components come from the fragment, which is white.
INSTANTIATE_TEST_SUITE_P(
    Formats, Preview,
    testing::Values(
        Case{"Rgba", InternalFormat::Rgba, {200, 100, 50, 128}},
        Case{"Rgb", InternalFormat::Rgb, {200, 100, 50, 255}},
        Case{"Luminance", InternalFormat::Luminance, {200, 200, 200, 255}},
        Case{"LuminanceAlpha", InternalFormat::LuminanceAlpha, {200, 200, 200, 128}},
        Case{"Intensity", InternalFormat::Intensity, {200, 200, 200, 200}},
        Case{"Alpha", InternalFormat::Alpha, {255, 255, 255, 128}},
        // 200, 100 and 50 are 12, 6 and 3 of 15 (11.8, 5.9, 2.9), 128 is 8 (7.5): 17 times as much.
        Case{"Rgba4", InternalFormat::Rgba4, {204, 102, 51, 136}},
        // 5 and 3 of 7, 1 of 3, in 255ths.
        Case{"R3G3B2", InternalFormat::R3G3B2, {182, 109, 85, 255}},
        // As in the file, regardless of the texture's transfer curve.
        Case{"Srgb", InternalFormat::Srgb8Alpha8, {200, 100, 50, 128}}),
    [](const auto& test) { return test.param.name; });

TEST(TexturePreview, UnfoldsTheSixFacesOfAFile) {
    const auto context = offscreen::Context::create({4, 4}).value();
    ASSERT_TRUE(loadCapabilities().has_value());
    TextureImage file;
    file.faces = 6;
    file.topFirst = true;
    for (int face = 0; face < 6; ++face) {
        Image image = Image::uninitialised(PixelFormat::Luminance8, 1, 1);
        image.pixels[0] = static_cast<std::byte>(40 + face);
        file.surfaces.emplace_back(std::move(image));
    }
    ImageSource images;
    images.put("cube", std::move(file));
    Texture texture;
    texture.source = SourceKind::File;
    texture.file = "cube";
    TexturePreview preview;
    const unsigned name = preview.show(texture, images);
    ASSERT_NE(name, 0U);
    EXPECT_EQ(preview.show(texture, images), name);
    glBindTexture(GL_TEXTURE_2D, name);
    std::array<unsigned char, 12> shown{};
    GLint width = 0;
    glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &width);
    ASSERT_EQ(width, 4);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RED, GL_UNSIGNED_BYTE, shown.data());
    // Bottom row first: -y, then -x +z +x -z, then +y.
    EXPECT_EQ(shown, (std::array<unsigned char, 12>{0, 43, 0, 0, 41, 44, 40, 45, 0, 42, 0, 0}));
}

TEST(TexturePreview, LeavesTexelsOutOfALargeImage) {
    const auto context = offscreen::Context::create({4, 4}).value();
    ASSERT_TRUE(loadCapabilities().has_value());
    Image image = Image::uninitialised(PixelFormat::Luminance8, 2 * view::PreviewPicture::maxTexels + 1, 5);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x)
            image.at(x, y)[0] = static_cast<std::byte>(x % 50 + 51 * y);
    }
    ImageSource images;
    images.put("wide", std::move(image));
    Texture texture;
    texture.source = SourceKind::File;
    texture.file = "wide";
    TexturePreview preview;
    const unsigned name = preview.show(texture, images);
    ASSERT_NE(name, 0U);
    EXPECT_EQ(preview.show(texture, images), name);
    glBindTexture(GL_TEXTURE_2D, name);
    std::array<GLint, 2> size{};
    glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &size[0]);
    glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_HEIGHT, &size[1]);
    ASSERT_EQ(size, (std::array<GLint, 2>{2731, 2})); // every third: 8193 / 3 and 5 / 3, rounded up
    std::vector<unsigned char> shown(std::size_t{2731} * 2);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RED, GL_UNSIGNED_BYTE, shown.data());
    for (std::size_t i = 0; i < shown.size(); ++i)
        ASSERT_EQ(shown[i], 3 * (i % 2731) % 50 + 153 * (i / 2731)) << i;
}

TEST(TexturePreview, ShowsNothingWhereTheImageIsNotLoaded) {
    const auto context = offscreen::Context::create({4, 4}).value();
    ASSERT_TRUE(loadCapabilities().has_value());
    Texture texture;
    texture.source = SourceKind::File;
    texture.file = "gone.bmp";
    TexturePreview preview;
    EXPECT_EQ(preview.show(texture, ImageSource{}), 0U);
}

} // namespace
} // namespace texplorer::render::texture_preview_test

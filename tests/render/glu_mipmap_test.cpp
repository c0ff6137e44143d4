// gluBuild2DMipmaps, the function that many courses teach, as an oracle for NpotPolicy::PowerOfTwo.

#include "app/render/gl_handle.h"
#include "tests/support/render_fixture.h"
#include "texplorer/image/mipmaps.h"

#include <GL/glu.h>
#include <gmock/gmock.h>

namespace texplorer::glu_mipmap_test {
namespace {

using namespace test;

struct SizeCase {
    const char* name;
    int width, height;
    int expectedWidth, expectedHeight;
};

class GluMipmaps : public RenderTest, public testing::WithParamInterface<SizeCase> {};

/// Neighbours differ little, as in a photograph, but every component goes its own way.
Image smoothPicture(int width, int height) {
    Image made = Image::uninitialised(PixelFormat::Rgba8, width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const std::array values{(x * 9 + y * 2) % 256, (y * 11) % 256, ((x ^ y) * 5) % 256,
                                    255 - x * 3 % 256};
            std::ranges::transform(values, made.at(x, y).begin(),
                                   [](int v) { return static_cast<std::byte>(v); });
        }
    return made;
}

Image levelOf(GLint level) {
    GLint width = 0;
    GLint height = 0;
    glGetTexLevelParameteriv(GL_TEXTURE_2D, level, GL_TEXTURE_WIDTH, &width);
    glGetTexLevelParameteriv(GL_TEXTURE_2D, level, GL_TEXTURE_HEIGHT, &height);
    Image image = Image::uninitialised(PixelFormat::Rgba8, width, height);
    glGetTexImage(GL_TEXTURE_2D, level, GL_RGBA, GL_UNSIGNED_BYTE, image.pixels.data());
    return image;
}

// GLU works in floats and cuts off where we round: 1 for the base, and 1 more for each of its levels, which
// are made of cut-off ones.
TEST_P(GluMipmaps, AreOurs) {
    const SizeCase& row = GetParam();
    const Image base = smoothPicture(row.width, row.height);
    const MipChain ours = buildMipChain(base, {.npot = NpotPolicy::PowerOfTwo});
    EXPECT_EQ(ours[0].width, row.expectedWidth);
    EXPECT_EQ(ours[0].height, row.expectedHeight);

    const render::TextureHandle texture = render::TextureHandle::create();
    glBindTexture(GL_TEXTURE_2D, texture.name());
    ASSERT_EQ(gluBuild2DMipmaps(GL_TEXTURE_2D, GL_RGBA8, row.width, row.height, GL_RGBA, GL_UNSIGNED_BYTE,
                                base.pixels.data()),
              0);
    for (std::size_t level = 0; level < ours.size(); ++level) {
        const Image theirs = levelOf(static_cast<GLint>(level));
        ASSERT_EQ(theirs.width, ours[level].width) << "level " << level;
        ASSERT_EQ(theirs.height, ours[level].height) << "level " << level;
        int worst = 0;
        for (std::size_t i = 0; i < theirs.pixels.size(); ++i)
            worst = std::max(worst, std::abs(std::to_integer<int>(theirs.pixels[i]) -
                                             std::to_integer<int>(ours[level].pixels[i])));
        EXPECT_LE(worst, 1 + static_cast<int>(level)) << "level " << level;
    }
    GLint beyond = -1;
    glGetTexLevelParameteriv(GL_TEXTURE_2D, static_cast<GLint>(ours.size()), GL_TEXTURE_WIDTH, &beyond);
    EXPECT_EQ(beyond, 0) << "GLU has made no more levels than we";
}

INSTANTIATE_TEST_SUITE_P(All, GluMipmaps,
                         testing::Values(SizeCase{"PowersOfTwo", 32, 16, 32, 16},
                                         SizeCase{"Down", 20, 9, 16, 8}, SizeCase{"Up", 24, 13, 32, 16},
                                         SizeCase{"Odd", 37, 23, 32, 16}, SizeCase{"Three", 3, 3, 4, 4},
                                         SizeCase{"UpAndDown", 100, 75, 128, 64}),
                         [](const auto& test) { return std::string(test.param.name); });

} // namespace
} // namespace texplorer::glu_mipmap_test

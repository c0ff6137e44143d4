// The texture matrix at a known time: section 2.11.2 of the OpenGL 2.1 specification. The texel that is
// fetched says where the coordinate went: in a texture of 8 x 8 texels, red is its column and green its row.

#include "tests/support/flat_scene.h"
#include "tests/support/render_fixture.h"

#include <gmock/gmock.h>

#include <vector>

namespace texplorer::texture_matrix_test {
namespace {

using namespace test;

constexpr int texels = 8;

struct Case {
    const char* name;
    std::vector<MatrixStep> steps;
    double time;
    glm::vec4 coordinate;
    int column;
    int row;
};

class TextureMatrix : public RenderTest, public testing::WithParamInterface<Case> {};

TEST_P(TextureMatrix, MovesTheCoordinateTo) {
    Image grid = Image::uninitialised(PixelFormat::Rgba8, texels, texels);
    for (int y = 0; y < texels; ++y) {
        for (int x = 0; x < texels; ++x) {
            const auto texel = grid.at(x, y);
            texel[0] = static_cast<std::byte>(x);
            texel[1] = static_cast<std::byte>(y);
            texel[2] = texel[3] = std::byte{255};
        }
    }
    images.put("image", std::move(grid));
    Scene scene = texturedScene();
    scene.passes[0].units[0].matrix = GetParam().steps;
    scene.models[0].texCoords[0] = quadCoords(GetParam().coordinate);
    const glm::vec4 found = onlyColor(scene, 8, GetParam().time) * 255.0F;
    EXPECT_EQ(found, glm::vec4(GetParam().column, GetParam().row, 255, 255));
}

constexpr glm::vec4 at(float column, float row) { // the centre of that texel
    return {(column + 0.5F) / texels, (row + 0.5F) / texels, 0, 1};
}

MatrixStep translate(glm::vec3 amount, glm::vec3 rate = {}) {
    return {.op = MatrixOp::Translate, .amount = amount, .rate = rate};
}
MatrixStep scale(glm::vec3 amount, glm::vec3 rate = {}) {
    return {.op = MatrixOp::Scale, .amount = amount, .rate = rate};
}
MatrixStep rotate(float angle, float angleRate = 0) {
    return {.op = MatrixOp::Rotate, .amount = {0, 0, 1}, .angle = angle, .angleRate = angleRate};
}

INSTANTIATE_TEST_SUITE_P(
    All, TextureMatrix,
    testing::Values(
        Case{"Identity", {}, 0, at(3, 5), 3, 5},
        Case{"Translate", {translate({0.25F, 0.5F, 0})}, 0, at(1, 2), 3, 6},
        // 0.25 + 0.125 a second for 3 seconds is 5 texels.
        Case{"TranslateWithRate", {translate({0.25F, 0, 0}, {0.125F, 0, 0})}, 3, at(1, 2), 6, 2},
        Case{"TranslateBeforeTimeZero", {translate({0, 0, 0}, {0, 0.125F, 0})}, -2, at(1, 2), 1, 0},
        // The centre of texel 1 lies at 1.5 texels; three times that is 4.5.
        Case{"Scale", {scale({3, 1, 1})}, 0, at(1, 2), 4, 2},
        Case{"ScaleWithRate", {scale({1, 1, 1}, {1, 0, 0})}, 2, at(1, 2), 4, 2},
        // A quarter turn takes (s, t) to (-t, s): column -3.5 + 8 = 4.5.
        Case{"Rotate", {rotate(90)}, 0, at(1, 3), 4, 1},
        Case{"RotateWithRate", {rotate(45, 22.5F)}, 2, at(1, 3), 4, 1},
        // The last step works first: 3 (1.5 + 1) = 7.5 texels, but 3 * 1.5 + 1 = 5.5.
        Case{"ScaleThenTranslate", {scale({3, 1, 1}), translate({0.125F, 0, 0})}, 0, at(1, 2), 7, 2},
        Case{"TranslateThenScale", {translate({0.125F, 0, 0}), scale({3, 1, 1})}, 0, at(1, 2), 5, 2},
        // About the middle: (s, t) = (1.5, 3.5) - (4, 4) = (-2.5, -0.5) turns to (0.5, -2.5), back to
        // (4.5, 1.5).
        Case{"RotateAboutTheMiddle",
             {translate({0.5F, 0.5F, 0}), rotate(90), translate({-0.5F, -0.5F, 0})},
             0,
             at(1, 3),
             4,
             1},
        // s / q and t / q.
        Case{"DividesByQ", {}, 0, at(3, 5) * 2.0F, 3, 5}),
    [](const auto& test) { return std::string(test.param.name); });

TEST_F(RenderTest, EveryUnitHasATextureMatrixOfItsOwn) {
    images.put("image", rgbaImage(2, 1, 1, {{100, 0, 0, 255}, {0, 100, 0, 255}}));
    Scene scene = texturedScene();
    scene.passes[0].units[1] = scene.passes[0].units[0];
    scene.passes[0].units[1].envMode = EnvMode::Add;
    scene.passes[0].units[1].matrix = {translate({0.5F, 0, 0})};
    const glm::vec4 coordinate{0.25F, 0.5F, 0, 1};
    scene.models[0].texCoords[0] = scene.models[0].texCoords[1] = quadCoords(coordinate);
    EXPECT_EQ(onlyColor(scene) * 255.0F, glm::vec4(100, 100, 0, 255));
}

} // namespace
} // namespace texplorer::texture_matrix_test

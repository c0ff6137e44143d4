// The texture matrix at a known time: section 2.11.2 of the OpenGL 2.1 specification. The texel that is
// fetched says where the coordinate went: in a texture of 8 x 8 texels, red is its column and green its row.

#include "tests/support/flat_scene.h"
#include "tests/support/render_fixture.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
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

/// A quad over each half of the picture, and a texture whose texel says its column, of 8.
class MatrixStacks : public RenderTest {
protected:
    Scene halves() {
        Image columns = Image::uninitialised(PixelFormat::Rgba8, texels, 1);
        for (int x = 0; x < texels; ++x) {
            const auto texel = columns.at(x, 0);
            std::ranges::fill(texel, std::byte{0});
            texel[0] = static_cast<std::byte>(x);
            texel[3] = std::byte{255};
        }
        images.put("image", std::move(columns));
        Scene scene = texturedScene();
        Model& left = scene.models[0];
        left.texCoords[0] = left.texCoords[1] = quadCoords(at(1, 0));
        left.scale.x = 0.5F;
        scene.models.push_back(left);
        scene.models[0].position.x = -0.5F;
        scene.models[1].position.x = 0.5F;
        scene.passes[0].depthTest = false;
        return scene;
    }

    /// The columns that the left and the right half show.
    std::array<int, 2> columnsOf(const Scene& scene) {
        const Image drawn = picture(scene, 8);
        return {std::to_integer<int>(drawn.at(1, 4)[0]), std::to_integer<int>(drawn.at(6, 4)[0])};
    }
};
using Columns = std::array<int, 2>;

TEST_F(MatrixStacks, HoldTheStepsOfAModelUntilItIsDrawn) {
    Scene scene = halves();
    EXPECT_EQ(columnsOf(scene), (Columns{1, 1}));
    scene.passes[0].units[0].matrix = {translate({0.25F, 0, 0})};
    scene.models[0].units[0].matrix = {translate({0.375F, 0, 0})};
    EXPECT_EQ(columnsOf(scene), (Columns{6, 3}));
    scene.models[0].pushMatrix = false;
    EXPECT_EQ(columnsOf(scene), (Columns{6, 6}));
    scene.models[1].units[0].matrix = {translate({0.125F, 0, 0})};
    EXPECT_EQ(columnsOf(scene), (Columns{6, 7}));
}

// Of a second unit that no model changes, Mesa 22.3 would forget the matrix.
TEST_F(MatrixStacks, LeaveOtherUnitsAlone) {
    Scene scene = halves();
    scene.passes[0].units[1] = scene.passes[0].units[0];
    scene.passes[0].units[1].envMode = EnvMode::Add;
    scene.passes[0].units[1].matrix = {translate({0.25F, 0, 0})};
    EXPECT_EQ(columnsOf(scene), (Columns{1 + 3, 1 + 3}));
    scene.models[1].units[0].matrix = {translate({0.5F, 0, 0})};
    EXPECT_EQ(columnsOf(scene), (Columns{1 + 3, 5 + 3}));
    std::swap(scene.models[0].units, scene.models[1].units);
    EXPECT_EQ(columnsOf(scene), (Columns{5 + 3, 1 + 3}));
}

TEST_F(MatrixStacks, GoFromPassToPass) {
    Scene scene = halves();
    scene.passes.resize(3, scene.passes[0]);
    for (Pass& pass : scene.passes) {
        pass.blend = true; // the columns are added
        pass.blendDst = BlendFactor::One;
    }
    scene.passes[0].units[0].matrix = {translate({0.125F, 0, 0})};
    scene.passes[1].units[0].matrix = {translate({0.25F, 0, 0})};
    scene.passes[1].units[0].matrixStart = MatrixStart::Push;
    scene.passes[2].units[0].matrixStart = MatrixStart::Keep;
    EXPECT_EQ(columnsOf(scene), (Columns{2 + 4 + 2, 2 + 4 + 2}));
    scene.passes[1].units[0].matrixStart = MatrixStart::Keep;
    EXPECT_EQ(columnsOf(scene), (Columns{2 + 4 + 4, 2 + 4 + 4}));
    scene.models[1].units[0].matrix = {translate({0.125F, 0, 0})};
    scene.models[1].pushMatrix = false; // once more in each pass
    EXPECT_EQ(columnsOf(scene), (Columns{2 + 5 + 6, 3 + 6 + 7}));
    EXPECT_EQ(columnsOf(scene), (Columns{2 + 5 + 6, 3 + 6 + 7})) << "a frame begins with the identity";
}

// With FlipMode::Matrix the texture is upside down, and the matrix begins with t -> 1 - t: neither what is
// left on the stack nor a loaded matrix may lose it, nor pass it on to a texture that is upright. Both show
// the same row.
TEST_F(MatrixStacks, KeepTheFlipOfATexture) {
    Scene scene = halves();
    Image rows = Image::uninitialised(PixelFormat::Rgba8, 1, texels);
    for (int y = 0; y < texels; ++y)
        std::ranges::fill(rows.at(0, y), static_cast<std::byte>(y));
    TextureImage upsideDown;
    upsideDown.fileTopFirst = true;
    upsideDown.surfaces = {rows};
    images.put("image", std::move(rows));
    images.put("upside down", std::move(upsideDown));
    scene.textures.push_back(scene.textures[0]);
    scene.textures[0].file = "upside down";
    scene.textures[0].flip = FlipMode::Matrix;
    for (Model& model : scene.models)
        model.texCoords[0] = quadCoords(at(0, 1));
    scene.passes.push_back(scene.passes[0]);
    scene.passes[0].units[0].matrix = {translate({0, 0.25F, 0})};
    Unit& unit = scene.passes[1].units[0];
    unit.matrixStart = MatrixStart::Keep;
    EXPECT_EQ(columnsOf(scene), (Columns{3, 3}));
    unit.texture = 1;
    EXPECT_EQ(columnsOf(scene), (Columns{3, 3}));
    scene.passes[0].units[0].texture = 1;
    unit.texture = 0;
    scene.models[1].units[0].matrix = {translate({0, 0.125F, 0})};
    EXPECT_EQ(columnsOf(scene), (Columns{3, 4}));
    MatrixStep load{.op = MatrixOp::Load};
    load.matrix[3].y = 0.5F;
    unit.matrix = {load};
    EXPECT_EQ(columnsOf(scene), (Columns{5, 6}));
}

} // namespace
} // namespace texplorer::texture_matrix_test

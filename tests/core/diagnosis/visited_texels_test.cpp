// How much an anisotropic filter reads, against the box of a square that covers the picture, worked out by
// hand; and every way in which q can run through 0.

#include "tests/support/flat_scene.h"
#include "texplorer/diagnosis/applied_texture.h"
#include "texplorer/diagnosis/visited_texels.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace texplorer::visited_texels_test {
namespace {

constexpr double much = 1e300;

reference::SampledTexture shapeOf64(Target target = Target::Texture2D) {
    reference::SampledTexture shape;
    shape.target = target;
    for (int level = 0; level <= 6; ++level) {
        for (int face = 0; face < facesOf(target); ++face)
            shape.levelToFill(level, face) = {64 >> level, 64 >> level, 1, 0, {}};
    }
    return shape;
}

double visited(const Scene& scene, int width = 160, int height = 120, double time = 0) {
    reference::SampledTexture shape = shapeOf64(scene.passes[0].units[0].target);
    reference::setParameters(shape, scene.textures[0], 1000);
    return visitedTexels(shape, {scene, 0, time, width, height}, much);
}

/// A square whose lower and upper corners have these values of q, without mipmaps.
Scene squareWith(float lower, float upper) {
    Scene scene = test::texturedScene();
    Texture& texture = scene.textures[0];
    texture.minFilter = MinFilter::Linear;
    texture.magFilter = MagFilter::Linear;
    texture.maxAnisotropy = 16;
    scene.models[0].texCoords[0] = test::quadCoords({0, 0, 0, 1}, {1, 1, 0, 1});
    for (glm::vec4& each : scene.models[0].texCoords[0].edit())
        each.q = each.t > 0 ? upper : lower;
    return scene;
}

TEST(VisitedTexels, AreThoseOfTheBoxAroundTheEllipse) {
    for (const float repeats : {1.0F, 10.0F, 100.0F}) {
        Scene scene = squareWith(1, 1);
        scene.models[0].texCoords[0] = test::quadCoords({0, 0, 0, 1}, {repeats, repeats, 0, 1});
        const double acrossPixel = repeats * 64 / 128;
        const double side = 2 * std::sqrt(acrossPixel * acrossPixel + 1) + 2;
        EXPECT_GE(visited(scene, 128, 128), 128 * 128 * side * side) << repeats;
        EXPECT_LT(visited(scene, 128, 128), 1.2 * 128 * 128 * side * side)
            << repeats; // blocks along the diagonal
    }
}

TEST(VisitedTexels, AreFewInTheLevelThatFits) {
    Scene scene = squareWith(1, 1);
    scene.textures[0].minFilter = MinFilter::LinearMipmapLinear;
    scene.models[0].texCoords[0] =
        test::quadCoords({0, 0, 0, 1}, {16, 16, 0, 1}); // 8 texels a pixel: level 3
    const double side = 2 * std::sqrt(2.0) + 2;
    EXPECT_GE(visited(scene, 128, 128), 128 * 128 * side * side);
    EXPECT_LT(visited(scene, 128, 128), 1.2 * 128 * 128 * side * side);
}

TEST(VisitedTexels, OfACubeMapAreAsManyAsAFaceHasAtMost) {
    Scene scene = squareWith(1, 1);
    scene.passes[0].units[0].target = Target::CubeMap;
    scene.models[0].texCoords[0] = test::quadCoords({-1, -1, -0.5F, 1}, {1, 1, 0.7F, 1});
    EXPECT_LT(visited(scene), 160.0 * 120 * 256 * 256);
    EXPECT_GT(visited(scene), 160.0 * 120);
}

// Beyond the edge of a triangle that is seen from its side 1 / w changes its sign, but q doesn't.
TEST(VisitedTexels, AreFewAtTheRimOfASphere) {
    Scene scene = defaultScene();
    scene.textures[0].maxAnisotropy = 16;
    for (int azimuth = 0; azimuth < 360; azimuth += 7) {
        scene.view.azimuth = static_cast<float>(azimuth);
        EXPECT_LT(visited(scene, 400, 300), 0x1p26) << azimuth;
    }
}

TEST(VisitedTexels, HaveNoEndWhereQRunsThroughZero) {
    EXPECT_TRUE(std::isfinite(visited(squareWith(1, 2))));
    EXPECT_TRUE(std::isfinite(visited(squareWith(-1, -2))));
    EXPECT_TRUE(std::isinf(visited(squareWith(-1, 1.03F)))); // within two rows of pixels
    EXPECT_TRUE(std::isinf(visited(squareWith(0, 0))));
    EXPECT_GT(visited(squareWith(1e-3F, 1)), 10 * visited(squareWith(0.5F, 1)));
}

TEST(VisitedTexels, HaveNoEndWhateverMakesQ) {
    const auto generated = [](TexGenMode mode) {
        Scene scene = squareWith(1, 1);
        TexGen& q = scene.passes[0].units[0].texGenQ;
        q.enabled = true;
        q.mode = mode;
        q.objectPlane = q.eyePlane = {1, 0, 0, 0}; // x, which is 0 in the middle
        return scene;
    };
    EXPECT_TRUE(std::isinf(visited(generated(TexGenMode::ObjectLinear))));
    EXPECT_TRUE(std::isinf(visited(generated(TexGenMode::EyeLinear))));

    Scene multiplied = squareWith(1, 1);
    MatrixStep step{.op = MatrixOp::Multiply};
    step.matrix[0].w = 2;
    step.matrix[3].w = -1; // q = 2 s - 1
    multiplied.passes[0].units[0].matrix = {step};
    EXPECT_TRUE(std::isinf(visited(multiplied)));
    step.op = MatrixOp::Load;
    multiplied.passes[0].units[0].matrix = {step};
    EXPECT_TRUE(std::isinf(visited(multiplied)));

    // The light stands in the middle of the square, and shines along it.
    Scene projected = generated(TexGenMode::EyeLinear);
    Unit& unit = projected.passes[0].units[0];
    const std::array coordinates{&unit.texGenS, &unit.texGenT, &unit.texGenR, &unit.texGenQ};
    for (std::size_t i = 0; i < coordinates.size(); ++i) {
        coordinates[i]->enabled = true;
        coordinates[i]->mode = TexGenMode::EyeLinear;
        coordinates[i]->eyePlane = glm::vec4(0);
        coordinates[i]->eyePlane[static_cast<int>(i)] = 1;
    }
    unit.matrix = {{.op = MatrixOp::Projector}};
    const float distance = projected.view.distance;
    projected.light.position = {0, 0, -distance, 1};
    projected.light.projector.target = {1, 0, -distance};
    EXPECT_TRUE(std::isinf(visited(projected)));
}

// q = s - 1.5 + time / 2
TEST(VisitedTexels, HaveNoEndWhenATurningMatrixMakesQ) {
    Scene scene = squareWith(1, 1);
    MatrixStep row{.op = MatrixOp::Multiply};
    row.matrix[0].w = 1;
    row.matrix[3].w = -1.5F;
    scene.passes[0].units[0].matrix = {
        row, {.op = MatrixOp::Translate, .amount = {0, 0, 0}, .rate = {0.5F, 0, 0}}};
    EXPECT_TRUE(std::isfinite(visited(scene)));
    EXPECT_TRUE(std::isinf(visited(scene, 160, 120, 2)));
}

} // namespace
} // namespace texplorer::visited_texels_test

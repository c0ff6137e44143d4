// The matrix stacks of section 2.11.2 of the OpenGL 2.1 specification, with matrices worked out by hand:
// T(x) is a translation along s, S(x) a scale of s, and the coordinate s = 1 shows the product.

#include "texplorer/scene/animation.h"
#include "texplorer/scene/texture_matrix.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace texplorer::texture_matrix_test {
namespace {

using testing::ElementsAre;

MatrixStep translate(float s) {
    return {.op = MatrixOp::Translate, .amount = {s, 0, 0}};
}
MatrixStep scale(float s) {
    return {.op = MatrixOp::Scale, .amount = {s, 1, 1}};
}
MatrixStep load(float s) {
    MatrixStep step{.op = MatrixOp::Load};
    step.matrix[3].x = s;
    return step;
}

/// Two models, and so many passes that draw both with unit 0.
Scene passesOfTwo(std::size_t passes) {
    Scene scene = defaultScene();
    const Pass pass = scene.passes[0];
    scene.passes.assign(passes, pass);
    return scene;
}

Unit& unitOf(Scene& scene, std::size_t pass) {
    return scene.passes[pass].units[0];
}

/// The result for s = 1, for each model of a pass.
std::vector<float> resultsOf(const Scene& scene, std::size_t pass, std::size_t unit = 0) {
    std::vector<float> results;
    for (std::size_t model = 0; model < scene.models.size(); ++model)
        results.push_back((textureMatrix(scene, pass, unit, model, 0) * glm::vec4(1, 0, 0, 1)).x);
    return results;
}

TEST(TextureMatrixStack, IsTheIdentityAtFirst) {
    for (const MatrixStart start : {MatrixStart::Identity, MatrixStart::Push, MatrixStart::Keep}) {
        Scene scene = passesOfTwo(1);
        unitOf(scene, 0).matrixStart = start;
        EXPECT_THAT(resultsOf(scene, 0), ElementsAre(1, 1));
        unitOf(scene, 0).matrix = {scale(3)};
        EXPECT_THAT(resultsOf(scene, 0), ElementsAre(3, 3));
    }
}

TEST(TextureMatrixStack, ModelsMultiplyAfterThePass) {
    Scene scene = passesOfTwo(1);
    unitOf(scene, 0).matrix = {translate(10)};
    scene.models[0].units[0].matrix = {scale(3), translate(1)};
    // T(10) S(3) T(1): 3 (1 + 1) + 10; glPopMatrix takes it from the other one.
    EXPECT_THAT(resultsOf(scene, 0), ElementsAre(16, 11));
    EXPECT_THAT(resultsOf(scene, 0, 1), ElementsAre(1, 1)) << "each unit has a stack of its own";
}

TEST(TextureMatrixStack, WithoutPopLaterModelsHaveTheStepsToo) {
    Scene scene = passesOfTwo(2);
    scene.models[0].units[0].matrix = {scale(3)};
    scene.models[0].pushMatrix = false;
    scene.models[1].units[0].matrix = {translate(1)};
    EXPECT_THAT(resultsOf(scene, 0), ElementsAre(3, 6)); // S(3) T(1)
    EXPECT_THAT(resultsOf(scene, 1), ElementsAre(3, 6)) << "glLoadIdentity begins with the identity";
    scene.passes[0].models = {1, 0}; // the order of drawing counts
    EXPECT_THAT(resultsOf(scene, 0), ElementsAre(3, 2));
    unitOf(scene, 1).matrixStart = MatrixStart::Keep;
    EXPECT_THAT(resultsOf(scene, 1), ElementsAre(9, 18)) << "S(3) is left by the pass before";
    scene.models[0].visible = false;
    EXPECT_THAT(resultsOf(scene, 1)[1], 2) << "what isn't drawn leaves nothing";
}

TEST(TextureMatrixStack, PassesStartWithWhatEarlierOnesLeft) {
    Scene scene = passesOfTwo(4);
    for (std::size_t p = 0; p < 4; ++p)
        unitOf(scene, p).matrix = {scale(2)};
    unitOf(scene, 1).matrixStart = MatrixStart::Push;
    unitOf(scene, 2).matrixStart = MatrixStart::Keep;
    unitOf(scene, 3).matrixStart = MatrixStart::Keep;
    EXPECT_THAT(resultsOf(scene, 0), ElementsAre(2, 2));
    EXPECT_THAT(resultsOf(scene, 1), ElementsAre(4, 4));
    EXPECT_THAT(resultsOf(scene, 2), ElementsAre(4, 4)) << "the pass before has popped its matrix";
    EXPECT_THAT(resultsOf(scene, 3), ElementsAre(8, 8));
    unitOf(scene, 3).matrix = {};
    EXPECT_THAT(resultsOf(scene, 3), ElementsAre(4, 4)) << "also without steps of its own";
    unitOf(scene, 2).enabled = false;
    EXPECT_THAT(resultsOf(scene, 3), ElementsAre(2, 2)) << "a unit that is off leaves its stack alone";
    scene.passes[0].enabled = false;
    EXPECT_THAT(resultsOf(scene, 3), ElementsAre(1, 1));
}

TEST(TextureMatrixStack, LoadReplacesAllThatIsThere) {
    Scene scene = passesOfTwo(2);
    unitOf(scene, 0).matrix = {scale(2)};
    unitOf(scene, 1).matrixStart = MatrixStart::Push;
    unitOf(scene, 1).matrix = {scale(5), load(7), translate(1)};
    EXPECT_THAT(resultsOf(scene, 1), ElementsAre(9, 9)); // 1 + 1 + 7
    EXPECT_EQ(textureSteps(scene, 1, 0, 0).size(), 2U) << "the steps before it do not count";
    scene.models[1].units[0].matrix = {load(100)};
    EXPECT_THAT(resultsOf(scene, 1), ElementsAre(9, 101));
}

TEST(TextureMatrixStack, SaysWhoseTheStepsAre) {
    Scene scene = passesOfTwo(2);
    unitOf(scene, 0).matrix = {scale(2), translate(1)};
    unitOf(scene, 1).matrixStart = MatrixStart::Keep;
    unitOf(scene, 1).matrix = {scale(3)};
    scene.models[0].units[0].matrix = {translate(4)};
    scene.models[0].pushMatrix = false;
    const std::vector<MatrixStep>& first = unitOf(scene, 0).matrix;
    const std::vector<MatrixStep>& own = scene.models[0].units[0].matrix;
    EXPECT_THAT(textureSteps(scene, 1, 0, 1),
                ElementsAre(PlacedStep{&first[0], 0, {}, 0}, PlacedStep{&first[1], 0, {}, 1},
                            PlacedStep{own.data(), 0, 0, 0},
                            PlacedStep{unitOf(scene, 1).matrix.data(), 1, {}, 0},
                            PlacedStep{own.data(), 1, 0, 0}));
    EXPECT_EQ(inheritedSteps(scene, 1, 0).size(), 3U);
    unitOf(scene, 1).matrixStart = MatrixStart::Identity;
    EXPECT_TRUE(inheritedSteps(scene, 1, 0).empty());
    EXPECT_EQ(leftSteps(scene, 1, 0).size(), 3U);
}

TEST(TextureMatrixStack, MovesWithWhatIsLeftOnIt) {
    Scene scene = passesOfTwo(2);
    scene.models[0].units[0].matrix = {{.op = MatrixOp::Translate, .rate = {0.5F, 0, 0}}};
    EXPECT_TRUE(isAnimated(scene));
    EXPECT_FLOAT_EQ(textureMatrix(scene, 0, 0, 0, 3)[3].x, 1.5F);
    scene.passes[0].models = {1};
    scene.passes[1].models = {1};
    EXPECT_FALSE(isAnimated(scene)) << "nothing draws the model";
    unitOf(scene, 0).matrix = scene.models[0].units[0].matrix;
    scene.passes[0].models = {0}; // which is hidden: the pass draws nothing, but multiplies
    scene.models[0].visible = false;
    EXPECT_FALSE(isAnimated(scene));
    unitOf(scene, 1).matrixStart = MatrixStart::Keep;
    EXPECT_TRUE(isAnimated(scene));
}

} // namespace
} // namespace texplorer::texture_matrix_test

#include "texplorer/reference/shading/coordinates.h"

#include <gtest/gtest.h>

#include <cmath>

namespace texplorer::reference::coordinates_test {
namespace {

const GenerationInputs nothing;

TEST(Coordinates, AreTurnedBeforeTheyAreGeneratedOrAfterTheMatrix) {
    Unit unit;
    const glm::vec4 given(0.25F, 0.25F, 0, 2);
    EXPECT_EQ(generatedCoordinates(unit, LateFlip::None, given, nothing), given);
    EXPECT_EQ(generatedCoordinates(unit, LateFlip::Matrix, given, nothing), given);
    EXPECT_EQ(generatedCoordinates(unit, LateFlip::Coordinates, given, nothing),
              glm::vec4(0.25F, 1.75F, 0, 2));
    unit.texGenT = {.enabled = true, .mode = TexGenMode::ObjectLinear, .objectPlane = {0, 0, 0, 0.75F}};
    EXPECT_EQ(generatedCoordinates(unit, LateFlip::Coordinates, given, nothing),
              glm::vec4(0.25F, 0.75F, 0, 2))
        << "what is generated isn't turned";
}

// OpenGL 2.1, section 2.11.2: translate, then scale multiplies as T S, so that S counts first.
TEST(Coordinates, AreMultipliedByAllSteps) {
    Scene scene = defaultScene();
    scene.passes[0].units[0].matrix = {
        {.op = MatrixOp::Translate, .amount = {0.5F, 0, 0}, .rate = {0.25F, 0, 0}}};
    scene.models[1].units[0].matrix = {{.op = MatrixOp::Scale, .amount = {2, 2, 1}}};
    const glm::vec4 corner(1, 1, 0, 1);
    EXPECT_EQ(coordinateMatrix(scene, 0, 0, 1, LateFlip::None, 2) * corner, glm::vec4(3, 2, 0, 1));
    EXPECT_EQ(coordinateMatrix(scene, 0, 0, 1, LateFlip::Matrix, 2) * corner, glm::vec4(3, -1, 0, 1));
    EXPECT_EQ(coordinateMatrices(scene, 0, 0, LateFlip::None, 2)[0] * corner, glm::vec4(2, 1, 0, 1));
    EXPECT_EQ(upsideDown() * glm::vec4(3, -1, 0, 1), glm::vec4(3, 2, 0, 1)) << "its own inverse";
}

// Section 2.11.3: a normal stays at right angles to its surface, whatever the scale, and of unit length.
TEST(Coordinates, InEyeSpaceNormalsFollowTheSurface) {
    const glm::mat4 modelview{{2, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, -5, 1}};
    // A plane x = y; its normal (1, -1, 0) becomes (1/2, -1, 0).
    const GenerationInputs inputs =
        EyeSpace(modelview)(Vertex{{1, 1, 0}, glm::vec3(1, -1, 0) / std::sqrt(2.0F), {0, 0, 0, 1}});
    EXPECT_EQ(inputs.object, glm::vec4(1, 1, 0, 1));
    EXPECT_EQ(inputs.eye, glm::vec4(2, 1, -5, 1));
    EXPECT_NEAR(inputs.normal.x, 1 / std::sqrt(5.0F), 1e-6F);
    EXPECT_NEAR(inputs.normal.y, -2 / std::sqrt(5.0F), 1e-6F);
}

} // namespace
} // namespace texplorer::reference::coordinates_test

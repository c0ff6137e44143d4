#include "texplorer/scene/picking.h"

#include <gtest/gtest.h>

#include <cmath>

namespace texplorer::picking_test {
namespace {

/// The camera stands at (0, 0, 5), looks along -z and sees as far up as it is away: a point at height y and
/// depth z appears at y / (5 - z) of half the picture.
Scene sceneWith(std::vector<Model> models) {
    Scene scene;
    scene.view.distance = 5;
    scene.view.fieldOfView = 90;
    scene.models = std::move(models);
    return scene;
}

/// The vertex of a mesh at a position with a normal.
std::size_t vertexAt(Shape shape, glm::vec3 position, glm::vec3 normal) {
    const Mesh mesh = makeMesh({shape});
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
        if (mesh.vertices[i].position == position && mesh.vertices[i].normal == normal)
            return i;
    ADD_FAILURE() << "no such vertex";
    return 0;
}

const std::size_t frontUpperRight = vertexAt(Shape::Cube, {1, 1, 1}, {0, 0, 1});
const std::size_t backUpperRight = vertexAt(Shape::Cube, {1, 1, -1}, {0, 0, -1});
const std::size_t topUpperRight = vertexAt(Shape::Cube, {1, 1, 1}, {0, 1, 0});
const std::size_t rightUpperRight = vertexAt(Shape::Cube, {1, 1, 1}, {1, 0, 0});

// The front corner (1, 1, 1) is 4 away: 1/4 of half the picture, so 0.625 from the left and 0.375 from the
// top.
constexpr glm::vec2 frontCorner{0.625F, 0.375F};

void expectNear(const std::optional<glm::vec2>& found, glm::vec2 expected) {
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->x, expected.x, 1e-6F);
    EXPECT_NEAR(found->y, expected.y, 1e-6F);
}

TEST(ProjectVertex, GivesFractionsFromTheTopLeft) {
    const Scene scene = sceneWith({Model{}});
    expectNear(projectVertex(scene, 0, frontUpperRight, 0, 1), frontCorner);
    // 6 away
    expectNear(projectVertex(scene, 0, backUpperRight, 0, 1), {0.5F + 1.0F / 12, 0.5F - 1.0F / 12});
    // A picture of twice the width shows the same height and twice as much to the sides.
    expectNear(projectVertex(scene, 0, frontUpperRight, 0, 2), {0.5625F, 0.375F});
}

TEST(ProjectVertex, FollowsTheModelInTime) {
    Model model;
    model.spin = {0, 0, 45};
    // After two seconds (1, 1, 1) is at (-1, 1, 1).
    expectNear(projectVertex(sceneWith({model}), 0, frontUpperRight, 2, 1), {0.375F, 0.375F});
}

TEST(ProjectVertex, GivesNothingBehindTheCameraAndForWhatDoesNotExist) {
    Model behind;
    behind.position = {0, 0, 10};
    const Scene scene = sceneWith({behind});
    EXPECT_FALSE(projectVertex(scene, 0, frontUpperRight, 0, 1));
    EXPECT_FALSE(projectVertex(scene, 0, 24, 0, 1));
    EXPECT_FALSE(projectVertex(scene, 1, 0, 0, 1));
}

struct Pick {
    const char* name;
    Scene scene;
    glm::vec2 point;
    std::optional<PickedVertex> expected;
};

class PickVertex : public testing::TestWithParam<Pick> {};

TEST_P(PickVertex, FindsWhatOneSees) {
    const auto picked = pickVertex(GetParam().scene, 0, 1, GetParam().point);
    ASSERT_EQ(picked.has_value(), GetParam().expected.has_value());
    if (picked) {
        EXPECT_EQ(picked->model, GetParam().expected->model);
        EXPECT_EQ(picked->vertex, GetParam().expected->vertex);
    }
}

Scene orbited(float azimuth, float elevation) {
    Scene scene = sceneWith({Model{}});
    scene.view.azimuth = azimuth;
    scene.view.elevation = elevation;
    return scene;
}

glm::vec2 cornerOf(const Scene& scene) {
    return projectVertex(scene, 0, frontUpperRight, 0, 1).value();
}

Scene hidden(Shape inFront) {
    Scene scene = sceneWith({Model{}, Model{.shape = inFront}});
    // On the line from the corner (1, 1, 1) to the eye (0, 0, 5), half-way.
    scene.models[1].position = {0.5F, 0.5F, 3};
    scene.models[1].size = 0.2F;
    return scene;
}

Scene invisible() {
    Scene scene = sceneWith({Model{}});
    scene.models[0].visible = false;
    return scene;
}

Scene orthographic(Scene scene) {
    scene.view.projection = Projection::Orthographic;
    return scene;
}

Scene quadFromBehind() {
    Scene scene = sceneWith({Model{.shape = Shape::Quad}});
    scene.view.azimuth = 180;
    return scene;
}

INSTANTIATE_TEST_SUITE_P(
    Points, PickVertex,
    testing::Values(
        Pick{"Exactly", sceneWith({Model{}}), frontCorner, PickedVertex{0, frontUpperRight}},
        Pick{"NearBy", sceneWith({Model{}}), frontCorner + glm::vec2(0.02F, -0.02F),
             PickedVertex{0, frontUpperRight}},
        Pick{"TooFar", sceneWith({Model{}}), frontCorner + glm::vec2(0.025F, -0.025F), std::nullopt},
        Pick{"BackOfTheCube", sceneWith({Model{}}), {0.5F + 1.0F / 12, 0.5F - 1.0F / 12}, std::nullopt},
        Pick{"Nowhere", sceneWith({Model{}}), {0.05F, 0.05F}, std::nullopt},
        Pick{"NoNumber", sceneWith({Model{}}), {NAN, 0.5F}, std::nullopt},
        Pick{"NoModels", sceneWith({}), {0.5F, 0.5F}, std::nullopt},
        Pick{"Invisible", invisible(), frontCorner, std::nullopt},
        // At the corner three vertices coincide; the face that looks most towards the viewer wins.
        Pick{"CornerFromTheFront", orbited(20, 20), cornerOf(orbited(20, 20)),
             PickedVertex{0, frontUpperRight}},
        Pick{"CornerFromTheRight", orbited(70, 20), cornerOf(orbited(70, 20)),
             PickedVertex{0, rightUpperRight}},
        Pick{"CornerFromAbove", orbited(45, 70), cornerOf(orbited(45, 70)), PickedVertex{0, topUpperRight}},
        Pick{"BehindAnotherModel", hidden(Shape::Cube), frontCorner, std::nullopt},
        Pick{"BehindASquare", hidden(Shape::Quad), frontCorner, std::nullopt},
        // In parallel the corner is at 1/5 of half the picture, and what was in the way no longer is.
        Pick{"Orthographic",
             orthographic(hidden(Shape::Cube)),
             {0.6F, 0.4F},
             PickedVertex{0, frontUpperRight}},
        Pick{"AQuadHasTwoSides",
             quadFromBehind(),
             {0.4F, 0.4F},
             PickedVertex{0, vertexAt(Shape::Quad, {1, 1, 0}, {0, 0, 1})}}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(PickSphere, FindsTheVertexAtTheMiddleAndNotTheOneBehindIt) {
    Scene scene = sceneWith({Model{.shape = Shape::Sphere}});
    const auto picked = pickVertex(scene, 0, 1, {0.5F, 0.5F});
    ASSERT_TRUE(picked);
    const Mesh mesh = makeMesh({Shape::Sphere, 32, 16});
    EXPECT_NEAR(mesh.vertices[picked->vertex].position.z, 1, 1e-6F);
}

} // namespace
} // namespace texplorer::picking_test

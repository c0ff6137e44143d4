// Numbers of NeHe's lesson 22, worked out by hand: a cube at (0, 0, z), turned by glRotate about x and then
// about y, under a light at (0, 0, 2) of the eye.

#include "texplorer/scene/emboss.h"
#include "texplorer/scene/model_mesh.h"
#include "texplorer/scene/tex_coords.h"

#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace texplorer::emboss_test {
namespace {

constexpr float far = -5;

testing::AssertionResult isNear(glm::vec4 found, glm::vec4 expected, float bound = 1e-5F) {
    for (int i = 0; i < 4; ++i) {
        if (!(std::abs(found[i] - expected[i]) <= bound))
            return testing::AssertionFailure()
                   << "found (" << found.x << ", " << found.y << ", " << found.z << ", " << found.w
                   << "), expected (" << expected.x << ", " << expected.y << ", " << expected.z << ", "
                   << expected.w << ")";
    }
    return testing::AssertionSuccess();
}
testing::AssertionResult isNear(glm::vec3 found, glm::vec3 expected) {
    return isNear(glm::vec4(found, 0), glm::vec4(expected, 0));
}

/// A face of the lesson's cube, and along which axes s and t grow on it.
struct CubeFace {
    const char* name;
    std::array<glm::vec2, 4> coords;
    std::array<glm::vec3, 4> places;
    glm::vec3 s;
    glm::vec3 t;
};

const std::array cubeFaces{
    CubeFace{"front",
             {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}},
             {{{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}},
             {1, 0, 0},
             {0, 1, 0}},
    CubeFace{"back",
             {{{1, 0}, {1, 1}, {0, 1}, {0, 0}}},
             {{{-1, -1, -1}, {-1, 1, -1}, {1, 1, -1}, {1, -1, -1}}},
             {-1, 0, 0},
             {0, 1, 0}},
    CubeFace{"top",
             {{{0, 1}, {0, 0}, {1, 0}, {1, 1}}},
             {{{-1, 1, -1}, {-1, 1, 1}, {1, 1, 1}, {1, 1, -1}}},
             {1, 0, 0},
             {0, 0, -1}},
    CubeFace{"bottom",
             {{{1, 1}, {0, 1}, {0, 0}, {1, 0}}},
             {{{-1, -1, -1}, {1, -1, -1}, {1, -1, 1}, {-1, -1, 1}}},
             {-1, 0, 0},
             {0, 0, -1}},
    CubeFace{"right",
             {{{1, 0}, {1, 1}, {0, 1}, {0, 0}}},
             {{{1, -1, -1}, {1, 1, -1}, {1, 1, 1}, {1, -1, 1}}},
             {0, 0, -1},
             {0, 1, 0}},
    CubeFace{"left",
             {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}},
             {{{-1, -1, -1}, {-1, -1, 1}, {-1, 1, 1}, {-1, 1, -1}}},
             {0, 0, 1},
             {0, 1, 0}},
};

/// The lesson's cube before the eye, as its program draws it.
Model lessonCube(float x, float y) {
    Model model;
    model.shape = Shape::Mesh;
    model.mesh.primitive = Primitive::Quads;
    for (const CubeFace& face : cubeFaces) {
        for (std::size_t i = 0; i < 4; ++i) {
            model.mesh.positions.push_back(face.places.at(i));
            model.mesh.texCoords.emplace_back(face.coords.at(i), 0, 1);
        }
    }
    model.attachment = Attachment::Eye;
    model.position = {0, 0, far};
    model.rotationOrder = RotationOrder::Xyz;
    model.rotation = {x, y, 0};
    return model;
}

Scene lessonScene(float x, float y) {
    Scene scene;
    scene.light.position = {0, 0, 2, 1};
    scene.models = {lessonCube(x, y)};
    return scene;
}

TEST(Tangents, AreThoseOfTheLessonsTable) {
    const Model cube = lessonCube(0, 0);
    const Mesh mesh = meshOf(cube);
    const std::vector<Tangents> tangents = tangentsOf(mesh, effectiveTexCoords(cube, mesh, 0));
    ASSERT_EQ(tangents.size(), 24U);
    for (std::size_t i = 0; i < 24; ++i) {
        const CubeFace& face = cubeFaces.at(i / 4);
        EXPECT_EQ(tangents[i].s, face.s) << face.name << " " << i % 4;
        EXPECT_EQ(tangents[i].t, face.t) << face.name << " " << i % 4;
    }
}

/// A square in the plane of x and y with these coordinates at (0, 0), (1, 0), (1, 1) and (0, 1).
std::vector<Tangents> ofASquare(const std::array<glm::vec2, 4>& coords) {
    MeshData data;
    data.primitive = Primitive::Quads;
    data.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    for (const glm::vec2& each : coords)
        data.texCoords.emplace_back(each, 0, 1);
    return tangentsOf(makeMesh(data), data.texCoords);
}

TEST(Tangents, FollowAnImageThatIsTurnedOrMirrored) {
    struct Case {
        const char* name;
        std::array<glm::vec2, 4> coords;
        glm::vec3 s;
        glm::vec3 t;
    };
    for (const auto& [name, coords, s, t] :
         {Case{"as it is", {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}, {1, 0, 0}, {0, 1, 0}},
          Case{"three times as often", {{{0, 0}, {3, 0}, {3, 3}, {0, 3}}}, {1, 0, 0}, {0, 1, 0}},
          Case{"mirrored", {{{1, 0}, {0, 0}, {0, 1}, {1, 1}}}, {-1, 0, 0}, {0, 1, 0}},
          Case{"upside down", {{{0, 1}, {1, 1}, {1, 0}, {0, 0}}}, {1, 0, 0}, {0, -1, 0}},
          Case{"a quarter turn", {{{0, 1}, {0, 0}, {1, 0}, {1, 1}}}, {0, 1, 0}, {-1, 0, 0}}}) {
        for (const Tangents& each : ofASquare(coords)) {
            EXPECT_TRUE(isNear(each.s, s)) << name;
            EXPECT_TRUE(isNear(each.t, t)) << name;
        }
    }
}

TEST(Tangents, AreNothingWhereTheImageHasNoExtent) {
    for (const Tangents& each : ofASquare({{{0, 0}, {1, 0}, {1, 0}, {0, 0}}})) {
        EXPECT_EQ(each.s, glm::vec3(0));
        EXPECT_EQ(each.t, glm::vec3(0));
    }
    MeshData points;
    points.primitive = Primitive::Lines;
    points.positions = {{0, 0, 0}, {1, 0, 0}};
    points.texCoords = {{0, 0, 0, 1}, {1, 1, 0, 1}};
    for (const Tangents& each : tangentsOf(makeMesh(points), points.texCoords))
        EXPECT_EQ(each.s, glm::vec3(0));
}

// Around the edge from (0, 0, 0) to (0, 1, 0): s grows along x on one side, along z on the other.
TEST(Tangents, AreTheMeanOfTheTrianglesAroundAVertex) {
    MeshData data;
    data.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}};
    data.texCoords = {{0, 0, 0, 1}, {1, 0, 0, 1}, {0, 1, 0, 1}, {-1, 0, 0, 1}};
    data.indices = {0, 1, 2, 0, 2, 3};
    const std::vector<Tangents> tangents = tangentsOf(makeMesh(data), data.texCoords);
    const float half = std::sqrt(0.5F);
    EXPECT_TRUE(isNear(tangents[0].s, {half, 0, half}));
    EXPECT_TRUE(isNear(tangents[1].s, {1, 0, 0}));
    EXPECT_TRUE(isNear(tangents[2].s, {half, 0, half}));
    EXPECT_TRUE(isNear(tangents[3].s, {0, 0, 1}));
    for (const Tangents& each : tangents)
        EXPECT_TRUE(isNear(each.t, {0, 1, 0}));
}

// The inverse of T(0, 0, z) Rx Ry is Ry(-y) Rx(-x) T(0, 0, -z):
// (2 - z) (-sin y cos x, sin x, cos x cos y). The lesson's routine multiplies the other way around and leaves
// the translation out: 2 (sin y, -sin x cos y, cos x cos y).
TEST(LightInModel, IsWhereEitherFormulaHasIt) {
    for (const glm::vec2 angles :
         {glm::vec2(0, 0), glm::vec2(30, 0), glm::vec2(0, 30), glm::vec2(30, 60), glm::vec2(-20, 250)}) {
        const Scene scene = lessonScene(angles.x, angles.y);
        const float x = glm::radians(angles.x);
        const float y = glm::radians(angles.y);
        const glm::vec3 correct =
            (2 - far) * glm::vec3(-std::sin(y) * std::cos(x), std::sin(x), std::cos(x) * std::cos(y));
        const glm::vec3 routine =
            2.0F * glm::vec3(std::sin(y), -std::sin(x) * std::cos(y), std::cos(x) * std::cos(y));
        EXPECT_TRUE(isNear(lightInModel(scene, scene.models[0], LightCarrier::Inverse, 0), {correct, 1}));
        EXPECT_TRUE(isNear(lightInModel(scene, scene.models[0], LightCarrier::Transpose, 0), {routine, 1}));
    }
}

TEST(LightInModel, OfADirectionIsADirection) {
    Scene scene = lessonScene(30, 60);
    scene.light.position = {0, 0, 2, 0};
    const float sine30 = 0.5F;
    const float cosine30 = 0.8660254F;
    EXPECT_TRUE(isNear(lightInModel(scene, scene.models[0], LightCarrier::Inverse, 0),
                       {-2 * cosine30 * cosine30, 2 * sine30, 2 * cosine30 * 0.5F, 0}));
    EXPECT_TRUE(isNear(lightInModel(scene, scene.models[0], LightCarrier::Transpose, 0),
                       {2 * cosine30, -2 * sine30 * 0.5F, 2 * cosine30 * 0.5F, 0}));
}

TEST(LightInModel, IsDividedByItsW) {
    Scene scene = lessonScene(0, 0);
    scene.light.position = {1, 0, 4, 2};
    EXPECT_TRUE(isNear(lightInModel(scene, scene.models[0], LightCarrier::Inverse, 0), {0.5F, 0, 7, 1}));
    EXPECT_TRUE(isNear(lightInModel(scene, scene.models[0], LightCarrier::Transpose, 0), {0.5F, 0, 2, 1}));
}

TEST(LightInModel, IsScaledWithTheModel) {
    Scene scene = lessonScene(0, 0);
    scene.light.position = {2, 0, 2, 1};
    scene.models[0].scale = {2, 1, 1};
    scene.models[0].size = 0.5F; // together 1, 0.5, 0.5
    EXPECT_TRUE(isNear(lightInModel(scene, scene.models[0], LightCarrier::Inverse, 0), {2, 0, 14, 1}));
    EXPECT_TRUE(isNear(lightInModel(scene, scene.models[0], LightCarrier::Transpose, 0), {2, 0, 4, 1}));
}

// The camera stands at (6, 0, 0), the light 2 behind it.
TEST(LightInModel, ComesOutOfTheCamera) {
    Scene scene = lessonScene(0, 0);
    scene.models[0] = Model{};
    scene.view.distance = 6;
    scene.view.azimuth = 90;
    EXPECT_TRUE(isNear(lightInModel(scene, scene.models[0], LightCarrier::Inverse, 0), {8, 0, 0, 1}));
    scene.models[0].position = {1, 2, 3};
    EXPECT_TRUE(isNear(lightInModel(scene, scene.models[0], LightCarrier::Inverse, 0), {7, -2, -3, 1}));
}

TEST(LightInModel, ChangesWithTime) {
    Scene scene = lessonScene(0, 0);
    scene.models[0].spin = {0, 15, 0};
    EXPECT_TRUE(isNear(lightInModel(scene, scene.models[0], LightCarrier::Transpose, 6), {2, 0, 0, 1}));
}

// From (0, 0, 1) to (3, 0, 5): (3, 0, 4) / 5.
TEST(EmbossOffset, IsHowFarTheLightStandsAside) {
    const Tangents axes{{1, 0, 0}, {0, 1, 0}};
    const Tangents turned{{0, 0, -1}, {0, 1, 0}};
    EXPECT_TRUE(isNear(glm::vec3(embossOffset({0, 0, 1}, axes, {3, 0, 5, 1}, 0.01F), 0), {0.006F, 0, 0}));
    EXPECT_TRUE(isNear(glm::vec3(embossOffset({0, 0, 1}, turned, {3, 0, 5, 1}, 0.01F), 0), {-0.008F, 0, 0}));
    EXPECT_TRUE(isNear(glm::vec3(embossOffset({0, 0, 1}, axes, {3, 0, 5, 1}, -0.5F), 0), {-0.3F, 0, 0}));
    // A direction is the same everywhere.
    for (const glm::vec3 place : {glm::vec3(0), glm::vec3(5, -7, 2)})
        EXPECT_TRUE(isNear(glm::vec3(embossOffset(place, axes, {0, 6, 8, 0}, 0.1F), 0), {0, 0.06F, 0}));
    // In the light itself there is none.
    EXPECT_EQ(embossOffset({1, 2, 3}, axes, {1, 2, 3, 1}, 0.01F), glm::vec2(0));
}

class GivenTexCoords : public testing::Test {
protected:
    GivenTexCoords() { scene.passes[0].units[1].emboss = {true, 0.01F, LightCarrier::Inverse}; }
    [[nodiscard]] TexCoords given(int unit) const {
        return givenTexCoords(scene, scene.passes[0], unit, scene.models[0], meshOf(scene.models[0]), 0);
    }
    Scene scene = lessonScene(0, 0);
};

TEST_F(GivenTexCoords, AreAsTheyWereWhereTheUnitDoesNotEmboss) {
    const Model& model = scene.models[0];
    EXPECT_EQ(given(0), effectiveTexCoords(model, meshOf(model), 0));
    scene.passes[0].units[1].emboss.enabled = false;
    EXPECT_EQ(given(1), effectiveTexCoords(model, meshOf(model), 1));
}

// The light is at (0, 0, 7) of the cube. From (-1, -1, 1) it is (1, 1, 6) away, sqrt(38) long; from the right
// face's (1, -1, -1), whose s goes along -z, (-1, 1, 8), sqrt(66) long.
TEST_F(GivenTexCoords, MoveTowardsTheLight) {
    const TexCoords coords = given(1);
    const float front = 0.01F / std::sqrt(38.0F);
    EXPECT_TRUE(isNear(coords[0], {front, front, 0, 1}, 1e-7F));
    EXPECT_TRUE(isNear(coords[1], {1 - front, front, 0, 1}, 1e-7F));
    EXPECT_TRUE(isNear(coords[2], {1 - front, 1 - front, 0, 1}, 1e-7F));
    EXPECT_TRUE(isNear(coords[3], {front, 1 - front, 0, 1}, 1e-7F));
    const float right = 0.01F / std::sqrt(66.0F);
    EXPECT_TRUE(isNear(coords[16], {1 - 8 * right, right, 0, 1}, 1e-7F));
}

// (s + q ds) / q = s / q + ds.
TEST_F(GivenTexCoords, MoveAsFarWhateverTheirQIs) {
    scene.models[0].texCoords[1] = given(0);
    scene.models[0].texCoords[1].edit()[0] *= 4.0F; // (0, 0, 0, 4)
    const float front = 0.01F / std::sqrt(38.0F);
    EXPECT_TRUE(isNear(given(1)[0], {4 * front, 4 * front, 0, 4}, 1e-7F));
}

// The unit's own list says along which axes they move.
TEST_F(GivenTexCoords, MoveAlongTheImageOfTheirUnit) {
    scene.light.position = {3, 0, 4, 0};
    scene.models[0].texCoords[1] = given(0);
    for (glm::vec4& each : scene.models[0].texCoords[1].edit())
        each.s = 1 - each.s;
    scene.passes[0].units[0].emboss = scene.passes[0].units[1].emboss;
    EXPECT_TRUE(isNear(given(0)[0], {0.006F, 0, 0, 1}, 1e-7F));
    EXPECT_TRUE(isNear(given(1)[0], {1 - 0.006F, 0, 0, 1}, 1e-7F));
}

} // namespace
} // namespace texplorer::emboss_test

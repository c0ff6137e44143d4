#include "texplorer/scene/mesh_edits.h"
#include "texplorer/scene/model_mesh.h"
#include "texplorer/scene/params/json.h"

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace texplorer::mesh_edits_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// A model whose vertex i is (i, 0, 0) and has i in all its lists.
Model numbered(int count, Primitive primitive, std::vector<int> indices = {}) {
    Model model{.shape = Shape::Mesh};
    model.mesh.primitive = primitive;
    model.mesh.indices = std::move(indices);
    for (int i = 0; i < count; ++i) {
        const auto number = static_cast<float>(i);
        model.mesh.positions.emplace_back(number, 0, 0);
        model.mesh.normals.emplace_back(0, number, 1);
        model.mesh.colors.emplace_back(number / 16, 0, 0, 1);
        model.mesh.texCoords.emplace_back(number, 1, 0, 1);
        model.texCoords[2].emplace_back(number, 2, 0, 1);
    }
    return model;
}

/// Which vertex each one was, as all lists say with one voice.
std::vector<int> originals(const Model& model) {
    std::vector<int> numbers;
    for (std::size_t i = 0; i < model.mesh.positions.size(); ++i) {
        const float number = model.mesh.positions[i].x;
        EXPECT_EQ(model.mesh.normals.read().at(i).y, number);
        EXPECT_EQ(model.mesh.colors.read().at(i).r * 16, number);
        EXPECT_EQ(model.mesh.texCoords.read().at(i).s, number);
        EXPECT_EQ(model.texCoords[2].read().at(i).s, number);
        numbers.push_back(static_cast<int>(number));
    }
    EXPECT_THAT(model.texCoords[0], IsEmpty());
    return numbers;
}

class Shapes : public testing::TestWithParam<Shape> {};

TEST_P(Shapes, TurnIntoAMeshThatDrawsTheSame) {
    Model model{.name = "it", .shape = GetParam(), .slices = 9, .stacks = 5};
    const Mesh before = meshOf(model);
    model.texCoords[1].assign(before.vertices.size(), glm::vec4(0.5F));
    ASSERT_TRUE(turnIntoMesh(model));
    const Mesh after = meshOf(model);
    EXPECT_EQ(after.triangles, before.triangles);
    ASSERT_EQ(after.vertices.size(), before.vertices.size());
    for (std::size_t i = 0; i < after.vertices.size(); ++i) {
        EXPECT_EQ(after.vertices[i].position, before.vertices[i].position);
        EXPECT_LT(glm::distance(after.vertices[i].normal, before.vertices[i].normal), 1e-6F);
        EXPECT_EQ(after.vertices[i].texCoord, before.vertices[i].texCoord);
    }
    EXPECT_FALSE(after.colored);
    EXPECT_EQ(model.texCoords[1].size(), before.vertices.size());
    Scene scene;
    scene.models = {model};
    EXPECT_EQ(parseScene(writeScene(scene)).value(), scene);
}

INSTANTIATE_TEST_SUITE_P(All, Shapes,
                         testing::Values(Shape::Cube, Shape::Sphere, Shape::Quad, Shape::Floor,
                                         Shape::Cylinder, Shape::Disk, Shape::PartialDisk, Shape::Torus,
                                         Shape::Teapot),
                         [](const auto& test) { return std::string(rowOf(test.param).name); });

TEST(MeshEdits, WhatConsistsOfQuadrilateralsNeedsNoIndices) {
    Model cube;
    ASSERT_TRUE(turnIntoMesh(cube));
    EXPECT_EQ(cube.mesh.primitive, Primitive::Quads);
    EXPECT_THAT(cube.mesh.indices, IsEmpty());
    EXPECT_EQ(cube.mesh.positions.size(), 24U);
    Model sphere{.shape = Shape::Sphere, .slices = 4, .stacks = 3};
    ASSERT_TRUE(turnIntoMesh(sphere));
    EXPECT_EQ(sphere.mesh.primitive, Primitive::Triangles);
    EXPECT_EQ(sphere.mesh.indices.size(), 3U * 4 * 4); // 8 at the poles, 2 * 4 between
}

TEST(MeshEdits, WhatIsTooLargeForAMeshStaysAsItIs) {
    Model sphere{.shape = Shape::Sphere, .slices = 256, .stacks = 256};
    const Model before = sphere;
    const Result<void> refused = turnIntoMesh(sphere);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().message, "the sphere has 66049 vertices, a mesh has at most 65536");
    EXPECT_EQ(sphere, before);

    Model fine{.shape = Shape::Sphere, .slices = 256, .stacks = 200};
    const Result<void> manyTriangles = turnIntoMesh(fine);
    ASSERT_FALSE(manyTriangles);
    EXPECT_EQ(manyTriangles.error().message,
              "the triangles of the sphere have 305664 corners, a mesh has at most 262144 indices");
    EXPECT_EQ(fine.shape, Shape::Sphere);

    Model mesh{.shape = Shape::Mesh};
    EXPECT_EQ(turnIntoMesh(mesh).error().message, "it already is a mesh");
}

TEST(MeshEdits, ACornerMovesWithItsOtherVerticesOrAlone) {
    Model cube;
    ASSERT_TRUE(turnIntoMesh(cube));
    const auto countAt = [&](glm::vec3 place) { return std::ranges::count(cube.mesh.positions, place); };
    const auto corner = std::ranges::find(cube.mesh.positions, glm::vec3(1)) - cube.mesh.positions.begin();
    setPosition(cube.mesh, static_cast<std::size_t>(corner), {2, 2, 2}, true);
    EXPECT_EQ(countAt(glm::vec3(2)), 3);
    EXPECT_EQ(countAt(glm::vec3(1)), 0);
    setPosition(cube.mesh, static_cast<std::size_t>(corner), {3, 2, 2}, false);
    EXPECT_EQ(countAt(glm::vec3(2)), 2);
    EXPECT_EQ(countAt(glm::vec3(3, 2, 2)), 1);
}

TEST(MeshEdits, FirstNormalAndColourGiveTheOthersWhatTheyHad) {
    MeshData mesh{.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
    EXPECT_EQ(givenNormal(mesh, 1), glm::vec3(0, 0, 1));
    setNormal(mesh, 1, {1, 0, 0});
    EXPECT_THAT(mesh.normals, ElementsAre(glm::vec3(0, 0, 1), glm::vec3(1, 0, 0), glm::vec3(0, 0, 1)));
    EXPECT_EQ(givenNormal(mesh, 1), glm::vec3(1, 0, 0));
    setColor(mesh, 0, {1, 0, 0, 1}, {0.5F, 0.5F, 0.5F, 1});
    EXPECT_THAT(mesh.colors, ElementsAre(glm::vec4(1, 0, 0, 1), glm::vec4(0.5F, 0.5F, 0.5F, 1),
                                         glm::vec4(0.5F, 0.5F, 0.5F, 1)));
}

TEST(MeshEdits, AnAppendedVertexComesLast) {
    Model plain = numbered(3, Primitive::LineStrip);
    EXPECT_TRUE(appendVertex(plain, 1));
    EXPECT_THAT(originals(plain), ElementsAre(0, 1, 2, 1));
    EXPECT_THAT(plain.mesh.indices, IsEmpty());
    Model indexed = numbered(3, Primitive::LineStrip, {2, 0});
    EXPECT_TRUE(appendVertex(indexed, 0));
    EXPECT_THAT(originals(indexed), ElementsAre(0, 1, 2, 0));
    EXPECT_THAT(indexed.mesh.indices, ElementsAre(2, 0, 3));
    Model none{.shape = Shape::Mesh};
    none.texCoords[0].resize(24); // of the cube that it was
    EXPECT_TRUE(appendVertex(none, 0));
    EXPECT_THAT(none.mesh.positions, ElementsAre(glm::vec3(0)));
    EXPECT_THAT(none.texCoords[0], IsEmpty());
}

TEST(MeshEdits, ADuplicateIsDrawnAfterItsLikeness) {
    Model plain = numbered(3, Primitive::LineStrip);
    EXPECT_TRUE(duplicateVertex(plain, 1));
    EXPECT_THAT(originals(plain), ElementsAre(0, 1, 1, 2));
    Model indexed = numbered(4, Primitive::LineStrip, {3, 1, 0, 1, 2});
    EXPECT_TRUE(duplicateVertex(indexed, 1));
    EXPECT_THAT(originals(indexed), ElementsAre(0, 1, 1, 2, 3));
    EXPECT_THAT(indexed.mesh.indices, ElementsAre(4, 1, 2, 0, 1, 3));
    Model unused = numbered(3, Primitive::LineStrip, {0, 2});
    EXPECT_TRUE(duplicateVertex(unused, 1));
    EXPECT_THAT(unused.mesh.indices, ElementsAre(0, 3));
}

TEST(MeshEdits, ThereIsRoomForSoManyVertices) {
    Model full{.shape = Shape::Mesh};
    full.mesh.positions.resize(maxMeshVertices);
    EXPECT_FALSE(appendVertex(full, 0));
    EXPECT_FALSE(duplicateVertex(full, 0));
    EXPECT_EQ(full.mesh.positions.size(), maxMeshVertices);
    Model busy{.shape = Shape::Mesh};
    busy.mesh.positions.resize(1);
    busy.mesh.indices.resize(maxMeshIndices);
    EXPECT_FALSE(appendVertex(busy, 0));
    EXPECT_EQ(busy.mesh.indices.size(), maxMeshIndices);
}

TEST(MeshEdits, ARemovedVertexTakesItsPartsAlong) {
    Model plain = numbered(4, Primitive::Polygon);
    removeVertex(plain, 1);
    EXPECT_THAT(originals(plain), ElementsAre(0, 2, 3));
    Model triangles = numbered(5, Primitive::Triangles, {0, 1, 2, 2, 3, 4, 4, 3, 0});
    removeVertex(triangles, 1);
    EXPECT_THAT(originals(triangles), ElementsAre(0, 2, 3, 4));
    EXPECT_THAT(triangles.mesh.indices, ElementsAre(1, 2, 3, 3, 2, 0));
    Model quads = numbered(5, Primitive::Quads, {0, 1, 2, 3, 4});
    removeVertex(quads, 4); // which completed no part
    EXPECT_THAT(quads.mesh.indices, ElementsAre(0, 1, 2, 3));
    Model strip = numbered(4, Primitive::TriangleStrip, {0, 1, 2, 3, 1});
    removeVertex(strip, 1);
    EXPECT_THAT(strip.mesh.indices, ElementsAre(0, 1, 2));
    Model last = numbered(1, Primitive::Points, {0, 0});
    removeVertex(last, 0);
    EXPECT_THAT(originals(last), IsEmpty());
    EXPECT_THAT(last.mesh.indices, IsEmpty());
}

TEST(MeshEdits, VerticesWithoutGlTexCoordKeepTheirNumbers) {
    Model model = numbered(5, Primitive::Points);
    model.noTexCoord[0] = {1, 3};
    model.noTexCoord[3] = {4, 2, 5}; // 5 is none
    removeVertex(model, 2);
    EXPECT_THAT(model.noTexCoord[0], ElementsAre(1, 2));
    EXPECT_THAT(model.noTexCoord[3], ElementsAre(3));
    removeVertex(model, 1);
    EXPECT_THAT(model.noTexCoord[0], ElementsAre(1));
    EXPECT_TRUE(duplicateVertex(model, 1)); // the duplicate has none either
    EXPECT_THAT(model.noTexCoord[0], ElementsAre(1, 2));
    EXPECT_THAT(model.noTexCoord[3], ElementsAre(3));
    EXPECT_TRUE(duplicateVertex(model, 0));
    EXPECT_THAT(model.noTexCoord[0], ElementsAre(2, 3));
    EXPECT_TRUE(appendVertex(model, 2));
    EXPECT_THAT(model.noTexCoord[0], ElementsAre(2, 3, 5));
    Model none{.shape = Shape::Mesh};
    none.noTexCoord[0] = {0}; // of the cube that it was
    EXPECT_TRUE(appendVertex(none, 0));
    EXPECT_THAT(none.noTexCoord[0], IsEmpty());
}

TEST(MeshEdits, ListsThatDoNotFitAreDroppedRatherThanMadeToFit) {
    Model model = numbered(3, Primitive::Triangles);
    model.mesh.normals.resize(2);
    model.texCoords[3].resize(4);
    model.texCoords[1].resize(2);
    removeVertex(model, 0);
    EXPECT_EQ(model.mesh.positions.size(), 2U);
    EXPECT_THAT(model.mesh.normals, IsEmpty());
    EXPECT_THAT(model.texCoords[1], IsEmpty());
    EXPECT_THAT(model.texCoords[3], IsEmpty());
    EXPECT_EQ(model.texCoords[2].size(), 2U);
}

} // namespace
} // namespace texplorer::mesh_edits_test

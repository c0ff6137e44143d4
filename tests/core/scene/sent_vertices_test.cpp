#include "texplorer/scene/model_mesh.h"
#include "texplorer/scene/sent_vertices.h"
#include "texplorer/scene/tex_coords.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace texplorer::sent_vertices_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using Source = std::optional<std::uint32_t>;

/// A mesh whose vertex i is at (i, 0, 0) with the coordinates (i, 0, 0, 1).
Model numbered(int count, Primitive primitive, std::vector<int> indices = {}) {
    Model model{.shape = Shape::Mesh};
    model.mesh.primitive = primitive;
    model.mesh.indices = std::move(indices);
    for (int i = 0; i < count; ++i) {
        model.mesh.positions.emplace_back(static_cast<float>(i), 0, 0);
        model.mesh.texCoords.emplace_back(static_cast<float>(i), 0, 0, 1);
    }
    return model;
}

std::vector<Source> sourcesOf(const Model& model, std::size_t unit = 0) {
    std::vector<Source> sources;
    for (const SentVertex& each : sentVertices(model, meshOf(model)))
        sources.push_back(each.coordsOf[unit]);
    return sources;
}

std::vector<std::uint32_t> orderOf(const Model& model) {
    std::vector<std::uint32_t> order;
    for (const SentVertex& each : sentVertices(model, meshOf(model)))
        order.push_back(each.vertex);
    return order;
}

TEST(SentVertices, OneWithoutGlTexCoordHasTheCoordinatesOfTheOneBeforeIt) {
    Model quad = numbered(4, Primitive::Quads);
    EXPECT_THAT(sourcesOf(quad), ElementsAre(0U, 1U, 2U, 3U));
    quad.noTexCoord[0] = {1, 3};
    EXPECT_THAT(sourcesOf(quad), ElementsAre(0U, 0U, 2U, 2U));
    quad.noTexCoord[0] = {2, 3, 1}; // in any order
    EXPECT_THAT(sourcesOf(quad), ElementsAre(0U, 0U, 0U, 0U));
    EXPECT_THAT(sourcesOf(quad, 1), ElementsAre(0U, 1U, 2U, 3U)); // each unit has its own
}

TEST(SentVertices, TheFirstOnesHaveWhatOpenGlStartsWith) {
    Model quad = numbered(4, Primitive::Quads);
    quad.noTexCoord[3] = {0, 1};
    EXPECT_THAT(sourcesOf(quad, 3), ElementsAre(std::nullopt, std::nullopt, 2U, 3U));
    const SentModel drawn(quad);
    EXPECT_THAT(effectiveTexCoords(*drawn, meshOf(*drawn), 3),
                ElementsAre(glm::vec4(0, 0, 0, 1), glm::vec4(0, 0, 0, 1), glm::vec4(2, 0, 0, 1),
                            glm::vec4(3, 0, 0, 1)));
}

TEST(SentVertices, OneThatIsSentTwiceCanHaveTwoCoordinates) {
    Model mesh = numbered(4, Primitive::Triangles, {0, 1, 2, 3, 2, 1});
    mesh.noTexCoord[0] = {2};
    EXPECT_THAT(orderOf(mesh), ElementsAre(0, 1, 2, 3, 2, 1));
    EXPECT_THAT(sourcesOf(mesh), ElementsAre(0U, 1U, 1U, 3U, 3U, 1U));
    EXPECT_EQ(firstWithoutCall(sentVertices(mesh, meshOf(mesh)), 0)->vertex, 2U);
    EXPECT_FALSE(firstWithoutCall(sentVertices(mesh, meshOf(mesh)), 1).has_value());
    EXPECT_THAT(coordSources(mesh, meshOf(mesh), 0), ElementsAre(0U, 1U, 1U, 3U)); // the first time

    const SentModel drawn(mesh);
    const Mesh made = meshOf(*drawn);
    EXPECT_THAT(made.triangles, ElementsAre(0, 1, 2, 3, 4, 5));
    std::vector<std::pair<float, float>> placesAndCoords;
    for (std::size_t i = 0; i < made.vertices.size(); ++i)
        placesAndCoords.emplace_back(made.vertices[i].position.x, drawn->mesh.texCoords.read().at(i).s);
    using P = std::pair<float, float>;
    EXPECT_THAT(placesAndCoords, ElementsAre(P(0, 0), P(1, 1), P(2, 1), P(3, 3), P(2, 3), P(1, 1)));

    EXPECT_EQ(drawn.vertexOf(4), 2U);
    EXPECT_EQ(drawn.coordsOf(4, 0), 3U);
    ASSERT_NE(drawn.givenMesh(), nullptr);
    EXPECT_EQ(drawn.givenMesh()->triangles, meshOf(mesh).triangles);
    EXPECT_EQ(drawn.vertexOf(5), 1U);
}

// 0 1 2, 1 3 2 … are drawn, but each vertex is sent once.
TEST(SentVertices, OfAStripAreSentOnce) {
    Model strip = numbered(5, Primitive::TriangleStrip);
    strip.noTexCoord[0] = {3, 4};
    EXPECT_THAT(sourcesOf(strip), ElementsAre(0U, 1U, 2U, 2U, 2U));
    EXPECT_EQ(meshOf(*SentModel(strip)).triangles, meshOf(strip).triangles);
}

// The cube is six GL_QUADS of four vertices; a sphere shares its vertices and is GL_TRIANGLES.
TEST(SentVertices, OfAShapeAreSquaresOrTriangles) {
    Model cube;
    EXPECT_EQ(sentPrimitive(cube), Primitive::Quads);
    cube.noTexCoord[0] = {4}; // the first of the second face
    const std::vector<Source> sources = sourcesOf(cube);
    ASSERT_EQ(sources.size(), 24U);
    EXPECT_EQ(sources[4], 3U);
    EXPECT_EQ(sources[5], 5U);
    const SentModel drawn(cube);
    EXPECT_EQ(drawn->mesh.primitive, Primitive::Quads);
    EXPECT_EQ(meshOf(*drawn).triangles, meshOf(cube).triangles);
    EXPECT_EQ(drawn->mesh.texCoords.read().at(4), meshOf(cube).vertices[3].texCoord);

    Model sphere{.shape = Shape::Sphere, .slices = 4, .stacks = 3};
    sphere.noTexCoord[0] = {0};
    EXPECT_EQ(sentPrimitive(sphere), Primitive::Triangles);
    EXPECT_EQ(orderOf(sphere), meshOf(sphere).triangles);
    const SentModel round(sphere);
    const Mesh made = meshOf(*round);
    const Mesh mesh = meshOf(sphere);
    ASSERT_EQ(made.triangles.size(), mesh.triangles.size());
    for (std::size_t i = 0; i < made.triangles.size(); ++i)
        EXPECT_EQ(made.vertices[made.triangles[i]].position, mesh.vertices[mesh.triangles[i]].position);
}

TEST(SentVertices, NormalsAndColoursStayWithTheirVertex) {
    Model mesh = numbered(3, Primitive::Triangles, {2, 0, 1});
    mesh.mesh.normals = {{1, 0, 0}, {0, 2, 0}, {0, 0, 3}};
    mesh.mesh.colors = {{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}};
    mesh.noTexCoord[2] = {0};
    const SentModel drawn(mesh);
    EXPECT_THAT(drawn->mesh.normals, ElementsAre(glm::vec3(0, 0, 3), glm::vec3(1, 0, 0), glm::vec3(0, 2, 0)));
    EXPECT_THAT(drawn->mesh.colors,
                ElementsAre(glm::vec4(0, 0, 1, 1), glm::vec4(1, 0, 0, 1), glm::vec4(0, 1, 0, 1)));
}

TEST(SentVertices, AModelThatLeavesOutNothingIsDrawnAsItIs) {
    Model cube;
    EXPECT_EQ(&*SentModel(cube), &cube);
    cube.noTexCoord[0] = {24, -1}; // the vertices are 0 to 23
    EXPECT_FALSE(leavesOutCalls(cube));
    EXPECT_EQ(&*SentModel(cube), &cube);
    EXPECT_EQ(SentModel(cube).givenMesh(), nullptr);
    EXPECT_EQ(SentModel(cube).coordsOf(7, 0), 7U);
    cube.noTexCoord[1] = {23};
    EXPECT_TRUE(leavesOutCalls(cube));
    EXPECT_NE(&*SentModel(cube), &cube);
    EXPECT_THAT(SentModel(cube)->noTexCoord[1], IsEmpty());
}

TEST(SentVertices, CallsAreLeftOutAndSentAgain) {
    Model cube;
    setLeftOut(cube, 1, 7, true);
    setLeftOut(cube, 1, 3, true);
    setLeftOut(cube, 1, 7, true);
    EXPECT_THAT(cube.noTexCoord[1], ElementsAre(3, 7));
    setLeftOut(cube, 1, 3, false);
    EXPECT_THAT(cube.noTexCoord[1], ElementsAre(7));
    EXPECT_THAT(cube.noTexCoord[0], IsEmpty());
}

} // namespace
} // namespace texplorer::sent_vertices_test

#include "texplorer/mesh/mesh_data.h"

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace texplorer::mesh_data_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using Indices = std::vector<std::uint32_t>;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

MeshData dataOf(Primitive primitive, int count) {
    MeshData data{.primitive = primitive};
    for (int i = 0; i < count; ++i)
        data.positions.emplace_back(i, i * i, 0);
    return data;
}

/// What the parts are made of: section 2.6.1. The last vertex of each is the one of table 2.12.
struct Case {
    const char* name;
    Primitive primitive;
    int count;
    Indices triangles;
    Indices lines;
    Indices points;
    std::vector<std::string> faces;
};

class Primitives : public testing::TestWithParam<Case> {};

std::vector<std::string> faceNames(const Mesh& mesh) {
    std::vector<std::string> names;
    for (const Face& face : mesh.faces)
        names.push_back(face.name);
    return names;
}

TEST_P(Primitives, AreAssembledAsOpenGlDoes) {
    const Mesh mesh = makeMesh(dataOf(GetParam().primitive, GetParam().count));
    EXPECT_EQ(mesh.vertices.size(), static_cast<std::size_t>(GetParam().count));
    EXPECT_EQ(mesh.triangles, GetParam().triangles);
    EXPECT_EQ(mesh.lines, GetParam().lines);
    EXPECT_EQ(mesh.points, GetParam().points);
    EXPECT_EQ(faceNames(mesh), GetParam().faces);
}

// Indices say the order: here the same one, of vertices that lie the other way around.
TEST_P(Primitives, AreAssembledInTheOrderOfTheIndices) {
    MeshData data = dataOf(GetParam().primitive, GetParam().count);
    for (int i = GetParam().count; i-- > 0;)
        data.indices.push_back(i);
    const auto turned = [&](Indices indices) {
        for (std::uint32_t& index : indices)
            index = static_cast<std::uint32_t>(GetParam().count) - 1 - index;
        return indices;
    };
    const Mesh mesh = makeMesh(data);
    EXPECT_EQ(mesh.triangles, turned(GetParam().triangles));
    EXPECT_EQ(mesh.lines, turned(GetParam().lines));
    EXPECT_EQ(mesh.points, turned(GetParam().points));
    EXPECT_EQ(faceNames(mesh), GetParam().faces);
}

INSTANTIATE_TEST_SUITE_P(
    All, Primitives,
    testing::Values(
        Case{"Points", Primitive::Points, 3, {}, {}, {0, 1, 2}, {"Points"}},
        Case{"NoPoints", Primitive::Points, 0, {}, {}, {}, {}},
        Case{"Lines", Primitive::Lines, 5, {}, {0, 1, 2, 3}, {}, {"Line 1", "Line 2"}},
        Case{"NoLines", Primitive::Lines, 1, {}, {}, {}, {}},
        Case{"LineStrip", Primitive::LineStrip, 4, {}, {0, 1, 1, 2, 2, 3}, {}, {"Line strip"}},
        Case{"NoLineStrip", Primitive::LineStrip, 1, {}, {}, {}, {}},
        Case{"LineLoop", Primitive::LineLoop, 3, {}, {0, 1, 1, 2, 2, 0}, {}, {"Line loop"}},
        Case{"LineLoopOfTwo", Primitive::LineLoop, 2, {}, {0, 1, 1, 0}, {}, {"Line loop"}},
        Case{"NoLineLoop", Primitive::LineLoop, 1, {}, {}, {}, {}},
        Case{"Triangles", Primitive::Triangles, 8, {0, 1, 2, 3, 4, 5}, {}, {}, {"Triangle 1", "Triangle 2"}},
        Case{"NoTriangles", Primitive::Triangles, 2, {}, {}, {}, {}},
        Case{"TriangleStrip", Primitive::TriangleStrip, 5, {0, 1, 2, 2, 1, 3, 2, 3, 4}, {}, {}, {"Strip"}},
        Case{"NoTriangleStrip", Primitive::TriangleStrip, 2, {}, {}, {}, {}},
        Case{"TriangleFan", Primitive::TriangleFan, 5, {0, 1, 2, 0, 2, 3, 0, 3, 4}, {}, {}, {"Fan"}},
        Case{"NoTriangleFan", Primitive::TriangleFan, 2, {}, {}, {}, {}},
        Case{"Quads",
             Primitive::Quads,
             11,
             {0, 1, 3, 1, 2, 3, 4, 5, 7, 5, 6, 7},
             {},
             {},
             {"Quad 1", "Quad 2"}},
        Case{"NoQuads", Primitive::Quads, 3, {}, {}, {}, {}},
        Case{"QuadStrip", Primitive::QuadStrip, 7, {0, 1, 3, 2, 0, 3, 2, 3, 5, 4, 2, 5}, {}, {}, {"Strip"}},
        Case{"NoQuadStrip", Primitive::QuadStrip, 3, {}, {}, {}, {}},
        Case{"Polygon", Primitive::Polygon, 5, {1, 2, 0, 2, 3, 0, 3, 4, 0}, {}, {}, {"Polygon"}},
        Case{"NoPolygon", Primitive::Polygon, 2, {}, {}, {}, {}}),
    [](const auto& test) { return std::string(test.param.name); });

// Two squares side by side, as each primitive would have them, counter-clockwise.
TEST(MeshData, EveryTriangleAndOutlineKeepsItsOrientation) {
    const glm::vec3 a(0, 0, 0);
    const glm::vec3 b(1, 0, 0);
    const glm::vec3 c(2, 0, 0);
    const glm::vec3 d(2, 1, 0);
    const glm::vec3 e(1, 1, 0);
    const glm::vec3 f(0, 1, 0);
    struct Shown {
        Primitive primitive;
        std::vector<glm::vec3> positions;
    };
    const Shown shown[] = {
        {Primitive::Triangles, {a, b, f, b, e, f, b, c, e, c, d, e}},
        {Primitive::TriangleStrip, {f, a, e, b, d, c}},
        {Primitive::TriangleFan, {a, b, c, d, e, f}},
        {Primitive::Quads, {a, b, e, f, b, c, d, e}},
        {Primitive::QuadStrip, {f, a, e, b, d, c}},
        {Primitive::Polygon, {a, b, c, d, e, f}},
    };
    for (const Shown& each : shown) {
        SCOPED_TRACE(static_cast<std::uint32_t>(each.primitive));
        const Mesh mesh = makeMesh(MeshData{.primitive = each.primitive, .positions = each.positions});
        const auto at = [&](std::uint32_t index) { return mesh.vertices.at(index).position; };
        float area = 0;
        for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
            const glm::vec3 first = at(mesh.triangles[i]);
            const float twice =
                glm::cross(at(mesh.triangles[i + 1]) - first, at(mesh.triangles[i + 2]) - first).z;
            EXPECT_GE(twice, 0);
            area += twice / 2;
        }
        EXPECT_EQ(area, 2);
        float outlined = 0;
        for (const Face& face : mesh.faces) {
            EXPECT_TRUE(face.closed);
            for (std::size_t i = 0; i < face.vertices.size(); ++i)
                outlined +=
                    glm::cross(at(face.vertices[i]), at(face.vertices[(i + 1) % face.vertices.size()])).z / 2;
        }
        EXPECT_EQ(outlined, 2);
    }
}

TEST(MeshData, StripsAreOutlinedUpOneEdgeAndDownTheOther) {
    const auto outline = [](Primitive primitive, int count) {
        return makeMesh(dataOf(primitive, count)).faces.at(0).vertices;
    };
    EXPECT_THAT(outline(Primitive::TriangleStrip, 3), ElementsAre(0, 1, 2));
    EXPECT_THAT(outline(Primitive::TriangleStrip, 6), ElementsAre(0, 1, 3, 5, 4, 2));
    EXPECT_THAT(outline(Primitive::TriangleStrip, 7), ElementsAre(0, 1, 3, 5, 6, 4, 2));
    EXPECT_THAT(outline(Primitive::QuadStrip, 4), ElementsAre(0, 1, 3, 2));
    EXPECT_THAT(outline(Primitive::QuadStrip, 7), ElementsAre(0, 1, 3, 5, 4, 2)) << "7 of them make 2 quads";
}

TEST(MeshData, LinesAndPointsAreNotClosed) {
    for (const Primitive primitive : {Primitive::Points, Primitive::Lines, Primitive::LineStrip})
        for (const Face& face : makeMesh(dataOf(primitive, 6)).faces)
            EXPECT_FALSE(face.closed) << face.name;
    EXPECT_TRUE(makeMesh(dataOf(Primitive::LineLoop, 6)).faces.at(0).closed);
    EXPECT_THAT(makeMesh(dataOf(Primitive::Lines, 4)).faces.at(1).vertices, ElementsAre(2, 3));
}

TEST(MeshData, ManyPartsHaveOneFaceTogether) {
    struct Part {
        Primitive primitive;
        int vertices;
    };
    for (const Part& part :
         {Part{Primitive::Lines, 2}, Part{Primitive::Triangles, 3}, Part{Primitive::Quads, 4}}) {
        EXPECT_EQ(makeMesh(dataOf(part.primitive, 64 * part.vertices + 1)).faces.size(), 64U);
        const Mesh mesh = makeMesh(dataOf(part.primitive, 65 * part.vertices));
        ASSERT_EQ(mesh.faces.size(), 1U);
        EXPECT_EQ(mesh.faces[0].name, "Vertices");
        EXPECT_EQ(mesh.faces[0].vertices.size(), mesh.vertices.size());
        EXPECT_FALSE(mesh.faces[0].closed);
    }
}

TEST(MeshData, VerticesCountOnceHoweverOftenTheyAreDrawn) {
    MeshData data = dataOf(Primitive::Triangles, 4);
    data.indices = {0, 1, 2, 2, 1, 3};
    const Mesh mesh = makeMesh(data);
    EXPECT_EQ(mesh.vertices.size(), 4U);
    EXPECT_THAT(mesh.triangles, ElementsAre(0, 1, 2, 2, 1, 3));
    EXPECT_THAT(mesh.faces.at(1).vertices, ElementsAre(2, 1, 3));
}

TEST(MeshData, IndicesBeyondThePositionsAreLeftOut) {
    MeshData data = dataOf(Primitive::Triangles, 3);
    data.indices = {0, 3, 1, -1, std::numeric_limits<int>::max(), std::numeric_limits<int>::min(), 2};
    EXPECT_THAT(makeMesh(data).triangles, ElementsAre(0, 1, 2));
    data.indices = {7};
    EXPECT_THAT(makeMesh(data).triangles, IsEmpty());
    EXPECT_THAT(makeMesh(data).faces, IsEmpty());
}

TEST(MeshData, WhatIsNotGivenIsAsGlBeginsWith) {
    const Mesh mesh = makeMesh(dataOf(Primitive::Points, 1));
    EXPECT_EQ(mesh.vertices.at(0), (Vertex{{0, 0, 0}, {0, 0, 1}, {0, 0, 0, 1}, {1, 1, 1, 1}}));
    EXPECT_FALSE(mesh.colored);
}

TEST(MeshData, EveryVertexHasItsOwn) {
    MeshData data = dataOf(Primitive::Lines, 2);
    data.normals = {{0, 3, 4}, {-2, 0, 0}};
    data.colors = {{1, 0, 0, 1}, {0, 0.5F, 0, 0.25F}};
    data.texCoords = {{1, 2, 3, 4}, {5, 6, 7, 8}};
    const Mesh mesh = makeMesh(data);
    EXPECT_TRUE(mesh.colored);
    EXPECT_EQ(mesh.vertices.at(0).normal, glm::vec3(0, 0.6F, 0.8F));
    EXPECT_EQ(mesh.vertices.at(1), (Vertex{{1, 1, 0}, {-1, 0, 0}, {5, 6, 7, 8}, {0, 0.5F, 0, 0.25F}}));
}

TEST(MeshData, NormalsHaveUnitLengthOrNone) {
    MeshData data = dataOf(Primitive::Points, 6);
    data.normals = {{0, 0, 0}, {nan, 0, 1}, {0, infinity, 0}, {3e38F, 0, 3e38F}, {0, 1e-40F, 0}, {0, 0, -1}};
    const Mesh mesh = makeMesh(data);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_EQ(mesh.vertices.at(i).normal, glm::vec3(0));
    EXPECT_NEAR(mesh.vertices.at(3).normal.x, 0.70710678F, 1e-6F);
    EXPECT_EQ(mesh.vertices.at(4).normal, glm::vec3(0, 1, 0));
    EXPECT_EQ(mesh.vertices.at(5).normal, glm::vec3(0, 0, -1));
}

TEST(MeshData, ListsThatDontFitAreLeftOut) {
    MeshData data = dataOf(Primitive::Points, 2);
    data.normals = {{1, 0, 0}};
    data.colors = {{1, 0, 0, 1}, {1, 0, 0, 1}, {1, 0, 0, 1}};
    data.texCoords = {{1, 1, 1, 1}};
    EXPECT_EQ(makeMesh(data).vertices, makeMesh(dataOf(Primitive::Points, 2)).vertices);
    EXPECT_FALSE(makeMesh(data).colored);
}

TEST(MeshData, OfNothingIsNothing) {
    for (const EnumRow& row : primitiveRows) {
        const Mesh mesh = makeMesh(MeshData{.primitive = static_cast<Primitive>(row.value)});
        EXPECT_THAT(mesh.vertices, IsEmpty());
        EXPECT_THAT(mesh.faces, IsEmpty());
        EXPECT_FALSE(mesh.colored);
    }
    const Mesh unknown = makeMesh(dataOf(static_cast<Primitive>(99), 9));
    EXPECT_THAT(unknown.triangles, IsEmpty());
    EXPECT_THAT(unknown.faces, IsEmpty());
}

} // namespace
} // namespace texplorer::mesh_data_test

#include "texplorer/mesh/mesh.h"

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

namespace texplorer::mesh_test {
namespace {

struct Case {
    const char* name;
    ShapeOptions options;
    std::size_t vertices;
    std::size_t triangles;
    std::size_t faces;
};

class Meshes : public testing::TestWithParam<Case> {
protected:
    Mesh mesh_ = makeMesh(GetParam().options);

    glm::vec3 position(std::uint32_t vertex) const { return mesh_.vertices.at(vertex).position; }
    /// Twice the area, in the direction from which the corners are seen counter-clockwise.
    glm::vec3 facing(std::size_t triangle) const {
        const std::uint32_t* corner = &mesh_.triangles.at(3 * triangle);
        return glm::cross(position(corner[1]) - position(corner[0]),
                          position(corner[2]) - position(corner[0]));
    }
};

TEST_P(Meshes, HaveTheCountsThatTheirShapeSays) {
    EXPECT_EQ(mesh_.vertices.size(), GetParam().vertices);
    EXPECT_EQ(mesh_.triangles.size(), 3 * GetParam().triangles);
    EXPECT_EQ(mesh_.faces.size(), GetParam().faces);
    EXPECT_THAT(mesh_.lines, testing::IsEmpty());
    EXPECT_THAT(mesh_.points, testing::IsEmpty());
    EXPECT_FALSE(mesh_.colored);
    EXPECT_EQ(vertexCount(GetParam().options), GetParam().vertices);
}

TEST_P(Meshes, EveryTriangleHasAnAreaAndFacesItsNormals) {
    for (std::size_t triangle = 0; triangle < mesh_.triangles.size() / 3; ++triangle) {
        const glm::vec3 direction = facing(triangle);
        ASSERT_GT(glm::length(direction), 1e-6F) << "triangle " << triangle;
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const Vertex& vertex = mesh_.vertices.at(mesh_.triangles[3 * triangle + corner]);
            ASSERT_GT(glm::dot(direction, vertex.normal), 0.0F) << "triangle " << triangle;
        }
    }
}

TEST_P(Meshes, NormalsHaveUnitLength) {
    for (const Vertex& vertex : mesh_.vertices)
        ASSERT_NEAR(glm::length(vertex.normal), 1.0F, 1e-6F);
}

TEST_P(Meshes, FacesCoverEveryVertexAndTheirOutlinesRunCounterClockwise) {
    std::set<std::uint32_t> covered;
    std::set<std::string> names;
    for (const Face& face : mesh_.faces) {
        EXPECT_TRUE(names.insert(face.name).second) << face.name;
        ASSERT_GE(face.vertices.size(), 3U) << face.name;
        EXPECT_TRUE(face.closed) << face.name;
        // In texture space every face of these meshes is seen as the image is, and most are rectangles: the
        // signed area of its outline (the shoelace formula) is positive.
        float area = 0;
        for (std::size_t i = 0; i < face.vertices.size(); ++i) {
            const glm::vec4 a = mesh_.vertices.at(face.vertices[i]).texCoord;
            const glm::vec4 b = mesh_.vertices.at(face.vertices[(i + 1) % face.vertices.size()]).texCoord;
            area += (a.s * b.t - b.s * a.t) / 2;
            covered.insert(face.vertices[i]);
        }
        EXPECT_GT(area, 0.0F) << face.name;
    }
    EXPECT_EQ(covered.size(), mesh_.vertices.size());
}

INSTANTIATE_TEST_SUITE_P(
    All, Meshes,
    testing::Values(
        Case{"Cube", {Shape::Cube}, 24, 12, 6}, Case{"Quad", {Shape::Quad}, 4, 2, 1},
        Case{"Floor", {Shape::Floor}, 4, 2, 1},
        Case{"Sphere32x16", {Shape::Sphere, 32, 16}, 33 * 17, 32 * 15 * 2, 16},
        Case{"Sphere3x2", {Shape::Sphere, 3, 2}, 4 * 3, 6, 2},
        Case{"Sphere5x7", {Shape::Sphere, 5, 7}, 6 * 8, 5 * 6 * 2, 7},
        Case{"SphereTooCoarse", {Shape::Sphere, -1, 0}, 4 * 3, 6, 2},
        Case{"SphereTooFine", {Shape::Sphere, 1 << 30, 257}, 257 * 257, 256 * 255 * 2, 256},
        Case{"Cylinder32x16", {Shape::Cylinder, 32, 16}, 33 * 17, 32 * 16 * 2, 16},
        Case{"CylinderTooCoarse", {Shape::Cylinder, 2, 1}, 4 * 3, 3 * 2 * 2, 2},
        Case{"CylinderTooFine", {Shape::Cylinder, 300, 300}, 257 * 257, 256 * 256 * 2, 256},
        Case{
            "Cone7x5", {.shape = Shape::Cylinder, .slices = 7, .stacks = 5, .topRadius = 0}, 8 * 6, 7 * 9, 5},
        Case{"Funnel3x2", {.shape = Shape::Cylinder, .slices = 3, .stacks = 2, .topRadius = 4}, 4 * 3, 12, 2},
        Case{"Disk32x16", {Shape::Disk, 32, 16}, 33 * 17, 32 * 31, 16},
        Case{"DiskTooCoarse", {Shape::Disk, 0, 0}, 4 * 3, 3 * 3, 2},
        Case{"Ring7x5",
             {.shape = Shape::Disk, .slices = 7, .stacks = 5, .innerRadius = 0.5F},
             8 * 6,
             7 * 10,
             5},
        Case{"PartialDisk9x4", {Shape::PartialDisk, 9, 4}, 10 * 5, 9 * 7, 4},
        Case{"Arc9x4",
             {.shape = Shape::PartialDisk, .slices = 9, .stacks = 4, .innerRadius = 0.9F, .sweepAngle = -90},
             10 * 5,
             9 * 8,
             4},
        Case{"Torus32x16", {Shape::Torus, 32, 16}, 33 * 17, 32 * 16 * 2, 16},
        Case{
            "Torus5x3", {.shape = Shape::Torus, .slices = 5, .stacks = 3, .tubeRadius = 0.25F}, 6 * 4, 30, 3},
        // Ten rings of patches, two of which end in a pole.
        Case{"Teapot32x16", {Shape::Teapot, 32, 16}, 33 * 164, 32 * (160 * 2 - 2), 160},
        Case{"Teapot7x5", {Shape::Teapot, 7, 5}, 8 * 54, 7 * (50 * 2 - 2), 50},
        Case{"TeapotTooFine", {Shape::Teapot, 16, 256}, 17 * 244, 16 * (240 * 2 - 2), 240}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(OwnMesh, IsNoShape) {
    const Mesh mesh = makeMesh({Shape::Mesh});
    EXPECT_TRUE(mesh.vertices.empty());
    EXPECT_TRUE(mesh.triangles.empty());
    EXPECT_TRUE(mesh.faces.empty());
    EXPECT_EQ(vertexCount({Shape::Mesh}), 0U);
}

TEST(Cube, FacesAreNamedAndTheirImagesStandUpright) {
    struct Expected {
        const char* name;
        glm::vec3 normal;
        glm::vec3 right; // where s grows
        glm::vec3 up;    // where t grows
    };
    // Worked out from standing in front of each face; above the top and below the bottom with the front at
    // one's feet and head.
    const Expected expected[] = {
        {"Front", {0, 0, 1}, {1, 0, 0}, {0, 1, 0}}, {"Back", {0, 0, -1}, {-1, 0, 0}, {0, 1, 0}},
        {"Left", {-1, 0, 0}, {0, 0, 1}, {0, 1, 0}}, {"Right", {1, 0, 0}, {0, 0, -1}, {0, 1, 0}},
        {"Top", {0, 1, 0}, {1, 0, 0}, {0, 0, -1}},  {"Bottom", {0, -1, 0}, {1, 0, 0}, {0, 0, 1}},
    };
    const Mesh cube = makeMesh({Shape::Cube});
    ASSERT_EQ(cube.faces.size(), std::size(expected));
    for (std::size_t i = 0; i < std::size(expected); ++i) {
        SCOPED_TRACE(expected[i].name);
        EXPECT_EQ(cube.faces[i].name, expected[i].name);
        ASSERT_EQ(cube.faces[i].vertices.size(), 4U);
        for (const std::uint32_t index : cube.faces[i].vertices) {
            const Vertex& vertex = cube.vertices.at(index);
            EXPECT_EQ(vertex.normal, expected[i].normal);
            EXPECT_EQ(glm::dot(vertex.position, expected[i].normal), 1.0F);
            EXPECT_EQ(vertex.texCoord.s, (glm::dot(vertex.position, expected[i].right) + 1) / 2);
            EXPECT_EQ(vertex.texCoord.t, (glm::dot(vertex.position, expected[i].up) + 1) / 2);
            EXPECT_EQ(vertex.texCoord.p, 0.0F);
            EXPECT_EQ(vertex.texCoord.q, 1.0F);
        }
        EXPECT_EQ(cube.vertices[cube.faces[i].vertices[0]].texCoord, glm::vec4(0, 0, 0, 1))
            << "lower left first";
    }
}

// gluSphere (GLU 1.3, libutil's quad.c) with its z axis up: vertex (i, j) lies at
// (sin(a) sin(b), cos(a) sin(b), cos(b)) with a = 2 pi i / slices and b = pi j / stacks, and has the
// coordinates (1 - i / slices, 1 - j / stacks). Turned about x so that z becomes y, (x, y, z) is at (x, z,
// -y).
TEST(Sphere, PositionsAndCoordinatesFollowGluSphere) {
    const int slices = 12;
    const int stacks = 6;
    const Mesh sphere = makeMesh({Shape::Sphere, slices, stacks});
    for (int j = 0; j <= stacks; ++j)
        for (int i = 0; i <= slices; ++i) {
            const double a = 2 * std::numbers::pi * i / slices;
            const double b = std::numbers::pi * j / stacks;
            const auto index = static_cast<std::size_t>((stacks - j) * (slices + 1) + (slices - i));
            const Vertex& vertex = sphere.vertices.at(index);
            SCOPED_TRACE(testing::Message() << "slice " << i << ", stack " << j);
            EXPECT_NEAR(vertex.texCoord.s, 1.0 - static_cast<double>(i) / slices, 1e-6);
            EXPECT_NEAR(vertex.texCoord.t, 1.0 - static_cast<double>(j) / stacks, 1e-6);
            EXPECT_NEAR(vertex.position.x, std::sin(a) * std::sin(b), 1e-6);
            EXPECT_NEAR(vertex.position.y, std::cos(b), 1e-6);
            EXPECT_NEAR(vertex.position.z, -std::cos(a) * std::sin(b), 1e-6);
            EXPECT_EQ(vertex.normal, vertex.position);
        }
}

TEST(Sphere, TheFrontShowsTheMiddleOfTheImageAndEastIsToTheRight) {
    const Mesh sphere = makeMesh({Shape::Sphere, 4, 2});
    const auto at = [&](int slice) { return sphere.vertices.at(static_cast<std::size_t>(5 + slice)); };
    EXPECT_EQ(at(0).position, glm::vec3(0, 0, -1));
    EXPECT_EQ(at(1).position, glm::vec3(-1, 0, 0));
    EXPECT_EQ(at(2).position, glm::vec3(0, 0, 1));
    EXPECT_EQ(at(3).position, glm::vec3(1, 0, 0));
    EXPECT_EQ(at(4).position, at(0).position) << "the seam must close exactly";
    EXPECT_EQ(at(2).texCoord, glm::vec4(0.5F, 0.5F, 0, 1));
    EXPECT_EQ(at(4).texCoord, glm::vec4(1, 0.5F, 0, 1));
}

TEST(Sphere, PolesArePoints) {
    const Mesh sphere = makeMesh({Shape::Sphere, 7, 5});
    for (std::size_t i = 0; i < 8; ++i) {
        EXPECT_EQ(sphere.vertices.at(i).position, glm::vec3(0, -1, 0));
        EXPECT_EQ(sphere.vertices.at(sphere.vertices.size() - 1 - i).position, glm::vec3(0, 1, 0));
    }
    EXPECT_EQ(sphere.faces.front().name, "Stack 1");
    EXPECT_EQ(sphere.faces.back().name, "Stack 5");
}

// libGLU's quad.c: a GL_QUAD_STRIP for each stack from the north pole down, of pairs (i, j + 1), (i, j);
// Mesa's division of the quadrilateral (i, j + 1), (i, j), (i + 1, j), (i + 1, j + 1) runs from (i, j + 1) to
// (i + 1, j), and both triangles end at (i + 1, j), the strip's last vertex.
TEST(Sphere, TrianglesComeAsGluSphereDrawsThem) {
    const int slices = 5;
    const int stacks = 4;
    const Mesh sphere = makeMesh({Shape::Sphere, slices, stacks});
    const auto at = [&](int i, int j) {
        return static_cast<std::uint32_t>((stacks - j) * (slices + 1) + (slices - i));
    };
    std::vector<std::uint32_t> expected;
    const auto expect = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        expected.insert(expected.end(), {a, b, c});
    };
    for (int j = 0; j < stacks; ++j)
        for (int i = 0; i < slices; ++i) {
            if (j + 1 < stacks)
                expect(at(i + 1, j + 1), at(i, j + 1), at(i + 1, j));
            if (j > 0)
                expect(at(i, j + 1), at(i, j), at(i + 1, j));
        }
    EXPECT_EQ(sphere.triangles, expected);
}

TEST(Patches, AreDividedBetweenTheirSecondAndFourthCorner) {
    EXPECT_THAT(makeMesh({Shape::Quad}).triangles, testing::ElementsAre(0, 1, 3, 1, 2, 3));
    EXPECT_THAT(makeMesh({Shape::Floor}).triangles, testing::ElementsAre(0, 1, 3, 1, 2, 3));
    const Mesh cube = makeMesh({Shape::Cube});
    for (std::uint32_t face = 0; face < 6; ++face) {
        const auto first = cube.triangles.begin() + 6 * static_cast<std::ptrdiff_t>(face);
        const std::uint32_t at = 4 * face;
        EXPECT_THAT(std::vector(first, first + 6),
                    testing::ElementsAre(at, at + 1, at + 3, at + 1, at + 2, at + 3));
    }
}

TEST(Floor, HasOneTileAUnitAndReachesIntoTheDistance) {
    const Mesh floor = makeMesh({Shape::Floor});
    for (const Vertex& vertex : floor.vertices) {
        EXPECT_EQ(vertex.position.y, -1.0F);
        EXPECT_EQ(vertex.texCoord.s, vertex.position.x + 4);
        EXPECT_EQ(vertex.texCoord.t, 4 - vertex.position.z);
    }
    EXPECT_EQ(floor.vertices.at(2).texCoord, glm::vec4(8, 80, 0, 1));
}

} // namespace
} // namespace texplorer::mesh_test

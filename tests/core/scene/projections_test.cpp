#include "texplorer/scene/projections.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace texplorer::projections_test {
namespace {

Mesh meshOfShape(Shape shape, int slices = 32, int stacks = 16) {
    return makeMesh({.shape = shape, .slices = slices, .stacks = stacks});
}

TexCoords projectedAll(const Mesh& mesh, CoordProjection projection) {
    std::vector<std::size_t> all(mesh.vertices.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    return projectedTexCoords(mesh, projection, all, TexCoords(all.size(), glm::vec4(9)));
}

struct Case {
    const char* name;
    Shape shape;
    CoordProjection projection;
    int slices;
    int stacks;
};

void PrintTo(const Case& each, std::ostream* out) {
    *out << each.name;
}

class OwnMapping : public testing::TestWithParam<Case> {};

// The meshes' own coordinates are worked out from angles and shares, not from positions.
TEST_P(OwnMapping, ComesOutAgain) {
    const Case& each = GetParam();
    const Mesh mesh = meshOfShape(each.shape, each.slices, each.stacks);
    const TexCoords coords = projectedAll(mesh, each.projection);
    for (std::size_t i = 0; i < coords.size(); ++i) {
        for (int component = 0; component < 4; ++component)
            EXPECT_NEAR(coords[i][component], mesh.vertices[i].texCoord[component], 2e-6F)
                << "vertex " << i << ", component " << component;
    }
}

INSTANTIATE_TEST_SUITE_P(
    All, OwnMapping,
    testing::Values(Case{"Cube", Shape::Cube, CoordProjection::Box, 32, 16},
                    Case{"Quad", Shape::Quad, CoordProjection::Planar, 32, 16},
                    Case{"Sphere", Shape::Sphere, CoordProjection::Spherical, 32, 16},
                    Case{"CoarsestSphere", Shape::Sphere, CoordProjection::Spherical, 3, 2},
                    Case{"FineSphere", Shape::Sphere, CoordProjection::Spherical, 128, 64},
                    Case{"Cylinder", Shape::Cylinder, CoordProjection::Cylindrical, 32, 16},
                    Case{"OddCylinder", Shape::Cylinder, CoordProjection::Cylindrical, 7, 3}),
    [](const auto& test) { return test.param.name; });

TEST(Projections, OfACorner) {
    const Mesh cube = meshOfShape(Shape::Cube);
    ASSERT_EQ(cube.vertices[2].position, glm::vec3(1, 1, 1));
    EXPECT_EQ(projectedAll(cube, CoordProjection::Planar)[2], glm::vec4(1, 1, 0, 1));
    // Half way between the front and the right: 0.5 + 45/360; atan(1 / sqrt(2)) is 35.2644 degrees.
    const glm::vec4 onSphere = projectedAll(cube, CoordProjection::Spherical)[2];
    EXPECT_NEAR(onSphere.s, 0.625F, 1e-6F);
    EXPECT_NEAR(onSphere.t, 0.5F + 35.2644F / 180, 1e-6F);
    EXPECT_NEAR(projectedAll(cube, CoordProjection::Cylindrical)[2].t, 1, 1e-6F);
}

// The back of a cube lies on both sides of the seam, at 0.875 and at 0.125.
TEST(Projections, AFaceAcrossTheSeamStaysInOnePiece) {
    const Mesh cube = meshOfShape(Shape::Cube);
    const TexCoords coords = projectedAll(cube, CoordProjection::Spherical);
    for (const Face& face : cube.faces) {
        if (face.name == "Top" || face.name == "Bottom")
            continue; // all around a pole
        for (const std::uint32_t vertex : face.vertices)
            EXPECT_LE(std::abs(coords[vertex].s - coords[face.vertices.front()].s), 0.2501F) << face.name;
    }
}

// Three triangles around a tip; their other corners are at 0.375, 0.625 and 1, which from the first one on
// is 0.
TEST(Projections, WithoutALongitudeItIsBetweenThoseAroundIt) {
    Mesh tent;
    for (const glm::vec3 position :
         {glm::vec3(-1, -1, 1), glm::vec3(1, -1, 1), glm::vec3(0, -1, -1), glm::vec3(0, 1, 0)})
        tent.vertices.push_back({position, {0, 0, 1}, {0.5F, 0, 0, 1}});
    tent.triangles = {0, 1, 3, 1, 2, 3, 2, 0, 3};
    EXPECT_EQ(projectedAll(tent, CoordProjection::Spherical)[3].s, 0.5F) << "its own is one of those";
    tent.vertices[3].texCoord.s = 5;
    EXPECT_NEAR(projectedAll(tent, CoordProjection::Spherical)[3].s, 1.0F / 3, 1e-5F);
}

TEST(Projections, ChangeOnlyWhatTheyAreAskedFor) {
    const Mesh cube = meshOfShape(Shape::Cube);
    const std::vector<std::size_t> one{2};
    const TexCoords before(cube.vertices.size(), glm::vec4(3, 4, 5, 6));
    const TexCoords after = projectedTexCoords(cube, CoordProjection::Planar, one, before);
    for (std::size_t i = 0; i < after.size(); ++i)
        EXPECT_EQ(after[i], i == 2 ? glm::vec4(1, 1, 0, 1) : before[i]);
}

TEST(Projections, WithoutExtentAreZero) {
    Mesh point;
    point.vertices.push_back({{7, 8, 9}, {0, 0, 0}, {0, 0, 0, 1}});
    for (const EnumRow& row : EnumTable<CoordProjection>::rows) {
        const glm::vec4 coord = projectedAll(point, static_cast<CoordProjection>(row.value)).front();
        EXPECT_TRUE(std::isfinite(coord.s) && std::isfinite(coord.t)) << row.label;
    }
    EXPECT_EQ(projectedAll(point, CoordProjection::Planar).front(), glm::vec4(0, 0, 0, 1));
    EXPECT_TRUE(projectedAll(Mesh{}, CoordProjection::Spherical).empty());
}

} // namespace
} // namespace texplorer::projections_test

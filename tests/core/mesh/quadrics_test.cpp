// Cylinder, disks and torus, against what gluCylinder, gluDisk and gluPartialDisk draw.

#include "texplorer/mesh/mesh.h"

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace texplorer::quadrics_test {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

void expectNear(const glm::vec3& found, const glm::vec3& expected) {
    EXPECT_LT(glm::distance(found, expected), 1e-6F)
        << found.x << ", " << found.y << ", " << found.z << " instead of " << expected.x << ", " << expected.y
        << ", " << expected.z;
}

/// GLU's vertex i, counted clockwise (from above, from the front), in row j.
const Vertex& vertexAt(const Mesh& mesh, int slices, int i, int j) {
    return mesh.vertices.at(static_cast<std::size_t>(j * (slices + 1) + slices - i));
}

std::uint32_t indexAt(int slices, int i, int j) {
    return static_cast<std::uint32_t>(j * (slices + 1) + slices - i);
}

/// The triangles of a GL_QUAD_STRIP of the pairs (i, j), (i, j + 1), as core/mesh/mesh.h divides them.
void addStrip(std::vector<std::uint32_t>& triangles, int slices, int j) {
    for (int i = 0; i < slices; ++i) {
        const std::uint32_t pair = indexAt(slices, i, j);
        const std::uint32_t other = indexAt(slices, i, j + 1);
        const std::uint32_t nextPair = indexAt(slices, i + 1, j);
        const std::uint32_t last = indexAt(slices, i + 1, j + 1);
        triangles.insert(triangles.end(), {nextPair, pair, last, pair, other, last});
    }
}

std::vector<std::string> faceNames(const Mesh& mesh) {
    std::vector<std::string> names;
    for (const Face& face : mesh.faces)
        names.push_back(face.name);
    return names;
}

struct Extents {
    glm::vec3 least{infinity};
    glm::vec3 greatest{-infinity};
};

Extents extentsOf(const Mesh& mesh) {
    Extents extents;
    for (const Vertex& vertex : mesh.vertices) {
        extents.least = glm::min(extents.least, vertex.position);
        extents.greatest = glm::max(extents.greatest, vertex.position);
    }
    return extents;
}

TEST(Cylinder, StandsUprightAndItsFrontShowsTheMiddleOfTheImage) {
    const Mesh cylinder = makeMesh({Shape::Cylinder, 4, 2});
    const Extents extents = extentsOf(cylinder);
    EXPECT_EQ(extents.least, glm::vec3(-1));
    EXPECT_EQ(extents.greatest, glm::vec3(1));
    const glm::vec3 compass[] = {{0, 0, -1}, {-1, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 0, -1}};
    for (std::size_t stack = 0; stack < 3; ++stack)
        for (std::size_t slice = 0; slice < 5; ++slice) {
            const Vertex& vertex = cylinder.vertices.at(5 * stack + slice);
            const float up = static_cast<float>(stack) - 1;
            EXPECT_EQ(vertex.position, compass[slice] + glm::vec3(0, up, 0));
            EXPECT_EQ(vertex.normal, compass[slice]);
            EXPECT_EQ(vertex.texCoord,
                      glm::vec4(static_cast<float>(slice) / 4, static_cast<float>(stack) / 2, 0, 1));
        }
    EXPECT_THAT(faceNames(cylinder), testing::ElementsAre("Stack 1", "Stack 2"));
}

// gluCylinder (libutil's quad.c): vertex (i, j) lies at (r sin(a), r cos(a), j height / stacks) with
// a = 2 pi i / slices and r straight from the base's radius to the top's, and has the coordinates
// (1 - i / slices, j / stacks): s runs against what the manual page says, as gluSphere's does. Turned as the
// sphere is, (x, y, z) is at (x, z, -y).
TEST(Cylinder, PositionsAndCoordinatesFollowGluCylinder) {
    const int slices = 12;
    const int stacks = 6;
    for (const double top : {0.0, 0.25, 1.0, 3.0}) {
        const Mesh mesh = makeMesh({.shape = Shape::Cylinder,
                                    .slices = slices,
                                    .stacks = stacks,
                                    .topRadius = static_cast<float>(top)});
        const double slant = std::hypot(1 - top, 2.0);
        for (int j = 0; j <= stacks; ++j)
            for (int i = 0; i <= slices; ++i) {
                SCOPED_TRACE(testing::Message() << "top " << top << ", slice " << i << ", stack " << j);
                const double angle = 2 * std::numbers::pi * i / slices;
                const double height = static_cast<double>(j) / stacks;
                const double radius = 1 + (top - 1) * height;
                const double around = 2 / slant;
                const Vertex& vertex = vertexAt(mesh, slices, i, j);
                expectNear(vertex.position,
                           {radius * std::sin(angle), 2 * height - 1, -radius * std::cos(angle)});
                expectNear(vertex.normal,
                           {around * std::sin(angle), (1 - top) / slant, -around * std::cos(angle)});
                EXPECT_NEAR(vertex.texCoord.s, 1.0 - static_cast<double>(i) / slices, 1e-6);
                EXPECT_NEAR(vertex.texCoord.t, height, 1e-6);
            }
    }
}

// A GL_QUAD_STRIP for each stack from the base up.
TEST(Cylinder, TrianglesComeAsGluCylinderDrawsThem) {
    const int slices = 5;
    const int stacks = 3;
    std::vector<std::uint32_t> expected;
    for (int j = 0; j < stacks; ++j)
        addStrip(expected, slices, j);
    EXPECT_EQ(makeMesh({Shape::Cylinder, slices, stacks}).triangles, expected);
}

TEST(Cylinder, IsAConeWithATopRadiusOfZero) {
    const Mesh cone = makeMesh({.shape = Shape::Cylinder, .slices = 4, .stacks = 2, .topRadius = 0});
    for (std::size_t slice = 0; slice < 5; ++slice)
        EXPECT_EQ(cone.vertices.at(10 + slice).position, glm::vec3(0, 1, 0));
    // One goes up by 2 where the radius shrinks by 1: the normal rises by 1 where it goes out by 2.
    const float root = std::sqrt(5.0F);
    expectNear(cone.vertices.at(2).normal, {0, 1 / root, 2 / root});
    expectNear(cone.vertices.at(13).normal, {2 / root, 1 / root, 0});
    EXPECT_EQ(cone.triangles.size(), 3U * (4 * 2 + 4)) << "half of the last stack has no area";
    std::vector<std::uint32_t> tip(cone.triangles.end() - 3, cone.triangles.end());
    EXPECT_THAT(tip, testing::ElementsAre(5, 6, 10));
}

TEST(Cylinder, TakesNoRadiusThatIsNone) {
    const auto withTop = [](float top) {
        return makeMesh({.shape = Shape::Cylinder, .slices = 5, .stacks = 4, .topRadius = top}).vertices;
    };
    EXPECT_EQ(withTop(-1), withTop(0));
    EXPECT_EQ(withTop(nan), withTop(0));
    EXPECT_EQ(withTop(-infinity), withTop(0));
    EXPECT_TRUE(std::isfinite(withTop(infinity).back().position.x));
    EXPECT_NEAR(glm::length(withTop(infinity).back().normal), 1, 1e-6F);
}

TEST(Disk, LiesFlatWithTheImageOnIt) {
    const Mesh disk = makeMesh({.shape = Shape::Disk, .slices = 4, .stacks = 2, .innerRadius = 0.5F});
    const glm::vec3 compass[] = {{0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {1, 0, 0}, {0, 1, 0}};
    const float radii[] = {1, 0.75F, 0.5F};
    for (std::size_t ring = 0; ring < 3; ++ring)
        for (std::size_t slice = 0; slice < 5; ++slice) {
            const Vertex& vertex = disk.vertices.at(5 * ring + slice);
            EXPECT_EQ(vertex.position, radii[ring] * compass[slice]);
            EXPECT_EQ(vertex.normal, glm::vec3(0, 0, 1));
            // GLU's manual page: (1, 0.5) at +x, (0.5, 1) at +y, (0, 0.5) at -x, (0.5, 0) at -y, and linear.
            EXPECT_EQ(vertex.texCoord,
                      glm::vec4(vertex.position.x / 2 + 0.5F, vertex.position.y / 2 + 0.5F, 0, 1));
        }
    EXPECT_THAT(faceNames(disk), testing::ElementsAre("Ring 1", "Ring 2"));
    EXPECT_THAT(disk.faces[0].vertices, testing::ElementsAre(0, 1, 2, 3, 4, 9, 8, 7, 6, 5))
        << "from the outside in";
}

// A GL_QUAD_STRIP for each ring from the rim inwards.
TEST(Disk, TrianglesComeAsGluDiskDrawsThem) {
    const int slices = 5;
    const int rings = 3;
    std::vector<std::uint32_t> expected;
    for (int j = 0; j < rings; ++j)
        addStrip(expected, slices, j);
    EXPECT_EQ(
        makeMesh({.shape = Shape::Disk, .slices = slices, .stacks = rings, .innerRadius = 0.5F}).triangles,
        expected);
}

// Before them a GL_TRIANGLE_FAN of the centre and the innermost ring's outer edge, counter-clockwise.
TEST(Disk, BeginsWithAFanAroundItsCentre) {
    const int slices = 5;
    const int rings = 3;
    std::vector<std::uint32_t> expected;
    for (int i = slices; i > 0; --i)
        expected.insert(expected.end(), {indexAt(slices, i, rings), indexAt(slices, i, rings - 1),
                                         indexAt(slices, i - 1, rings - 1)});
    for (int j = 0; j < rings - 1; ++j)
        addStrip(expected, slices, j);
    const Mesh disk = makeMesh({Shape::Disk, slices, rings});
    EXPECT_EQ(disk.triangles, expected);
    for (int i = 0; i <= slices; ++i) {
        EXPECT_EQ(vertexAt(disk, slices, i, rings).position, glm::vec3(0));
        EXPECT_EQ(vertexAt(disk, slices, i, rings).texCoord, glm::vec4(0.5F, 0.5F, 0, 1));
    }
}

TEST(Disk, HoldsTheHoleWithinIt) {
    const auto withHole = [](float radius) {
        return makeMesh({.shape = Shape::Disk, .slices = 5, .stacks = 4, .innerRadius = radius}).vertices;
    };
    EXPECT_EQ(withHole(-1), withHole(0));
    EXPECT_EQ(withHole(nan), withHole(0));
    EXPECT_EQ(withHole(2), withHole(1));
    EXPECT_EQ(withHole(infinity), withHole(1));
}

Mesh sector(float start, float sweep, float innerRadius = 0) {
    return makeMesh({.shape = Shape::PartialDisk,
                     .slices = 6,
                     .stacks = 2,
                     .innerRadius = innerRadius,
                     .startAngle = start,
                     .sweepAngle = sweep});
}

// GLU's manual page: 0 degrees is towards +y, 90 towards +x, 180 towards -y.
TEST(PartialDisk, GoesClockwiseFromItsStart) {
    const Mesh mesh = sector(90, 180);
    EXPECT_EQ(vertexAt(mesh, 6, 0, 0).position, glm::vec3(1, 0, 0));
    EXPECT_EQ(vertexAt(mesh, 6, 3, 0).position, glm::vec3(0, -1, 0));
    EXPECT_EQ(vertexAt(mesh, 6, 6, 0).position, glm::vec3(-1, 0, 0));
    EXPECT_EQ(vertexAt(mesh, 6, 3, 1).position, glm::vec3(0, -0.5F, 0));
    EXPECT_EQ(vertexAt(mesh, 6, 3, 1).texCoord, glm::vec4(0.5F, 0.25F, 0, 1));
    const float root = std::sqrt(3.0F) / 2;
    expectNear(vertexAt(mesh, 6, 1, 0).position, {root, -0.5F, 0});
    for (const Vertex& vertex : mesh.vertices)
        EXPECT_EQ(vertex.normal, glm::vec3(0, 0, 1));
}

TEST(PartialDisk, BackwardsIsTheSameSector) {
    EXPECT_EQ(sector(90, -90).vertices, sector(0, 90).vertices);
    EXPECT_EQ(sector(90, -90).triangles, sector(0, 90).triangles);
    EXPECT_EQ(sector(-30, -60, 0.5F).vertices, sector(-90, 60, 0.5F).vertices);
}

TEST(PartialDisk, GoesAroundOnceAtMost) {
    EXPECT_EQ(sector(30, 400).vertices, sector(30, 360).vertices);
    EXPECT_EQ(sector(30, -400).vertices, sector(30, 360).vertices);
    EXPECT_EQ(sector(30, infinity).vertices, sector(30, 0).vertices) << "no number at all";
    const Mesh whole = sector(17, 360, 0.25F);
    for (int ring = 0; ring <= 2; ++ring)
        EXPECT_EQ(vertexAt(whole, 6, 0, ring), vertexAt(whole, 6, 6, ring)) << "it must close exactly";
}

TEST(PartialDisk, IsADiskAllTheWayAround) {
    for (const float hole : {0.0F, 0.5F}) {
        const Mesh disk = makeMesh({.shape = Shape::Disk, .slices = 6, .stacks = 2, .innerRadius = hole});
        EXPECT_EQ(sector(0, 360, hole).vertices, disk.vertices);
        EXPECT_EQ(sector(0, 360, hole).triangles, disk.triangles);
    }
}

TEST(PartialDisk, TakesAnyAngle) {
    for (const float start : {nan, infinity, 1e30F, -1e30F})
        for (const Vertex& vertex : sector(start, 90).vertices)
            EXPECT_LE(glm::length(vertex.position), 1.000001F);
    EXPECT_EQ(sector(nan, 90).vertices, sector(0, 90).vertices);
    expectNear(vertexAt(sector(450, 90), 6, 1, 0).position, vertexAt(sector(90, 90), 6, 1, 0).position);
}

TEST(Torus, CompassPointsOfTheRingAndOfTheTube) {
    const Mesh torus = makeMesh({.shape = Shape::Torus, .slices = 4, .stacks = 4, .tubeRadius = 0.25F});
    const glm::vec3 around[] = {{0, 0, -1}, {-1, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 0, -1}};
    struct Row {
        float out; ///< from the axis
        float up;
        float normalOut;
        float normalUp;
    };
    const Row rows[] = {
        {0.75F, 0, -1, 0}, {1, -0.25F, 0, -1}, {1.25F, 0, 1, 0}, {1, 0.25F, 0, 1}, {0.75F, 0, -1, 0}};
    for (std::size_t stack = 0; stack < 5; ++stack)
        for (std::size_t slice = 0; slice < 5; ++slice) {
            const Vertex& vertex = torus.vertices.at(5 * stack + slice);
            const Row& row = rows[stack];
            EXPECT_EQ(vertex.position, row.out * around[slice] + glm::vec3(0, row.up, 0));
            EXPECT_EQ(vertex.normal, row.normalOut * around[slice] + glm::vec3(0, row.normalUp, 0));
            EXPECT_EQ(vertex.texCoord,
                      glm::vec4(static_cast<float>(slice) / 4, static_cast<float>(stack) / 4, 0, 1));
        }
    EXPECT_THAT(faceNames(torus), testing::ElementsAre("Stack 1", "Stack 2", "Stack 3", "Stack 4"));
}

TEST(Torus, EveryPointLiesATubeRadiusFromTheRing) {
    for (const Vertex& vertex :
         makeMesh({.shape = Shape::Torus, .slices = 9, .stacks = 7, .tubeRadius = 0.4F}).vertices) {
        const glm::vec3 middle = vertex.position - 0.4F * vertex.normal;
        EXPECT_NEAR(middle.y, 0, 1e-6F);
        EXPECT_NEAR(glm::length(middle), 1, 1e-6F);
    }
}

TEST(Torus, TakesNoRadiusThatIsNone) {
    const auto withTube = [](float radius) {
        return makeMesh({.shape = Shape::Torus, .slices = 5, .stacks = 4, .tubeRadius = radius}).vertices;
    };
    EXPECT_EQ(withTube(-1), withTube(0));
    EXPECT_EQ(withTube(nan), withTube(0));
    for (const Vertex& vertex : withTube(infinity))
        EXPECT_TRUE(std::isfinite(vertex.position.x) && std::isfinite(vertex.position.y));
}

} // namespace
} // namespace texplorer::quadrics_test

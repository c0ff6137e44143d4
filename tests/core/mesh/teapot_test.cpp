// The teapot, against what M. Newell's control points say by themselves.

#include "texplorer/mesh/mesh.h"
#include "texplorer/mesh/mesh_data.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <tuple>

namespace texplorer::teapot_test {
namespace {

constexpr int slices = 32;
constexpr int stacks = 16;
constexpr int length = slices + 1;

/// A part's rows of vertices, as many as its rings of patches say.
struct Part {
    const char* name;
    int firstRow;
    int rings;
};
constexpr std::array parts{Part{"Body", 0, 4}, Part{"Lid", 4 * stacks + 1, 2},
                           Part{"Handle", 6 * stacks + 2, 2}, Part{"Spout", 8 * stacks + 3, 2}};

class Teapot : public testing::Test {
protected:
    Mesh mesh_ = makeMesh({Shape::Teapot, slices, stacks});

    const Vertex& at(const Part& part, int row, int slice) const {
        return mesh_.vertices.at(static_cast<std::size_t>((part.firstRow + row) * length + slice));
    }
    /// Between two rings of patches.
    const Vertex& joint(const Part& part, int ring, int slice) const {
        return at(part, ring * stacks, slice);
    }
};

std::tuple<float, float, float> key(glm::vec3 v) {
    return {v.x + 0.0F, v.y + 0.0F, v.z + 0.0F}; // -0 is 0
}

/// In Newell's units: x, and the height where we have y.
glm::vec3 inNewellsUnits(glm::vec3 position) {
    return position * 2.0F + glm::vec3(0, 1.5F, 0);
}

void expectNear(glm::vec3 found, glm::vec3 expected) {
    EXPECT_LT(glm::distance(found, expected), 1e-5F)
        << found.x << ", " << found.y << ", " << found.z << " instead of " << expected.x << ", " << expected.y
        << ", " << expected.z;
}

TEST_F(Teapot, PassesThroughTheCornersOfItsPatches) {
    // What the published patches have at their corners: radius and height, from below.
    const std::array<glm::vec2, 5> body{glm::vec2(0, 0), {1.5, 0.15}, {2, 0.9}, {1.5, 2.4}, {1.4, 2.4}};
    const std::array<glm::vec2, 3> lid{glm::vec2(1.3, 2.4), {0.2, 2.7}, {0, 3.15}};
    const std::array<glm::vec3, 4> ways{glm::vec3(0, 0, -1), {-1, 0, 0}, {0, 0, 1}, {1, 0, 0}};
    for (int quarter = 0; quarter < 4; ++quarter) {
        const int slice = quarter * slices / 4;
        const auto turned = [&](glm::vec2 corner) {
            return ways.at(static_cast<std::size_t>(quarter)) * corner.x + glm::vec3(0, corner.y, 0);
        };
        for (int ring = 0; ring <= 4; ++ring)
            expectNear(inNewellsUnits(joint(parts[0], ring, slice).position),
                       turned(body.at(static_cast<std::size_t>(ring))));
        for (int ring = 0; ring <= 2; ++ring)
            expectNear(inNewellsUnits(joint(parts[1], ring, slice).position),
                       turned(lid.at(static_cast<std::size_t>(ring))));
    }
    // Handle and spout: the inner and the outer side of the tube.
    const std::array<glm::vec4, 3> handle{
        glm::vec4(-1.6, 2.025, -1.5, 2.25), {-2.7, 1.8, -3, 1.8}, {-2, 0.9, -1.9, 0.6}};
    const std::array<glm::vec4, 3> spout{
        glm::vec4(1.7, 1.425, 1.7, 0.6), {2.7, 2.4, 3.3, 2.4}, {2.8, 2.4, 3.2, 2.4}};
    for (int ring = 0; ring <= 2; ++ring) {
        for (const auto& [part, corners] : {std::pair(parts[2], handle), std::pair(parts[3], spout)}) {
            const glm::vec4 corner = corners.at(static_cast<std::size_t>(ring));
            expectNear(inNewellsUnits(joint(part, ring, 0).position), {corner.x, corner.y, 0});
            expectNear(inNewellsUnits(joint(part, ring, slices / 2).position), {corner.z, corner.w, 0});
        }
    }
}

// B(1/2) = (p0 + 3 p1 + 3 p2 + p3) / 8, both ways: the middle of a quarter is at ((r + 3 r + 3 a) / 8, (3 a +
// 3 r + r) / 8) of a ring with the radius r and the reach a.
TEST_F(Teapot, MiddlesOfPatchesAreThoseOfDeCasteljau) {
    const float radius = (1.5F + 3 * 1.75F + 3 * 2 + 2) / 8; // of the upper half of the body
    const float reach = (0.84F + 3 * 0.98F + 3 * 1.12F + 1.12F) / 8;
    const float height = (2.4F + 3 * 1.875F + 3 * 1.35F + 0.9F) / 8;
    const float diagonal = (4 * radius + 3 * reach) / 8;
    expectNear(inNewellsUnits(at(parts[0], 2 * stacks + stacks / 2, 3 * slices / 8).position),
               {-diagonal, height, diagonal}); // between left and front
    // The bend of the handle, in the middle of its front half: x and height are means of inner and outer.
    const glm::vec2 inner(-(1.6F + 3 * 2.3F + 3 * 2.7F + 2.7F) / 8, (7 * 2.025F + 1.8F) / 8);
    const glm::vec2 outer(-(1.5F + 3 * 2.5F + 3 * 3.0F + 3.0F) / 8, (7 * 2.25F + 1.8F) / 8);
    const glm::vec2 middle = (inner + outer) / 2.0F;
    expectNear(inNewellsUnits(at(parts[2], stacks / 2, slices / 4).position),
               {middle.x, middle.y, 0.3F * 6 / 8});
}

// A patch lies within the hull of its control points, and touches it where the corners do.
TEST_F(Teapot, LiesWithinItsControlPoints) {
    glm::vec3 least(10);
    glm::vec3 greatest(-10);
    for (const Vertex& vertex : mesh_.vertices) {
        least = glm::min(least, vertex.position);
        greatest = glm::max(greatest, vertex.position);
    }
    EXPECT_EQ(least.x, -1.5F);
    EXPECT_EQ(least.y, -0.75F);
    EXPECT_EQ(greatest.y, 0.825F);
    EXPECT_GT(greatest.x, 3.3F / 2);
    EXPECT_LT(greatest.x, 3.525F / 2);
    EXPECT_NEAR(greatest.z, 1, 0.01F); // the body's widest ring, which no row hits
    EXPECT_LE(greatest.z, 1);
    EXPECT_EQ(least.z, -greatest.z);
}

TEST_F(Teapot, FrontAndBackAreMirrored) {
    std::set<std::tuple<int, int, int>> places;
    const auto rounded = [](glm::vec3 v) {
        const glm::ivec3 whole(glm::round(v * 1e4F));
        return std::tuple(whole.x, whole.y, whole.z);
    };
    for (const Vertex& vertex : mesh_.vertices)
        for (int nudge = -1; nudge <= 1; ++nudge) // where rounding falls to either side
            places.insert(rounded(vertex.position + glm::vec3(0, 0, static_cast<float>(nudge) * 4e-5F)));
    for (const Vertex& vertex : mesh_.vertices)
        ASSERT_TRUE(places.contains(rounded(vertex.position * glm::vec3(1, 1, -1))))
            << vertex.position.x << ", " << vertex.position.y << ", " << vertex.position.z;
}

/// How often each edge is walked, less how often it is walked the other way around.
std::map<std::pair<std::tuple<float, float, float>, std::tuple<float, float, float>>, int>
openEdges(const Mesh& mesh) {
    std::map<std::pair<std::tuple<float, float, float>, std::tuple<float, float, float>>, int> edges;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const std::size_t next = i % 3 == 2 ? i - 2 : i + 1;
        const auto from = key(mesh.vertices[mesh.triangles[i]].position);
        const auto to = key(mesh.vertices[mesh.triangles[next]].position);
        if (from < to)
            ++edges[{from, to}];
        else
            --edges[{to, from}];
    }
    std::erase_if(edges, [](const auto& edge) { return edge.second == 0; });
    return edges;
}

TEST_F(Teapot, HasNoGapsButWhereItIsOpen) {
    const auto edges = openEdges(mesh_);
    for (const auto& [ends, count] : edges)
        EXPECT_EQ(std::abs(count), 1);
    // The rim, the lid's edge, and both ends of handle and spout.
    EXPECT_EQ(edges.size(), static_cast<std::size_t>(slices * (1 + 1 + 2 + 2)));
}

TEST_F(Teapot, NormalsGoOnSmoothlyFromPatchToPatch) {
    // The published rows on both sides of a joint lie on one line with it. It bends most at the spout's lip.
    const int fine = maxTeapotStacks;
    const Mesh mesh = makeMesh({Shape::Teapot, slices, fine});
    for (std::size_t row = 0; row + 1 < mesh.vertices.size() / length; ++row) {
        const bool lastOfPart = mesh.vertices[row * length].texCoord.t == 1;
        for (std::size_t slice = 0; slice < length && !lastOfPart; ++slice) {
            const Vertex& here = mesh.vertices[row * length + slice];
            const Vertex& next = mesh.vertices[(row + 1) * length + slice];
            ASSERT_GT(glm::dot(here.normal, next.normal), 0.5F)
                << "row " << row << " of " << fine << " a patch, slice " << slice;
        }
    }
}

TEST_F(Teapot, PolesArePointsWhoseNormalsStandUpright) {
    for (int slice = 0; slice <= slices; ++slice) {
        EXPECT_EQ(at(parts[0], 0, slice).position, glm::vec3(0, -0.75F, 0));
        expectNear(at(parts[0], 0, slice).normal, {0, -1, 0});
        EXPECT_EQ(at(parts[1], 2 * stacks, slice).position, glm::vec3(0, 0.825F, 0));
        expectNear(at(parts[1], 2 * stacks, slice).normal, {0, 1, 0});
    }
}

TEST_F(Teapot, NormalsPointOutwards) {
    for (int row = 0; row <= 4 * stacks; ++row) // of the body, but for the rim's inner side
        for (int slice = 0; slice <= slices && row <= 3 * stacks; ++slice) {
            const Vertex& vertex = at(parts[0], row, slice);
            ASSERT_GT(glm::dot(vertex.normal, vertex.position - glm::vec3(0, -0.3F, 0)), 0.0F) << row;
        }
    for (const Part& part : {parts[2], parts[3]})
        for (int row = 0; row <= stacks; ++row) { // the spout's second half turns into its mouth
            EXPECT_GT(at(part, row, slices / 4).normal.z, 0) << part.name << row;
            EXPECT_LT(at(part, row, 3 * slices / 4).normal.z, 0) << part.name << row;
        }
}

TEST_F(Teapot, ImagesGoOnceAroundEachPart) {
    for (const Part& part : parts) {
        SCOPED_TRACE(part.name);
        for (int row = 0; row <= part.rings * stacks; ++row) {
            for (int slice = 0; slice <= slices; ++slice)
                ASSERT_EQ(at(part, row, slice).texCoord.s,
                          static_cast<float>(slice) / static_cast<float>(slices));
            ASSERT_EQ(key(at(part, row, 0).position), key(at(part, row, slices).position));
            if (row > 0) {
                ASSERT_GT(at(part, row, 0).texCoord.t, at(part, row - 1, 0).texCoord.t);
            }
        }
        EXPECT_EQ(at(part, 0, 0).texCoord.t, 0);
        EXPECT_EQ(at(part, part.rings * stacks, 0).texCoord.t, 1);
    }
    EXPECT_GT(at(parts[0], stacks, slices / 2).position.z, 0) << "the middle of the image is in front";
    EXPECT_EQ(mesh_.faces.front().name, "Body 1");
    EXPECT_EQ(mesh_.faces.back().name, "Spout 32");
}

TEST(TeapotOfAnySize, IsWithinTheLimits) {
    EXPECT_LE(vertexCount({Shape::Teapot, maxSubdivision, maxSubdivision}), maxMeshVertices);
    EXPECT_EQ(makeMesh({Shape::Teapot, 5, maxSubdivision}).vertices.size(),
              vertexCount({Shape::Teapot, 5, maxTeapotStacks}));
}

} // namespace
} // namespace texplorer::teapot_test

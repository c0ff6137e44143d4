#include "texplorer/scene/tex_coords.h"

#include <gtest/gtest.h>

namespace texplorer::tex_coords_test {
namespace {

class TexCoordsOfAQuad : public testing::Test {
protected:
    Model model_{.shape = Shape::Quad};
    Mesh mesh_ = makeMesh({Shape::Quad});
    glm::vec4 own_{7, 8, 0.5F, 2};
};

TEST_F(TexCoordsOfAQuad, AreThoseOfTheMeshUnlessTheSceneHasOnes) {
    const TexCoords list = effectiveTexCoords(model_, mesh_, 2);
    ASSERT_EQ(list.size(), mesh_.vertices.size());
    EXPECT_EQ(list[1], mesh_.vertices[1].texCoord);
    model_.texCoords[2].assign(mesh_.vertices.size(), own_);
    EXPECT_EQ(effectiveTexCoords(model_, mesh_, 2)[1], own_);
    EXPECT_EQ(effectiveTexCoords(model_, mesh_, 1)[1], mesh_.vertices[1].texCoord);
    EXPECT_EQ(effectiveTexCoord(model_, mesh_, 2, 1), own_);
    EXPECT_EQ(effectiveTexCoord(model_, mesh_, 1, 1), mesh_.vertices[1].texCoord);
}

TEST_F(TexCoordsOfAQuad, AreThoseOfTheMeshWhereAListDoesNotFit) {
    model_.texCoords[0].assign(mesh_.vertices.size() + 1, own_);
    EXPECT_EQ(effectiveTexCoords(model_, mesh_, 0)[0], mesh_.vertices[0].texCoord);
}

TEST_F(TexCoordsOfAQuad, ChangingOneVertexTakesTheOthersFromTheMesh) {
    setTexCoord(model_, mesh_, 3, 2, own_);
    ASSERT_EQ(model_.texCoords[3].size(), mesh_.vertices.size());
    EXPECT_EQ(model_.texCoords[3][2], own_);
    EXPECT_EQ(model_.texCoords[3][0], mesh_.vertices[0].texCoord);
    EXPECT_TRUE(model_.texCoords[0].empty());
}

TEST_F(TexCoordsOfAQuad, AVertexThatDoesNotExistChangesNothing) {
    setTexCoord(model_, mesh_, 0, mesh_.vertices.size(), own_);
    EXPECT_TRUE(model_.texCoords[0].empty());
}

} // namespace
} // namespace texplorer::tex_coords_test

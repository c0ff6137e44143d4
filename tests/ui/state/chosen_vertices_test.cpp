#include "app/ui/state/chosen_vertices.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace texplorer::ui::chosen_vertices_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(ChosenVertices, AreTheVertexAloneOrTheGroupThatHasIt) {
    Selection selection;
    EXPECT_THAT(chosenVertices(selection), IsEmpty());
    selection.vertex = 3;
    EXPECT_THAT(chosenVertices(selection), ElementsAre(3));
    chooseVertices(selection, {7, 3, 5, 3});
    EXPECT_THAT(chosenVertices(selection), ElementsAre(3, 5, 7));
    EXPECT_EQ(selection.vertex, 3U) << "it was one of them";
    EXPECT_TRUE(isChosen(selection, 7));
    EXPECT_FALSE(isChosen(selection, 4));
}

TEST(ChosenVertices, AGroupEndsWhereAnotherVertexOrModelIsChosen) {
    Selection selection;
    chooseVertices(selection, {1, 2});
    selection.vertex = 9;
    EXPECT_THAT(chosenVertices(selection), ElementsAre(9));
    EXPECT_FALSE(isChosen(selection, 1));
    chooseVertices(selection, {1, 2});
    selection.model = 1;
    EXPECT_THAT(chosenVertices(selection), ElementsAre(1));
}

TEST(ChosenVertices, AreAddedAndTakenAway) {
    Selection selection;
    toggleVertex(selection, 4);
    toggleVertex(selection, 2);
    EXPECT_THAT(chosenVertices(selection), ElementsAre(2, 4));
    EXPECT_EQ(selection.vertex, 2U) << "the newest";
    toggleVertex(selection, 2);
    EXPECT_THAT(chosenVertices(selection), ElementsAre(4));
    EXPECT_EQ(selection.vertex, 4U);
    toggleVertex(selection, 4);
    EXPECT_EQ(selection.vertex, std::nullopt);
}

} // namespace
} // namespace texplorer::ui::chosen_vertices_test

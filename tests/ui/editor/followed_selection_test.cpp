#include "app/ui/editor/followed_selection.h"

#include <gtest/gtest.h>

namespace texplorer::ui::followed_selection_test {
namespace {

Selection after(const Edit& edit) {
    Selection selection{.model = 2, .vertex = 4, .group = {}, .pass = 2, .unit = 1};
    follow(selection, edit);
    return selection;
}

TEST(FollowedSelection, StaysWithItsPassAndModel) {
    EXPECT_EQ(after(edit::Remove{"passes", 0}).pass, 1);
    EXPECT_EQ(after(edit::Remove{"passes", 3}).pass, 2);
    EXPECT_EQ(after(edit::Move{"passes", 2, 0}).pass, 0);
    EXPECT_EQ(after(edit::Move{"passes", 0, 2}).pass, 1);
    EXPECT_EQ(after(edit::Move{"models", 3, 1}).model, 3);
}

TEST(FollowedSelection, GoesToWhatIsInserted) {
    EXPECT_EQ(after(edit::Insert{"passes", 3, 2}).pass, 3);
    EXPECT_EQ(after(edit::Insert{"models", 0}).model, 0);
    EXPECT_EQ(after(edit::Insert{"models", 0}).pass, 2);
}

TEST(FollowedSelection, GoesToTheElementAfterARemovedOne) {
    EXPECT_EQ(after(edit::Remove{"models", 2}).model, 2); // the editor corrects the number of the last
}

TEST(FollowedSelection, KeepsVerticesUnlessTheListOfModelsChanges) {
    EXPECT_EQ(after(edit::Remove{"models", 0}).vertex, std::nullopt);
    EXPECT_EQ(after(edit::Remove{"passes", 0}).vertex, 4U);
    EXPECT_EQ(after(edit::Remove{"textures", 0}).vertex, 4U);
    EXPECT_EQ(after(edit::Set{"view.azimuth", "1"}).vertex, 4U);
}

TEST(FollowedSelection, TellsWhetherModelsOrPassesHaveOtherIndices) {
    Selection selection;
    EXPECT_TRUE(follow(selection, edit::Move{"models", 0, 1}));
    EXPECT_TRUE(follow(selection, edit::Remove{"passes", 1}));
    EXPECT_FALSE(follow(selection, edit::Remove{"textures", 1}));
    EXPECT_FALSE(follow(selection, edit::Set{"view.azimuth", "1"}));
}

} // namespace
} // namespace texplorer::ui::followed_selection_test

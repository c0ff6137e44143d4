#include "texplorer/base/shared_list.h"

#include <gmock/gmock.h>

namespace texplorer::shared_list_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(SharedLists, CopiesShareTheElementsUntilOneIsEdited) {
    SharedList<int> first{1, 2, 3};
    SharedList<int> second = first;
    EXPECT_EQ(first.data(), second.data());
    second.edit()[0] = 7;
    EXPECT_NE(first.data(), second.data());
    EXPECT_THAT(first, ElementsAre(1, 2, 3));
    EXPECT_THAT(second, ElementsAre(7, 2, 3));
    const int* const alone = second.data();
    second.edit()[1] = 8;
    EXPECT_EQ(second.data(), alone) << "it shares them with no other";
}

TEST(SharedLists, EachEditLeavesTheOthersAlone) {
    const SharedList<int> given{1};
    SharedList<int> list = given;
    list.push_back(2);
    list.emplace_back(3);
    EXPECT_THAT(list, ElementsAre(1, 2, 3));
    list.resize(2);
    list.assign(2, 9);
    EXPECT_THAT(list, ElementsAre(9, 9));
    list.clear();
    EXPECT_THAT(list, IsEmpty());
    EXPECT_THAT(given, ElementsAre(1));
}

TEST(SharedLists, AreEqualIfTheirElementsAre) {
    const SharedList<int> list{1, 2};
    EXPECT_EQ(list, (SharedList<int>{1, 2})) << "in different places";
    EXPECT_NE(list, (SharedList<int>{1, 3}));
    EXPECT_EQ(SharedList<int>(), SharedList<int>(std::vector<int>()));
    SharedList<int> emptied{1};
    emptied.edit().clear();
    EXPECT_EQ(emptied, SharedList<int>());
}

TEST(SharedLists, AreReadAsVectors) {
    const SharedList<int> list(3, 5);
    const std::vector<int>& read = list;
    EXPECT_EQ(read.data(), list.data()) << "no copy";
    EXPECT_EQ(list.front() + list.back() + list[1], 15);
    EXPECT_EQ(std::vector<int>(list.begin(), list.end()), read);
}

} // namespace
} // namespace texplorer::shared_list_test

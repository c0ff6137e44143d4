#include "app/ui/widgets/inset_placement.h"

#include <gtest/gtest.h>

#include <array>

namespace texplorer::ui::inset_placement_test {
namespace {

// A room of 100 x 100 with an image in its middle, as the texture space has it.
const Box room{{0, 0}, {100, 100}};
const Uncovered image{{{25, 25}, {75, 75}}, 1};

struct Case {
    const char* name;
    Box marks;
    ImVec2 size;
    std::size_t count;
};

void PrintTo(const Case& c, std::ostream* out) {
    *out << c.name;
}

class InsetPlacement : public testing::TestWithParam<Case> {};

TEST_P(InsetPlacement, MarksStayInSightWhereverTheyAre) {
    const auto& [name, marks, size, count] = GetParam();
    const std::array kept{image, Uncovered{marks, 100}};
    const std::vector<ImVec2> sizes(count, size);
    const std::vector<ImVec2> places = placeInsets(sizes, room, 2, kept);
    ASSERT_EQ(places.size(), count);
    std::vector<Box> boxes;
    for (const ImVec2& place : places)
        boxes.push_back({place, {place.x + size.x, place.y + size.y}});
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        EXPECT_GE(boxes[i].low.x, 0);
        EXPECT_GE(boxes[i].low.y, 0);
        EXPECT_LE(boxes[i].high.x, 100);
        EXPECT_LE(boxes[i].high.y, 100);
        EXPECT_FALSE(overlaps(boxes[i], marks));
        for (std::size_t j = 0; j < i; ++j)
            EXPECT_FALSE(overlaps(boxes[i], boxes[j]));
    }
}

INSTANTIATE_TEST_SUITE_P(All, InsetPlacement,
                         testing::Values(Case{"Middle", {{48, 48}, {52, 52}}, {35, 40}, 2},
                                         Case{"LowerLeft", {{25, 70}, {30, 75}}, {35, 40}, 2},
                                         Case{"LowerRight", {{70, 70}, {75, 75}}, {35, 40}, 2},
                                         Case{"UpperLeft", {{25, 25}, {30, 30}}, {35, 40}, 2},
                                         Case{"UpperRight", {{70, 25}, {75, 30}}, {35, 40}, 2},
                                         Case{"WholeRow", {{0, 70}, {100, 75}}, {35, 40}, 2},
                                         Case{"WholeColumn", {{70, 0}, {75, 100}}, {35, 40}, 2},
                                         Case{"Cross", {{48, 0}, {52, 100}}, {40, 40}, 2},
                                         Case{"Single", {{25, 70}, {30, 75}}, {45, 45}, 1}),
                         [](const auto& test) { return test.param.name; });

// 35 wide insets reach 10 pixels over the image at the sides, and 40 high ones 15 at the top or the bottom.
TEST(InsetPlacementTest, TheImageIsCoveredAsLittleAsCanBe) {
    const std::array sizes{ImVec2(35, 40), ImVec2(35, 40)};
    const std::vector<ImVec2> places = placeInsets(sizes, room, 2, std::array{image});
    EXPECT_TRUE(places[0].x == places[1].x || places[0].y == places[1].y);
    float covered = 0;
    for (const ImVec2& place : places) {
        const float width = std::min(place.x + 35, 75.0F) - std::max(place.x, 25.0F);
        const float height = std::min(place.y + 40, 75.0F) - std::max(place.y, 25.0F);
        covered += std::max(0.0F, width) * std::max(0.0F, height);
    }
    EXPECT_EQ(covered, 2 * 10 * 15) << "in two corners";
}

TEST(InsetPlacementTest, NothingHasNoPlace) {
    EXPECT_TRUE(placeInsets({}, room, 2, {}).empty());
}

} // namespace
} // namespace texplorer::ui::inset_placement_test

#include "app/ui/widgets/widget_places.h"

#include <gtest/gtest.h>

#include <optional>

namespace texplorer::ui::widget_places_test {
namespace {

TEST(WidgetPlacesTest, AreReportedWhileOneLives) {
    EXPECT_FALSE(arePlacesWanted());
    noteDrawn("before", {1, 2}, {3, 4}); // goes nowhere
    {
        const WidgetPlaces places;
        EXPECT_TRUE(arePlacesWanted());
        noteDrawn("a", {1, 2}, {3, 4});
        ASSERT_EQ(places.items.size(), 1U);
        EXPECT_EQ(places.items.at("a").right, 3);
        EXPECT_TRUE(places.items.at("a").visible);
        forgetPlaces();
        EXPECT_TRUE(places.items.empty());
    }
    EXPECT_FALSE(arePlacesWanted());
    noteDrawn("after", {1, 2}, {3, 4});
}

} // namespace
} // namespace texplorer::ui::widget_places_test

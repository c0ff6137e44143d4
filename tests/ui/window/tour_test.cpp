#include "app/ui/widgets/keys.h"
#include "app/ui/window/window_parts.h"
#include "tests/ui/workbench.h"

namespace texplorer::tour_test {
namespace {

using namespace ui;

class Tour : public test::Workbench {};

TEST_F(Tour, LeadsThroughItsSteps) {
    EXPECT_FALSE(has("tour:Next")) << "it is not asked for";
    click("menu:Help");
    click("menu:Tour");
    frames(2);
    EXPECT_EQ(session->window.tour, 0);
    for (int step = 1; step < tourSteps; ++step) {
        click("tour:Next");
        EXPECT_EQ(session->window.tour, step);
    }
    click("tour:Previous");
    EXPECT_EQ(session->window.tour, tourSteps - 2);
    click("tour:Next");
    EXPECT_FALSE(session->settings.hasSeenTour);
    click("tour:Done");
    EXPECT_FALSE(session->window.tour);
    EXPECT_TRUE(session->settings.hasSeenTour);
}

TEST_F(Tour, EndsWithSkipAndWithEscape) {
    session->window.tour = 1;
    frames(3);
    click("tour:Skip");
    EXPECT_FALSE(session->window.tour);
    session->window.tour = 1;
    session->look.explaining.pixel = {3, 3};
    frames(3);
    key(ui::key::escape);
    EXPECT_FALSE(session->window.tour);
    EXPECT_TRUE(session->look.explaining.pixel) << "one Escape does one thing";
}

// Who clicks on must not find Previous below the pointer.
TEST_F(Tour, KeepsNextWhereItIs) {
    start(defaultScene(), 1280, 800);
    session->window.tour = 0;
    frames(4);
    const WidgetPlaces::Item first = places.items.find("tour:Next")->second;
    for (int step = 1; step < tourSteps - 1; ++step) {
        click("tour:Next");
        frames(4);
        const WidgetPlaces::Item& next = places.items.find("tour:Next")->second;
        EXPECT_FLOAT_EQ(next.left, first.left) << step;
        EXPECT_FLOAT_EQ(next.bottom, first.bottom) << step;
    }
}

TEST_F(Tour, FitsIntoEveryWindow) {
    for (const auto& [width, height, scale] : {std::tuple(1024, 700, 1.0F), std::tuple(3840, 2160, 2.0F)}) {
        start(defaultScene(), width, height, scale);
        for (int step = 0; step < tourSteps; ++step) {
            session->window.tour = step;
            frames(3);
            const WidgetPlaces::Item& next =
                places.items.find(step + 1 < tourSteps ? "tour:Next" : "tour:Done")->second;
            EXPECT_TRUE(next.visible) << step;
            EXPECT_LE(next.right, static_cast<float>(width)) << step;
            EXPECT_LE(next.bottom, static_cast<float>(height)) << step;
        }
    }
}

} // namespace
} // namespace texplorer::tour_test

#include "app/ui/widgets/keys.h"
#include "app/ui/window/tour.h"
#include "tests/ui/workbench.h"

#include <cmath>
#include <utility>

namespace texplorer::tour_test {
namespace {

using namespace ui;

class Tour : public test::Workbench {};

TEST_F(Tour, IsNotShownUnlessItIsAskedFor) {
    EXPECT_FALSE(has("tour:Next"));
}

TEST_F(Tour, LeadsThroughItsSteps) {
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
    EXPECT_FALSE(session->window.settings.hasSeenTour);
    click("tour:Done");
    EXPECT_FALSE(session->window.tour);
    EXPECT_TRUE(session->window.settings.hasSeenTour);
}

TEST_F(Tour, EndsWithSkipAndWithEscape) {
    session->window.tour = 1;
    frames(3);
    click("tour:Skip");
    EXPECT_FALSE(session->window.tour);
    session->window.tour = 1;
    session->window.explaining.pixel = {3, 3};
    frames(3);
    key(ui::key::escape);
    EXPECT_FALSE(session->window.tour);
    EXPECT_TRUE(session->window.explaining.pixel) << "one Escape does one thing";
}

TEST_F(Tour, TheCardLiesBesideWhatItFrames) {
    start(defaultScene(), 1280, 800);
    const float em = ImGui::GetFontSize();
    for (const auto& [step, about] :
         {std::pair(0, &Layout::parameters), std::pair(1, &Layout::view), std::pair(2, &Layout::texture)}) {
        session->window.tour = step;
        frames(4);
        const WidgetPlaces::Item& previous = places.items.find("tour:Previous")->second; // at the card's left
        const Rect& framed = layout.*about;
        const float left = previous.left - em;
        const bool isRight = std::abs(left - static_cast<float>(framed.right())) < 2 * em;
        const bool isLeft =
            left < static_cast<float>(framed.x) && left + 28 * em > static_cast<float>(framed.x);
        const bool isAtItsEdge =
            std::abs(left - static_cast<float>(framed.x)) < 2 * em; // where there is no room
        EXPECT_TRUE(isRight || isLeft || (isAtItsEdge && step == 1))
            << step << ": " << left << ", " << framed.x << " to " << framed.right();
        EXPECT_GT(previous.top, static_cast<float>(framed.y)) << step;
        EXPECT_LT(previous.bottom, static_cast<float>(framed.bottom())) << step;
    }
}

// Who clicks on must not find Previous below the pointer.
TEST_F(Tour, ClicksThatGoOnDoNotLeadBack) {
    start(defaultScene(), 1280, 800);
    session->window.tour = 0;
    frames(4);
    for (int step = 1; step < tourSteps - 1; ++step) {
        const WidgetPlaces::Item next = places.items.find("tour:Next")->second;
        click("tour:Next");
        frames(4);
        const WidgetPlaces::Item& previous = places.items.find("tour:Previous")->second;
        const ImVec2 pointer((next.left + next.right) / 2, (next.top + next.bottom) / 2);
        EXPECT_FALSE(pointer.x > previous.left && pointer.x < previous.right && pointer.y > previous.top &&
                     pointer.y < previous.bottom)
            << step;
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

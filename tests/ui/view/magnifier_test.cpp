#include "app/ui/view/panes.h"
#include "tests/ui/workbench.h"

#include <gmock/gmock.h>

#include <array>

namespace texplorer::ui::magnifier_test {
namespace {

using namespace test;

class Magnifier : public Workbench {
protected:
    static std::array<int, 3> at(const Image& window, ImVec2 place) {
        const auto pixel =
            window.at(static_cast<int>(place.x), window.height - 1 - static_cast<int>(place.y));
        return {std::to_integer<int>(pixel[0]), std::to_integer<int>(pixel[1]),
                std::to_integer<int>(pixel[2])};
    }
    /// Where the pixel under the mouse is, enlarged.
    ImVec2 lens(const std::string& name) {
        const WidgetPlaces::Item& item = places.items.at("lens:" + name);
        return {item.left, item.top};
    }
    ImVec2 inside(float x, float y) const {
        return {static_cast<float>(layout.picture.x) + x * static_cast<float>(layout.picture.width),
                static_cast<float>(layout.picture.y) + y * static_cast<float>(layout.picture.height)};
    }
};

TEST_F(Magnifier, AKeyAndTheViewMenuSwitchIt) {
    moveTo(inside(0.5F, 0.5F));
    EXPECT_FALSE(has("lens:Fixed function"));
    key('M');
    EXPECT_TRUE(has("lens:Fixed function"));
    moveTo({5, 5});
    EXPECT_FALSE(has("lens:Fixed function")) << "the mouse is elsewhere";
    click("menu:View");
    click("menu:Magnifier");
    moveTo(inside(0.5F, 0.5F));
    EXPECT_FALSE(has("lens:Fixed function"));
}

TEST_F(Magnifier, ShowsThePixelUnderTheMouse) {
    session->view.magnifies = true;
    static_cast<void>(picture());
    for (const ImVec2 share :
         {ImVec2(0.2F, 0.5F), ImVec2(0.25F, 0.42F), ImVec2(0.7F, 0.5F), ImVec2(0.01F, 0.01F)}) {
        moveTo(inside(share.x, share.y));
        const Image window = picture();
        EXPECT_EQ(at(window, lens("Fixed function")), at(window, ImGui::GetIO().MousePos)) << share.x;
        const float cell = 9; // of 13-pixel letters
        EXPECT_EQ(at(window, {lens("Fixed function").x, lens("Fixed function").y - cell}),
                  at(window, {ImGui::GetIO().MousePos.x, ImGui::GetIO().MousePos.y - 1}))
            << share.x;
    }
}

TEST_F(Magnifier, ItsHeadingFits) {
    start(defaultScene(), 2400, 1200);
    session->view.magnifies = true;
    moveTo(inside(0.9F, 0.9F)); // where numbers are long
    const WidgetPlaces::Item& frame = places.items.at("magnifier");
    const WidgetPlaces::Item& where = places.items.at("magnifier:where");
    EXPECT_GT(where.left, frame.left);
    EXPECT_LT(where.right, frame.right);
}

TEST_F(Magnifier, ShowsTheSamePixelOfEveryPicture) {
    session->view.magnifies = true;
    showComparison(session->view, {RendererKind::Fixed, RendererKind::Shader, RendererKind::Reference});
    static_cast<void>(picture());
    static_cast<void>(picture());
    moveTo(inside(0.2F, 0.5F));
    const Image window = picture();
    const Panes panes(layout, session->view, {layout.picture.width, layout.picture.height});
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    for (const Pane& pane : panes.all()) {
        const std::string name = pane.renderer ? std::string(rowOf(*pane.renderer).label) : "Difference";
        const ImVec2 same(mouse.x + static_cast<float>(pane.frame.x - layout.picture.x),
                          mouse.y + static_cast<float>(pane.frame.y - layout.picture.y));
        const WidgetPlaces::Item& glass = places.items.at("magnifier");
        if (same.x < glass.left || same.x > glass.right || same.y < glass.top || same.y > glass.bottom) {
            EXPECT_EQ(at(window, lens(name)), at(window, same)) << name;
        }
    }
}

TEST_F(Magnifier, StaysInTheWindow) {
    start(defaultScene(), 900, 600);
    session->view.magnifies = true;
    showComparison(session->view, {RendererKind::Fixed, RendererKind::Shader, RendererKind::Reference});
    frames(2);
    for (const ImVec2 share :
         {ImVec2(0.1F, 0.2F), ImVec2(0.9F, 0.2F), ImVec2(0.1F, 0.95F), ImVec2(0.9F, 0.95F)}) {
        moveTo(inside(share.x, share.y));
        const WidgetPlaces::Item& glass = places.items.at("magnifier");
        EXPECT_GE(glass.left, 0);
        EXPECT_GE(glass.top, 0);
        EXPECT_LE(glass.right, 900);
        EXPECT_LE(glass.bottom, 600);
    }
}

} // namespace
} // namespace texplorer::ui::magnifier_test

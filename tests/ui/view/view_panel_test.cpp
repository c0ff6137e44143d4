#include "app/ui/view/framing.h"
#include "app/ui/view/panes.h"
#include "app/ui/widgets/keys.h"
#include "tests/ui/workbench.h"
#include "texplorer/scene/picking.h"

#include <algorithm>

namespace texplorer::ui::view_panel_test {
namespace {

using namespace test;

class ViewPanel : public Workbench {
protected:
    ImVec2 pixelOf(std::size_t model, std::size_t vertex) {
        const glm::vec2 at = projectVertex(scene(), model, vertex, 0, aspectOf(layout)).value();
        return {static_cast<float>(layout.picture.x) + at.x * static_cast<float>(layout.picture.width),
                static_cast<float>(layout.picture.y) + at.y * static_cast<float>(layout.picture.height)};
    }
    /// Somewhere in the picture where no model is.
    ImVec2 corner() {
        return {static_cast<float>(layout.picture.x + 15), static_cast<float>(layout.picture.y + 15)};
    }
};

TEST_F(ViewPanel, AClickPicksAVertexAndMarksIt) {
    const ImVec2 at = pixelOf(0, 2);
    clickAt({at.x + 2, at.y - 1});
    ASSERT_TRUE(session->look.selection.vertex.has_value());
    EXPECT_EQ(session->look.selection.model, 0);
    EXPECT_EQ(*session->look.selection.vertex, 2U);
    EXPECT_NEAR(places.items.at("marker").left, at.x, 1);
    EXPECT_NEAR(places.items.at("marker").top, at.y, 1);
    EXPECT_FALSE(session->document.history.canUndo()) << "selecting is no edit";
    clickAt(corner());
    EXPECT_FALSE(session->look.selection.vertex.has_value());
}

TEST_F(ViewPanel, ADragOrbitsAndIsNoPick) {
    const View before = scene().view;
    drag(pixelOf(0, 2), {50, 20});
    // 0.4 degrees a pixel, but for the first few pixels, which might have been a click.
    EXPECT_NEAR(scene().view.azimuth, before.azimuth - 50 * 0.4F, 6 * 0.4F);
    EXPECT_NEAR(scene().view.elevation, before.elevation + 20 * 0.4F, 6 * 0.4F);
    EXPECT_EQ(scene().view.target, before.target);
    EXPECT_FALSE(session->look.selection.vertex.has_value());
    drag(corner(), {50, 20});
    key('Z', {ctrl});
    EXPECT_EQ(scene().view, before) << "looking around is one step";
}

TEST_F(ViewPanel, ARightDragAndAShiftDragPan) {
    const View before = scene().view;
    drag(corner(), {30, 0}, ImGuiMouseButton_Right);
    EXPECT_NE(scene().view.target, before.target);
    EXPECT_EQ(scene().view.azimuth, before.azimuth);
    const glm::vec3 once = scene().view.target;
    setHeld(shift, true);
    drag(corner(), {-30, 0});
    setHeld(shift, false);
    EXPECT_NE(scene().view.target, once);
    EXPECT_EQ(scene().view.azimuth, before.azimuth);
}

TEST_F(ViewPanel, TheWheelZoomsAndADoubleClickFrames) {
    const float fitted = scene().view.distance;
    wheel(corner(), -10);
    EXPECT_GT(scene().view.distance, fitted * 2);
    doubleClickAt(corner());
    EXPECT_NEAR(scene().view.distance, fitted, fitted * 0.05F);
}

TEST_F(ViewPanel, WithCtrlTheMouseEnlargesAndMovesThePicture) {
    const View before = scene().view;
    setHeld(ctrl, true);
    wheel(pixelOf(0, 2), 1);
    wheel(pixelOf(0, 2), 1);
    EXPECT_EQ(session->view.zoom.factor, 4);
    setHeld(ctrl, false);
    const ImVec2 where = pixelOf(0, 2); // of the vertex, which stayed under the mouse
    clickAt(where);
    EXPECT_EQ(session->look.selection.vertex, 2U);
    EXPECT_NEAR(places.items.at("marker").left, where.x, 2); // half a pixel of the enlarged picture
    frames(25);                                              // the next press is no double click
    setHeld(ctrl, true);
    drag(where, {40, 20});
    setHeld(ctrl, false);
    EXPECT_NEAR(places.items.at("marker").left, where.x + 40, 8); // but for the click's first pixels
    EXPECT_NEAR(places.items.at("marker").top, where.y + 20, 8);
    EXPECT_EQ(scene().view, before);
}

TEST_F(ViewPanel, AnEnlargedPictureShowsItsPixelsAsSquares) {
    const ImVec2 at = pixelOf(0, 2);
    zoomPictures(session->view, layout, at, 5);
    const Image window = picture();
    for (int y = layout.picture.y; y < layout.picture.bottom(); ++y) {
        int changes = 0;
        for (int x = layout.picture.x + 1; x < layout.picture.right(); ++x) {
            const auto left = window.at(x - 1, window.height - 1 - y);
            const auto right = window.at(x, window.height - 1 - y);
            changes += std::ranges::equal(left, right) ? 0 : 1;
        }
        ASSERT_LE(changes, layout.picture.width / 32 + 1) << "row " << y;
    }
}

TEST_F(ViewPanel, KeysFrameAndResetTheCamera) {
    const View start = scene().view;
    drag(corner(), {70, 30});
    key(key::home);
    EXPECT_EQ(scene().view, start);
    wheel(corner(), -10);
    key('F');
    EXPECT_NEAR(scene().view.distance, start.distance, start.distance * 0.05F);
}

TEST_F(ViewPanel, ChoicesWithoutRoomAreInAMenu) {
    start(defaultScene(), 900, 600);
    EXPECT_FALSE(has("show:Floor"));
    click("more choices");
    click("show:Floor");
    EXPECT_EQ(shownNow(scene()), Show::Floor);
    click("more choices");
    EXPECT_TRUE(has("frame"));
    start(defaultScene());
    EXPECT_TRUE(has("show:Floor"));
    EXPECT_FALSE(has("more choices"));
}

TEST_F(ViewPanel, TheButtonsShowOneShapeAndSelectIt) {
    click("show:Sphere");
    EXPECT_FALSE(scene().models[0].visible);
    EXPECT_TRUE(scene().models[1].visible);
    EXPECT_EQ(session->look.selection.model, 1);
    click("show:Floor");
    ASSERT_EQ(scene().models.size(), 3U);
    EXPECT_EQ(scene().models[2].shape, Shape::Floor);
    key('Z', {ctrl});
    EXPECT_EQ(scene().models.size(), 2U);
}

TEST_F(ViewPanel, TheLivePictureIsOpaque) {
    scene().view.background = {0.2F, 0.4F, 0.6F, 0}; // the window must not shine through
    frames(2);
    const ImVec2 at = corner();
    const Image window = picture();
    const auto pixel = window.at(static_cast<int>(at.x), window.height - 1 - static_cast<int>(at.y));
    EXPECT_EQ(std::to_integer<int>(pixel[0]), 51);
    EXPECT_EQ(std::to_integer<int>(pixel[1]), 102);
    EXPECT_EQ(std::to_integer<int>(pixel[2]), 153);
}

TEST_F(ViewPanel, TheDefaultSceneIsWholeInANarrowView) {
    start(defaultScene(), 900, 1000);
    for (std::size_t model = 0; model < 2; ++model) {
        for (std::size_t vertex = 0; vertex < 24; ++vertex) {
            const ImVec2 at = pixelOf(model, vertex);
            EXPECT_GE(at.x, static_cast<float>(layout.picture.x));
            EXPECT_LE(at.x, static_cast<float>(layout.picture.right()));
        }
    }
    EXPECT_FALSE(session->document.history.canUndo());
    EXPECT_FALSE(isDirty(session->document));
}

TEST_F(ViewPanel, SeamsChangeTheWidthsOfTheColumns) {
    const int before = layout.parameters.width;
    drag(place("left seam"), {60, 0});
    EXPECT_EQ(layout.parameters.width, before + 60);
    const int right = layout.texture.width;
    drag(place("right seam"), {-40, 0});
    EXPECT_EQ(layout.texture.width, right + 40);
}

/// Every pixel belongs to a panel, at every size, and GL has nothing to say.
TEST_F(ViewPanel, PanelsCoverTheWholeWindow) {
    for (const auto& [width, height, scale] :
         {std::tuple(1280, 800, 1.0F), std::tuple(640, 400, 1.0F), std::tuple(1920, 1200, 1.5F)}) {
        start(defaultScene(), width, height, scale);
        frames(2);
        EXPECT_EQ(pixelsOfNoPanel(picture()), 0) << width;
    }
}

} // namespace
} // namespace texplorer::ui::view_panel_test

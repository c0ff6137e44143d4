#include "app/ui/state/layout.h"
#include "app/ui/view/panes.h"

#include <gmock/gmock.h>

namespace texplorer::ui::panes_test {
namespace {

constexpr view::Size picture{600, 400}; // twice as dense as the mouse

Layout layoutWith(const ViewSettings& settings, int width = 300, int height = 200) {
    const PaneGrid grid = gridOf(settings);
    Layout layout;
    layout.canvas = {100, 50, width * grid.columns + 2 * (grid.columns - 1),
                     height * grid.rows + 2 * (grid.rows - 1)};
    layout.picture = {100, 50, width, height};
    return layout;
}

TEST(Panes, OnePaneShowsTheWholePicture) {
    const ViewSettings settings;
    const Panes panes(layoutWith(settings), settings, picture);
    ASSERT_EQ(panes.all().size(), 1U);
    EXPECT_EQ(panes.all().front().renderer, RendererKind::Fixed);
    EXPECT_EQ(panes.pixelAt({100.75F, 50.75F}), glm::ivec2(1, 398)) << "rows are counted from the bottom";
    EXPECT_EQ(panes.pixelAt({100, 50}), glm::ivec2(0, 399));
    EXPECT_EQ(panes.pixelAt({101, 51}), glm::ivec2(2, 397));
    for (int x = 100; x < 400; ++x)
        ASSERT_EQ(panes.pixelAt({static_cast<float>(x), 60})->x, 2 * (x - 100));
    for (int y = 50; y < 250; ++y)
        ASSERT_EQ(panes.pixelAt({110, static_cast<float>(y)})->y, 399 - 2 * (y - 50));
    EXPECT_EQ(panes.pixelAt({399.9F, 249.9F}), glm::ivec2(599, 0));
    EXPECT_EQ(panes.pixelAt({99.9F, 100}), std::nullopt);
    EXPECT_EQ(panes.pixelAt({200, 250}), std::nullopt);
    EXPECT_EQ(panes.pixelExtent(), glm::vec2(0.5F));
    EXPECT_EQ(Panes(layoutWith(settings), settings, {0, 0}).pixelAt({200, 100}), std::nullopt)
        << "no picture";
}

TEST(Panes, TheSeamCutsOnePictureInTwo) {
    ViewSettings settings;
    showComparison(settings, {RendererKind::Shader, RendererKind::Reference});
    settings.split = 0.25F;
    const Panes panes(layoutWith(settings), settings, picture);
    ASSERT_EQ(panes.all().size(), 2U);
    const Pane* left = panes.under({174, 100});
    const Pane* right = panes.under({176, 100});
    ASSERT_TRUE(left && right);
    EXPECT_EQ(left->renderer, RendererKind::Shader);
    EXPECT_EQ(right->renderer, RendererKind::Reference);
    EXPECT_EQ(panes.toPicture(*left, {174, 100}), panes.toPicture(*right, {174, 100}));
}

TEST(Panes, TheGridShowsTheSamePixelInEveryPane) {
    ViewSettings settings;
    showComparison(settings, {RendererKind::Fixed, RendererKind::Shader, RendererKind::Reference});
    const Panes panes(layoutWith(settings), settings, picture);
    std::vector<std::optional<RendererKind>> shown;
    for (const Pane& pane : panes.all()) {
        shown.push_back(pane.renderer);
        EXPECT_EQ(panes.pixelAt(
                      {static_cast<float>(pane.frame.x) + 30.2F, static_cast<float>(pane.frame.y) + 60.3F}),
                  glm::ivec2(60, 279));
    }
    EXPECT_THAT(shown, testing::ElementsAre(RendererKind::Fixed, RendererKind::Shader,
                                            RendererKind::Reference, std::nullopt));
    EXPECT_EQ(panes.under({401, 100}), nullptr) << "the gap between them";
}

TEST(Panes, AZoomKeepsWhatIsUnderTheMouse) {
    ViewSettings settings;
    const Layout layout = layoutWith(settings);
    const ImVec2 mouse(340, 80);
    const glm::vec2 before = Panes(layout, settings, picture).toPicture({{}, layout.picture, {}}, mouse);
    for (int notch = 0; notch < 3; ++notch)
        zoomPictures(settings, layout, mouse, 1);
    EXPECT_EQ(settings.zoom.factor, 8);
    const Panes panes(layout, settings, picture);
    const glm::vec2 after = panes.toPicture(panes.all().front(), mouse);
    EXPECT_NEAR(after.x, before.x, 0.01F);
    EXPECT_NEAR(after.y, before.y, 0.01F);
    EXPECT_EQ(panes.pixelExtent(), glm::vec2(4));

    movePictures(settings, layout, {40, -16}); // the pictures follow the mouse: ten pixels, and four
    const Panes moved(layout, settings, picture);
    EXPECT_NEAR(moved.toPicture(moved.all().front(), mouse).x, before.x - 10, 0.01F);
    EXPECT_NEAR(moved.toPicture(moved.all().front(), mouse).y, before.y - 4, 0.01F);
    zoomPictures(settings, layout, mouse, -9);
    EXPECT_EQ(settings.zoom, PictureZoom());
}

TEST(Panes, NothingBeyondThePictureIsShown) {
    ViewSettings settings;
    const Layout layout = layoutWith(settings);
    zoomPictures(settings, layout, {101, 51}, 1);
    movePictures(settings, layout, {500, 500});
    const Panes panes(layout, settings, picture);
    EXPECT_EQ(panes.partLow(), glm::vec2(0, 0.5F));
    EXPECT_EQ(panes.partHigh(), glm::vec2(0.5F, 1));
    zoomPictures(settings, layout, {101, 51}, 99);
    EXPECT_EQ(settings.zoom.factor, PictureZoom::maxFactor);
    zoomPictures(settings, layout, {0, 0}, -1);
    EXPECT_EQ(settings.zoom.factor, PictureZoom::maxFactor) << "the mouse is elsewhere";
}

TEST(Panes, ToWindowIsTheInverseOfToPicture) {
    ViewSettings settings;
    showComparison(settings, {RendererKind::Fixed, RendererKind::Shader, RendererKind::Reference});
    settings.zoom = {4, {0.3F, 0.6F}};
    const Panes panes(layoutWith(settings), settings, picture);
    for (const Pane& pane : panes.all()) {
        const ImVec2 place(static_cast<float>(pane.frame.x) + 17, static_cast<float>(pane.frame.y) + 5);
        const ImVec2 back = panes.toWindow(pane, panes.toPicture(pane, place));
        EXPECT_NEAR(back.x, place.x, 0.01F);
        EXPECT_NEAR(back.y, place.y, 0.01F);
    }
}

} // namespace
} // namespace texplorer::ui::panes_test

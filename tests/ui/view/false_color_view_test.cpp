#include "app/ui/view/panes.h"
#include "tests/ui/workbench.h"

namespace texplorer::ui::false_color_view_test {
namespace {

using namespace test;
using reference::Shown;

class FalseColorView : public Workbench {
protected:
    [[nodiscard]] ImVec2 onTheCube() const {
        return {static_cast<float>(layout.picture.x) + static_cast<float>(layout.picture.width) * 0.3F,
                static_cast<float>(layout.picture.y) + static_cast<float>(layout.picture.height) * 0.5F};
    }
    void choose(std::string_view name) {
        click("shown");
        click("shown:" + std::string(name));
    }
};

TEST_F(FalseColorView, IsChosenInTheToolRowAndInTheMenu) {
    EXPECT_FALSE(has("false colors:legend"));
    EXPECT_EQ(session->look.levels.answer, nullptr) << "hidden panels request no work";
    choose("lambda");
    EXPECT_EQ(session->view.shown, Shown::Lambda);
    frames(2);
    EXPECT_TRUE(has("false colors:legend"));
    ASSERT_NE(session->look.levels.answer, nullptr);
    EXPECT_NE(session->look.levels.answer->colors, nullptr);
    choose("anisotropy");
    EXPECT_EQ(session->view.shown, Shown::Anisotropy);
    choose("picture");
    EXPECT_EQ(session->view.shown, Shown::Picture);
    frames(2);
    EXPECT_FALSE(has("false colors:legend"));
    EXPECT_EQ(session->look.levels.answer, nullptr);
    EXPECT_FALSE(session->document.history.canUndo()) << "to look is no edit";
    click("menu:View");
    click("menu:Picture or false colours");
    click("shown:lambda");
    EXPECT_EQ(session->view.shown, Shown::Lambda);
}

TEST_F(FalseColorView, TellsTheNumberUnderThePointerAndWhyThereIsNone) {
    choose("lambda");
    moveTo(onTheCube());
    EXPECT_TRUE(has("false colors:tip"));
    ASSERT_TRUE(session->look.levels.hovered);
    const Panes panes(layout, session->view, {layout.picture.width, layout.picture.height});
    const auto expected = panes.pixelAt(onTheCube());
    EXPECT_EQ(*session->look.levels.hovered, (reference::PixelPlace{expected->x, expected->y}));
    moveTo({static_cast<float>(layout.picture.x + 15), static_cast<float>(layout.picture.y + 15)});
    EXPECT_FALSE(has("false colors:tip")) << "nothing is drawn there";
    moveTo({5, 5});
    EXPECT_FALSE(session->look.levels.hovered);
    session->look.selection.unit = 2;
    frames(2);
    EXPECT_TRUE(has("false colors:none"));
    EXPECT_FALSE(has("false colors:legend"));
}

// Opaque parts have exactly the false colour of the pixel.
TEST_F(FalseColorView, LiesOverThePicture) {
    choose("lambda");
    moveTo({5, 5});
    session->view.opacity = 1;
    const Image window = picture();
    const auto& answer = session->look.levels.answer;
    ASSERT_TRUE(answer && answer->colors);
    const Image& colors = *answer->colors;
    ASSERT_EQ(colors.width, layout.picture.width);
    int compared = 0;
    for (int y = 100; y < colors.height; y += 7) {
        for (int x = 3; x < colors.width / 2; x += 7) {
            if (colors.at(x, y)[3] == std::byte{0})
                continue;
            ++compared;
            const auto found = window.at(layout.picture.x + x, window.height - layout.picture.bottom() + y);
            for (std::size_t i = 0; i < 3; ++i)
                EXPECT_EQ(found[i], colors.at(x, y)[i]) << x << ", " << y;
        }
    }
    EXPECT_GT(compared, 200);
}

TEST_F(FalseColorView, IsSoundInANarrowWindowAndBesideADifference) {
    start(defaultScene(), 720, 480);
    session->view.shown = Shown::Anisotropy;
    frames(3);
    expectSoundFrame();
    EXPECT_TRUE(has("shown")) << "it is never put away";
    showComparison(session->view);
    session->view.arrangement = Arrangement::Grid;
    frames(3);
    expectSoundFrame();
}

} // namespace
} // namespace texplorer::ui::false_color_view_test

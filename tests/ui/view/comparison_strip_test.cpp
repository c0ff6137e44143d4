#include "app/ui/view/pane_drawing.h"
#include "app/ui/view/panes.h"
#include "tests/ui/workbench.h"
#include "texplorer/compare/heat_map.h"

#include <gmock/gmock.h>

#include <array>
#include <cmath>

namespace texplorer::ui::comparison_strip_test {
namespace {

using namespace test;

class Comparison : public Workbench {
protected:
    Image window() {
        static_cast<void>(picture()); // the layout follows the arrangement with the next frame
        return picture();
    }
    /// What the window shows at a place, as red, green, blue.
    static std::array<int, 3> at(const Image& window, int x, int y) {
        const auto pixel = window.at(x, window.height - 1 - y);
        return {std::to_integer<int>(pixel[0]), std::to_integer<int>(pixel[1]),
                std::to_integer<int>(pixel[2])};
    }
};

TEST_F(Comparison, TheMenuBarAndAKeyLeadThereAndBack) {
    click("renderer:Compare");
    EXPECT_EQ(session->view.arrangement, Arrangement::Split);
    click("arrangement:Side by side");
    EXPECT_EQ(session->view.arrangement, Arrangement::Grid);
    click("renderer:Shader");
    EXPECT_EQ(session->view.arrangement, Arrangement::One);
    EXPECT_FALSE(has("arrangement:Split"));
    key('4');
    EXPECT_EQ(session->view.arrangement, Arrangement::Grid) << "as it was last";
    click("menu:View");
    click("menu:Compare");
    EXPECT_TRUE(isComparing(session->view));
}

TEST_F(Comparison, TheSeamIsDraggedAndTheCameraStays) {
    click("renderer:Compare");
    const View before = scene().view;
    drag(place("picture seam"), {100, 5});
    EXPECT_NEAR(session->view.split, 0.5F + 100 / static_cast<float>(layout.picture.width), 0.01F);
    drag(place("picture seam"), {-2000, 0});
    EXPECT_EQ(session->view.split, 0);
    drag(place("picture seam"), {60, 0});
    EXPECT_GT(session->view.split, 0.05F) << "it can be taken hold of at the edge";
    EXPECT_EQ(scene().view, before);
}

TEST_F(Comparison, ListsChooseTheTwo) {
    click("renderer:Compare");
    click("compared:1");
    click("compared:1=shader");
    EXPECT_THAT(session->view.compared, testing::ElementsAre(RendererKind::Fixed, RendererKind::Shader));
    click("arrangement:Side by side");
    click("compared:0");
    click("compared:0=reference");
    EXPECT_THAT(session->view.compared, testing::ElementsAre(RendererKind::Reference, RendererKind::Shader));
}

TEST_F(Comparison, EachSideOfTheSeamIsItsRenderersPicture) {
    start(defaultScene(), 900, 600);
    std::array<Image, 2> alone;
    showComparison(session->view);
    session->view.split = 0;
    alone[1] = window();
    session->view.split = 1;
    alone[0] = window();
    session->view.split = 0.5F;
    const Image both = window();
    const int seam = layout.picture.x + layout.picture.width / 2;
    for (int y = layout.picture.y + 70; y < layout.picture.bottom(); ++y) { // below the lists
        for (int x = layout.picture.x + 10; x < layout.picture.right() - 10; ++x) {
            if (std::abs(x - seam) > 10) {
                ASSERT_EQ(at(both, x, y), at(alone[x < seam ? 0 : 1], x, y)) << x << ", " << y;
            }
        }
    }
}

TEST_F(Comparison, TheGridShowsTheHeatMapOfTheTwo) {
    showComparison(session->view, {RendererKind::Fixed, RendererKind::Reference, RendererKind::Shader});
    const Image shown = window();
    const Panes panes(layout, session->view, {layout.picture.width, layout.picture.height});
    const Rect& fixed = panes.all()[0].frame;
    const Rect& reference = panes.all()[2].frame;
    const Rect& heat = panes.all()[3].frame;
    const auto differenceAt = [&](int x, int y) {
        const auto a = at(shown, fixed.x + x, fixed.y + y);
        const auto b = at(shown, reference.x + x, reference.y + y);
        int worst = 0;
        for (std::size_t c = 0; c < 3; ++c)
            worst = std::max(worst, std::abs(a[c] - b[c]));
        return worst;
    };
    glm::ivec2 worst(0); // has a ring around it
    int largest = 0;
    const int top = 70; // between the lists and the legend
    const int bottom = fixed.height - 65;
    for (int y = bottom - 1; y >= top; --y) {
        for (int x = 0; x < fixed.width; ++x) {
            if (differenceAt(x, y) > largest) {
                largest = differenceAt(x, y);
                worst = {x, y};
            }
        }
    }
    int different = 0;
    for (int y = top; y < bottom; ++y) {
        for (int x = 0; x < fixed.width; ++x) {
            if (std::hypot(x - worst.x, y - worst.y) < 14)
                continue;
            const int difference = differenceAt(x, y);
            different += difference > 0 ? 1 : 0;
            const auto expected = heatColor(static_cast<float>(difference), {session->view.tolerance, 255});
            ASSERT_EQ(at(shown, heat.x + x, heat.y + y),
                      (std::array<int, 3>{expected[0], expected[1], expected[2]}))
                << x << ", " << y;
        }
    }
    EXPECT_GT(different, 0) << "the reference rounds otherwise somewhere";
}

// A ring says that something is over the tolerance: a difference of one pixel is within one of 255.
TEST_F(Comparison, TheStripSaysHowFarTheyAreApartAndOnlyWhatIsOverTheToleranceIsRinged) {
    showComparison(session->view, {RendererKind::Fixed, RendererKind::Reference});
    for (const int tolerance : {2, ViewSettings::maxTolerance}) {
        session->view.tolerance = tolerance;
        static_cast<void>(window());
        for (const char* name : {"share over", "mean difference", "worst"})
            EXPECT_TRUE(has(name)) << name;
        EXPECT_EQ(has("ring"), tolerance == 2);
    }
    session->view.compared = {RendererKind::Fixed, RendererKind::Fixed};
    static_cast<void>(window());
    EXPECT_TRUE(has("equal"));
    EXPECT_FALSE(has("worst"));
}

// What is only noted, such as a border that the driver takes away, keeps no picture back.
TEST_F(Comparison, APictureThatIsStillToComeIsNotMissing) {
    showComparison(session->view, {RendererKind::Fixed, RendererKind::Reference});
    frames(2);
    const std::array notes{Sentence("textures[0]: drawn without its border")};
    std::vector<ViewFrame> frames;
    for (const RendererKind renderer : session->view.compared)
        frames.push_back({renderer, {{}, {100, 100}, 0, {}, false}, {}, renderer == RendererKind::Fixed});
    const Pictures coming{.frames = frames, .problems = notes};
    EXPECT_TRUE(isDrawing(coming, session->view.compared));
    EXPECT_FALSE(isDrawing(coming, std::array{RendererKind::Fixed}));
    frames[1].whole = true;
    EXPECT_FALSE(isDrawing(coming, session->view.compared));
}

TEST_F(Comparison, AllOfTheStripIsInSightInEveryWindow) {
    for (const auto& [width, height, language] :
         {std::tuple(1280, 800, Language::English), std::tuple(900, 600, Language::English),
          std::tuple(1920, 1080, Language::English), std::tuple(1280, 800, Language::Chinese),
          std::tuple(1280, 800, Language::Russian), std::tuple(1024, 700, Language::Russian)}) {
        start(defaultScene(), width, height);
        speak(language);
        showComparison(session->view, {RendererKind::Fixed, RendererKind::Reference});
        static_cast<void>(window());
        for (const char* name : {"arrangement:Split", "arrangement:Side by side", "tolerance", "share over",
                                 "mean difference", "worst"}) {
            const WidgetPlaces::Item& item = places.items.at(name);
            EXPECT_GE(item.left, static_cast<float>(layout.strip.x)) << name << width;
            EXPECT_LE(item.right, static_cast<float>(layout.strip.right())) << name << width;
            EXPECT_GE(item.top, static_cast<float>(layout.strip.y)) << name << width;
            EXPECT_LE(item.bottom, static_cast<float>(layout.strip.bottom())) << name << width;
        }
    }
}

} // namespace
} // namespace texplorer::ui::comparison_strip_test

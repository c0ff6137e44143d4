#include "app/ui/state/layout.h"
#include "app/ui/window/layout.h"
#include "tests/ui/window_sizes.h"

#include <gtest/gtest.h>

#include <ostream>

namespace texplorer::ui::layout_test {
namespace {

struct Case {
    const char* name;
    int width, height;
    float scale = 1;
    Workspace workspace = {};

    friend std::ostream& operator<<(std::ostream& out, const Case& c) { return out << c.name; }
};

class LayoutTest : public testing::TestWithParam<Case> {};

Workspace dragged(const Seams& seams) {
    Workspace workspace;
    workspace.seams = seams;
    return workspace;
}

/// The named layout of this number, with something maximised; the dock on the right then has a tab.
Workspace named(std::size_t layout, Maximised what = Maximised::None) {
    Workspace workspace = workspaceOf(layoutRows.at(layout));
    if (what == Maximised::Right)
        moveTab(workspace, Tab::Vertices, Dock::Right);
    workspace.maximised = what;
    return workspace;
}

struct Named {
    const char* name;
    Rect rect;
};

std::vector<Named> panels(const Layout& layout) {
    return {{"menu", layout.menu},
            {"parameters", layout.parameters},
            {"view", layout.view},
            {"texture", layout.texture},
            {"right dock", layout.rightDock},
            {"dock below", layout.belowDock},
            {"sheets", layout.sheets},
            {"status", layout.status},
            {"left seam", layout.leftSeam},
            {"right seam", layout.rightSeam},
            {"middle seam", layout.middleSeam},
            {"below seam", layout.belowSeam}};
}

Layout layoutOf(const Case& c) {
    return layoutFor(c.width, c.height, c.scale, c.workspace);
}

bool isFilled(const Layout& layout) {
    long long pixels = 0;
    bool inside = true;
    for (const Named& each : panels(layout)) {
        pixels += static_cast<long long>(each.rect.width) * each.rect.height;
        inside &= each.rect.x >= 0 && each.rect.y >= 0 && each.rect.right() <= layout.window.width &&
                  each.rect.bottom() <= layout.window.height && each.rect.width >= 0 && each.rect.height >= 0;
    }
    return inside && pixels == static_cast<long long>(layout.window.width) * layout.window.height;
}

TEST_P(LayoutTest, PanelsFillTheWindowAndDoNotOverlap) {
    EXPECT_TRUE(isFilled(layoutOf(GetParam())));
    const std::vector<Named> all = panels(layoutOf(GetParam()));
    for (const Named& a : all) {
        EXPECT_TRUE(a.rect == Rect{} || !a.rect.isEmpty()) << a.name;
        for (const Named& b : all) {
            const bool apart = a.rect.right() <= b.rect.x || b.rect.right() <= a.rect.x ||
                               a.rect.bottom() <= b.rect.y || b.rect.bottom() <= a.rect.y;
            EXPECT_TRUE(apart || a.name == b.name) << a.name << " and " << b.name;
        }
    }
}

TEST_P(LayoutTest, ThePictureIsInsideOfItsPanel) {
    const Layout layout = layoutOf(GetParam());
    if (layout.view.isEmpty())
        return;
    EXPECT_EQ(layout.picture.x, layout.view.x);
    EXPECT_EQ(layout.picture.width, layout.view.width);
    EXPECT_GE(layout.picture.y, layout.view.y);
    EXPECT_LE(layout.picture.bottom(), layout.view.bottom());
    EXPECT_GT(layout.picture.height, layout.view.height / 3);
}

INSTANTIATE_TEST_SUITE_P(
    Sizes, LayoutTest,
    testing::Values(Case{"Laptop", 1280, 800}, Case{"FullHd", 1920, 1080}, Case{"Desktop", 2560, 1440},
                    Case{"Tiny", 640, 400}, Case{"Smallest", 320, 200}, Case{"Retina", 2560, 1600, 2},
                    Case{"SmallWithLargeScale", 1280, 800, 3},
                    Case{"GreedyLeft", 1280, 800, 1, dragged({5000, 0, 0, 0})},
                    Case{"GreedyBoth", 1280, 800, 1, dragged({5000, 5000, 0.99F, 0.99F})},
                    Case{"Starved", 1280, 800, 1, dragged({1, 1, 0.01F, 0.01F})},
                    Case{"Teacher", 1280, 800, 1, named(1)}, Case{"TeacherSmall", 1024, 700, 1, named(1)},
                    Case{"Minimal", 1280, 800, 1, named(2)},
                    Case{"ViewMaximised", 1280, 800, 1, named(0, Maximised::View)},
                    Case{"TextureSpaceMaximised", 1280, 800, 1, named(0, Maximised::TextureSpace)},
                    Case{"RightMaximised", 1024, 700, 1.5F, named(0, Maximised::Right)},
                    Case{"BelowMaximised", 1024, 700, 1, named(0, Maximised::Below)}, Case{"Phone", 360, 740},
                    Case{"PhoneWithDensity", 1080, 2220, 3}, Case{"PhoneMinimal", 360, 740, 1, named(2)},
                    Case{"PhoneMaximised", 360, 740, 1, named(0, Maximised::Below)},
                    Case{"PhoneStarved", 360, 740, 1, dragged({1, 1, 0.01F, 0.99F})},
                    Case{"NothingToMaximise", 1280, 800, 1, named(1, Maximised::Below)}),
    [](const auto& test) { return test.param.name; });

TEST(Layout, OfEveryWorkspaceFillsWindowsOfEverySize) {
    for (const test::WindowSize& size : test::windowSizes) {
        for (const float scale : test::windowScales) {
            for (int bits = 0; bits < 16; ++bits) {
                for (const Maximised what : {Maximised::None, Maximised::View, Maximised::TextureSpace,
                                             Maximised::Right, Maximised::Below}) {
                    Workspace workspace;
                    workspace.parameters = (bits & 1) != 0;
                    workspace.textureSpace = (bits & 2) != 0;
                    for (TabPlace& place : workspace.tabs)
                        place.open = (bits & 8) != 0;
                    if ((bits & 4) != 0)
                        moveTab(workspace, Tab::Vertices, Dock::Right);
                    workspace.maximised = what;
                    const Layout layout = layoutFor(size.width, size.height, scale, workspace);
                    ASSERT_TRUE(isFilled(layout))
                        << size.width << " " << scale << " " << bits << " " << static_cast<int>(what);
                    EXPECT_GT(layout.picture.width, 1);
                    EXPECT_GT(layout.picture.height, 1);
                }
            }
        }
    }
}

TEST(Layout, TheDockBelowIsAsWideAsViewAndRightColumn) {
    const Layout layout = layoutFor(1280, 800, 1);
    EXPECT_EQ(layout.belowDock.x, layout.view.x);
    EXPECT_EQ(layout.belowDock.right(), layout.texture.right());
    EXPECT_EQ(layout.belowSeam.y, layout.view.bottom());
    EXPECT_EQ(layout.texture.bottom(), layout.view.bottom()) << "it has its column alone";
    EXPECT_TRUE(layout.rightDock.isEmpty());
    EXPECT_EQ(layout.texture.height, 464);
}

TEST(Layout, WhatIsClosedLeavesItsRoomToTheOthers) {
    const Layout teacher = layoutFor(1280, 800, 1, named(1));
    EXPECT_EQ(teacher.view.bottom(), teacher.status.y);
    EXPECT_EQ(teacher.texture.bottom(), teacher.status.y);
    EXPECT_TRUE(teacher.rightDock.isEmpty());
    EXPECT_TRUE(teacher.belowDock.isEmpty());
    const Layout minimal = layoutFor(1280, 800, 1, named(2));
    EXPECT_EQ(minimal.view, (Rect{0, 28, 1280, 744}));
    EXPECT_TRUE(minimal.parameters.isEmpty());
    EXPECT_TRUE(minimal.leftSeam.isEmpty());
}

TEST(Layout, WhatIsMaximisedFillsAllButTheParameters) {
    const Layout usual = layoutFor(1280, 800, 1);
    const Layout below = layoutFor(1280, 800, 1, named(0, Maximised::Below));
    EXPECT_EQ(below.parameters, usual.parameters);
    EXPECT_EQ(below.belowDock, (Rect{usual.view.x, 28, 1280 - usual.view.x, 744}));
    EXPECT_TRUE(below.view.isEmpty());
    EXPECT_EQ(below.picture, usual.picture) << "who explains a pixel of it goes on to do so";
    const Layout view = layoutFor(1280, 800, 1, named(0, Maximised::View));
    EXPECT_EQ(view.view, (Rect{0, 28, 1280, 744}));
}

TEST(Layout, OfAPhoneHasOneSheetBelowTheView) {
    const Layout layout = layoutFor(360, 740, 1);
    for (const Rect& each : {layout.view, layout.sheets, layout.parameters})
        EXPECT_EQ(each.width, 360);
    EXPECT_GT(layout.view.height, 250);
    EXPECT_EQ(layout.belowSeam.y, layout.view.bottom());
    EXPECT_EQ(layout.sheets.y, layout.belowSeam.bottom());
    EXPECT_EQ(layout.parameters.y, layout.sheets.bottom());
    EXPECT_GT(layout.parameters.height, 300);
    EXPECT_EQ(layout.parameters.bottom(), layout.status.y);
    for (const Rect& each : {layout.texture, layout.rightDock, layout.belowDock})
        EXPECT_TRUE(each.isEmpty());
    Workspace workspace;
    moveTab(workspace, Tab::Lesson, Dock::Right);
    EXPECT_EQ(layoutFor(360, 740, 1, workspace).rightDock, layout.parameters) << "the newest tab";
    EXPECT_TRUE(layoutFor(360, 740, 1, workspace).parameters.isEmpty());
    closeTab(workspace, Tab::Lesson);
    EXPECT_EQ(sheetOf(workspace), Panel::Parameters) << "no other tab is there";
    workspace.parameters = workspace.textureSpace = false;
    EXPECT_EQ(sheetOf(workspace), Panel::Below);
    for (const TabRow& row : tabRows)
        closeTab(workspace, row.tab);
    EXPECT_EQ(sheetOf(workspace), std::nullopt);
    EXPECT_EQ(layoutFor(740, 360, 1).view.bottom(), layoutFor(740, 360, 1).belowSeam.y)
        << "held across: columns";
    EXPECT_TRUE(layoutFor(740, 360, 1).sheets.isEmpty());
}

TEST(Layout, ColumnsKeepTheirDraggedWidthsAndGrowWithTheScale) {
    const Layout plain = layoutFor(1920, 1080, 1, dragged({400, 500, 0.5F, 0}));
    EXPECT_EQ(plain.parameters.width, 400);
    EXPECT_EQ(plain.texture.width, 500);
    const Layout twice = layoutFor(3840, 2160, 2, dragged({400, 500, 0.5F, 0}));
    EXPECT_EQ(twice.parameters.width, 800);
    EXPECT_EQ(twice.texture.width, 1000);
}

TEST(Layout, TheViewGetsMostOfALargerWindow) {
    const Layout small = layoutFor(1280, 800, 1);
    const Layout large = layoutFor(2560, 1440, 1);
    EXPECT_GT(large.view.width - small.view.width, (2560 - 1280) / 2);
}

TEST(Layout, TheViewIsNotTheSmallestPartOfASmallWindow) {
    const Layout layout = layoutFor(900, 600, 1);
    EXPECT_GT(layout.view.width, layout.parameters.width);
    EXPECT_GE(layout.view.width, 280);
    EXPECT_GE(layoutFor(1024, 768, 1).view.width, 400);
    EXPECT_EQ(layoutFor(900, 600, 1, dragged({316, 360, 0, 0})).view.width, 900 - 316 - 360 - 10)
        << "as the user wants it";
}

TEST(Layout, OfImpossibleSizesHasNoNegativeExtents) {
    for (const Layout& layout :
         {layoutFor(-5, -5, 1), layoutFor(0, 0, 1), layoutFor(1, 1, 1), layoutFor(2, 2, 1),
          layoutFor(7, 7, 1), layoutFor(100, 100, 0), layoutFor(100, 100, 1e9F)}) {
        SCOPED_TRACE(layout.window.width);
        for (const Named& each : panels(layout)) {
            EXPECT_GE(each.rect.width, 0) << each.name;
            EXPECT_GE(each.rect.height, 0) << each.name;
        }
        EXPECT_GE(layout.picture.width, 1);
        EXPECT_GE(layout.picture.height, 1);
    }
}

} // namespace
} // namespace texplorer::ui::layout_test

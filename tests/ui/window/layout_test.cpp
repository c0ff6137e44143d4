#include "app/ui/window/layout.h"

#include <gtest/gtest.h>

#include <ostream>

namespace texplorer::ui::layout_test {
namespace {

struct Case {
    const char* name;
    int width, height;
    float scale = 1;
    Columns columns = {};

    friend std::ostream& operator<<(std::ostream& out, const Case& c) { return out << c.name; }
};

class LayoutTest : public testing::TestWithParam<Case> {};

struct Named {
    const char* name;
    Rect rect;
};

std::vector<Named> panels(const Layout& layout) {
    return {{"menu", layout.menu},
            {"parameters", layout.parameters},
            {"view", layout.view},
            {"texture", layout.texture},
            {"details", layout.details},
            {"status", layout.status},
            {"left seam", layout.leftSeam},
            {"right seam", layout.rightSeam},
            {"middle seam", layout.middleSeam}};
}

Layout layoutOf(const Case& c) {
    return layoutFor(c.width, c.height, c.scale, c.columns);
}

TEST_P(LayoutTest, PanelsStayInTheWindowAndDoNotOverlap) {
    const std::vector<Named> all = panels(layoutOf(GetParam()));
    for (const Named& a : all) {
        EXPECT_GE(a.rect.x, 0) << a.name;
        EXPECT_GE(a.rect.y, 0) << a.name;
        EXPECT_GT(a.rect.width, 0) << a.name;
        EXPECT_GT(a.rect.height, 0) << a.name;
        EXPECT_LE(a.rect.right(), GetParam().width) << a.name;
        EXPECT_LE(a.rect.bottom(), GetParam().height) << a.name;
        for (const Named& b : all) {
            const bool apart = a.rect.right() <= b.rect.x || b.rect.right() <= a.rect.x ||
                               a.rect.bottom() <= b.rect.y || b.rect.bottom() <= a.rect.y;
            EXPECT_TRUE(apart || a.name == b.name) << a.name << " and " << b.name;
        }
    }
}

TEST_P(LayoutTest, PanelsLeaveNoPixelOut) {
    long long pixels = 0;
    for (const Named& each : panels(layoutOf(GetParam())))
        pixels += static_cast<long long>(each.rect.width) * each.rect.height;
    EXPECT_EQ(pixels, static_cast<long long>(GetParam().width) * GetParam().height);
}

TEST_P(LayoutTest, ThePictureIsInsideOfItsPanel) {
    const Layout layout = layoutOf(GetParam());
    EXPECT_EQ(layout.picture.x, layout.view.x);
    EXPECT_EQ(layout.picture.width, layout.view.width);
    EXPECT_GE(layout.picture.y, layout.view.y);
    EXPECT_LE(layout.picture.bottom(), layout.view.bottom());
    EXPECT_GT(layout.picture.height, layout.view.height / 3);
}

INSTANTIATE_TEST_SUITE_P(Sizes, LayoutTest,
                         testing::Values(Case{"Laptop", 1280, 800}, Case{"FullHd", 1920, 1080},
                                         Case{"Desktop", 2560, 1440}, Case{"Tiny", 640, 400},
                                         Case{"Smallest", 320, 200}, Case{"Retina", 2560, 1600, 2},
                                         Case{"SmallWithLargeScale", 1280, 800, 3},
                                         Case{"GreedyLeft", 1280, 800, 1, {5000, 0, 0}},
                                         Case{"GreedyBoth", 1280, 800, 1, {5000, 5000, 0.99F}},
                                         Case{"Starved", 1280, 800, 1, {1, 1, 0.01F}}),
                         [](const auto& test) { return test.param.name; });

TEST(Layout, ColumnsKeepTheirDraggedWidthsAndGrowWithTheScale) {
    const Layout plain = layoutFor(1920, 1080, 1, {400, 500, 0.5F});
    EXPECT_EQ(plain.parameters.width, 400);
    EXPECT_EQ(plain.texture.width, 500);
    const Layout twice = layoutFor(3840, 2160, 2, {400, 500, 0.5F});
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
    EXPECT_EQ(layoutFor(900, 600, 1, {316, 360, 0}).view.width, 900 - 316 - 360 - 10)
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

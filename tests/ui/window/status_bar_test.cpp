#include "app/ui/window/window_parts.h"
#include "tests/ui/workbench.h"

namespace texplorer::status_bar_test {
namespace {

using namespace ui;

class StatusBar : public test::Workbench {
protected:
    [[nodiscard]] const WidgetPlaces::Item& item(std::string_view name) {
        EXPECT_TRUE(has(name)) << name;
        return places.items.find(name)->second;
    }
};

TEST_F(StatusBar, TheConsequenceIsFirstAndTheDriverLast) {
    session->look.explaining.pixel = {layout.picture.width / 2, layout.picture.height / 2};
    frames(3);
    const WidgetPlaces::Item& consequence = item("consequence");
    const WidgetPlaces::Item& driver = item("status");
    EXPECT_LT(consequence.left, 20);
    EXPECT_LT(consequence.right, driver.left);
    EXPECT_NEAR(driver.right, static_cast<float>(layout.status.right()), 20);
}

TEST_F(StatusBar, WhatIsWrongGoesBeforeTheConsequence) {
    texture().mipmaps = MipPolicy::None;
    texture().minFilter = MinFilter::NearestMipmapLinear;
    session->look.explaining.pixel = {layout.picture.width / 2, layout.picture.height / 2};
    frames(3);
    EXPECT_TRUE(has("finding"));
    EXPECT_FALSE(has("consequence"));
    ASSERT_FALSE(session->document.findings.empty());
    ASSERT_FALSE(session->document.findings.front().fixes.empty());
    click("fix:" + session->document.findings.front().fixes.front().label.english());
    frames(3);
    EXPECT_FALSE(has("finding"));
    EXPECT_TRUE(has("consequence"));
}

TEST_F(StatusBar, WithoutAPixelItSaysWhatWasChanged) {
    EXPECT_TRUE(has("state"));
    EXPECT_FALSE(has("consequence"));
}

TEST_F(StatusBar, TheHintStandsBetweenBoth) {
    moveTo(place("play"));
    frames(2);
    const WidgetPlaces::Item& hint = item("hint");
    EXPECT_GT(hint.left, item("state").right);
    EXPECT_LT(hint.right, item("status").left);
}

TEST_F(StatusBar, WhatWasDoneIsSaidUntilItIsDismissed) {
    session->look.notice = {.text = "Written", .file = {}, .isGood = true};
    frames(2);
    EXPECT_TRUE(has("notice"));
    click("dismiss notice");
    EXPECT_FALSE(has("notice"));
}

TEST_F(StatusBar, FitsIntoEveryWindow) {
    for (const int width : {320, 640, 1024, 3840}) {
        start(defaultScene(), width, 480);
        session->look.notice = {.text = std::string(300, 'x'), .file = "/a", .isGood = false};
        frames(3);
        expectSoundFrame();
        EXPECT_LE(item("notice").right, item("status").left) << width;
    }
}

} // namespace
} // namespace texplorer::status_bar_test

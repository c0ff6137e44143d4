#include "app/ui/model/explaining.h"
#include "app/ui/widgets/keys.h"
#include "tests/ui/workbench.h"

namespace texplorer::ui::pixel_keys_test {
namespace {

using namespace test;
using reference::PixelPlace;

class PixelKeys : public Workbench {
protected:
    PixelKeys() {
        session->look.explaining.pixel = {100, 100};
        moveTo(middleOf(layout.view));
    }
    static ImVec2 middleOf(const Rect& rect) {
        return {static_cast<float>(rect.x + rect.width / 2), static_cast<float>(rect.y + rect.height / 2)};
    }
    [[nodiscard]] PixelPlace pixel() const { return session->look.explaining.pixel.value(); }
};

TEST_F(PixelKeys, MoveThePixelThatIsExplained) {
    key(key::right);
    EXPECT_EQ(pixel(), (PixelPlace{101, 100}));
    key(key::up);
    EXPECT_EQ(pixel(), (PixelPlace{101, 101})) << "counted from the lower left";
    key(key::left, {shift});
    EXPECT_EQ(pixel(), (PixelPlace{91, 101}));
    moveTo(middleOf(layout.belowDock));
    key(key::down, {shift});
    EXPECT_EQ(pixel(), (PixelPlace{91, 91}));
    EXPECT_EQ(explanationOf(*session)->pixel, pixel());
}

TEST_F(PixelKeys, KeepItInThePicture) {
    session->look.explaining.pixel = {3, layout.picture.height - 2};
    key(key::left, {shift});
    key(key::up, {shift});
    EXPECT_EQ(pixel(), (PixelPlace{0, layout.picture.height - 1}));
}

TEST_F(PixelKeys, BelongToOthersElsewhere) {
    for (const Rect& other : {layout.parameters, layout.texture}) {
        moveTo(middleOf(other));
        key(key::right);
    }
    EXPECT_EQ(pixel(), (PixelPlace{100, 100}));
    closeTab(session->settings.workspace, Tab::Explain);
    moveTo(middleOf(layout.view));
    key(key::right);
    EXPECT_EQ(pixel(), (PixelPlace{100, 100})) << "Explain is closed";
}

TEST_F(PixelKeys, GoWithWhatWasUsedLastWhereThePointerIsOverNothing) {
    clickAt(middleOf(layout.view));
    const PixelPlace clicked = pixel();
    moveTo({-100, -100});
    key(key::right);
    EXPECT_EQ(pixel(), (PixelPlace{clicked.x + 1, clicked.y}));
}

} // namespace
} // namespace texplorer::ui::pixel_keys_test

// A window manager may make the window smaller than it asks for: nothing fits, and nothing may break.

#include "app/ui/state/min_window_size.h"
#include "tests/ui/workbench.h"

namespace texplorer::ui::tiny_window_test {
namespace {

using namespace test;

class TinyWindow : public Workbench {
protected:
    void draw(int count) {
        frames(count);
        expectSoundFrame();
    }
    void tryAll(int width, int height) {
        SCOPED_TRACE(std::to_string(width) + " x " + std::to_string(height));
        start(defaultScene(), width, height);
        session->look.selection.vertex = 3;
        session->look.explaining.pixel = {0, 0};
        session->view.magnifies = true;
        session->window.showRq = true;
        texture().mipmaps = MipPolicy::None; // something to say in the status bar
        unit().envMode = EnvMode::Combine;
        unit().matrix = {{MatrixOp::Scale, {1, 0, 1}}};
        ImGui::GetIO().MousePos = {static_cast<float>(width) / 2, static_cast<float>(height) / 2};
        for (const TabRow& tab : tabRows) {
            session->window.wantedTab = tab.tab;
            for (const SectionRow& section : sectionRows) {
                session->out.wantedSection = section.section;
                draw(1);
            }
            draw(2);
        }
        for (const bool compares : {false, true}) {
            if (compares)
                showComparison(session->view,
                               {RendererKind::Fixed, RendererKind::Shader, RendererKind::Reference});
            draw(2);
        }
        session->asking.refused = {{ErrorCode::NotFound, "is not there", "a.bmp"}};
        for (const Dialog dialog : {Dialog::OpenScene, Dialog::OpenImage, Dialog::SaveScene,
                                    Dialog::SaveAnswers, Dialog::Discard, Dialog::Help, Dialog::Refused}) {
            session->asking.dialog = dialog;
            draw(2);
        }
    }
};

TEST_F(TinyWindow, BreaksNothing) {
    for (const int width : {1, 2, 3, 8, 31, 33, 64, 150, minWindowSize.width})
        tryAll(width, minWindowSize.height);
    for (const int height : {1, 2, 3, 4, 8, 31, 57, 100})
        tryAll(minWindowSize.width, height);
    for (const int side : {1, 2, 5, 17, 60})
        tryAll(side, side);
}

TEST_F(TinyWindow, OfNoExtentAtAllBreaksNothing) {
    tryAll(0, 0);
    tryAll(0, 300);
    tryAll(300, 0);
}

TEST_F(TinyWindow, IsCoveredByItsPanels) {
    for (const int side : {1, 2, 40}) {
        start(defaultScene(), side, side);
        EXPECT_EQ(pixelsOfNoPanel(picture()), 0) << side;
    }
}

} // namespace
} // namespace texplorer::ui::tiny_window_test

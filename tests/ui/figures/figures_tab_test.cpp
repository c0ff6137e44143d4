#include "tests/ui/figures/figure_bench.h"
#include "texplorer/lesson/example.h"

namespace texplorer::ui::figures_tab_test {
namespace {

using namespace test;

class FiguresTab : public FigureBench {};

TEST_F(FiguresTab, AClickOnItsNameChoosesAFigure) {
    show(Figure::Environments);
    for (const FigureRow& row : figureRows) {
        click(fmt::format("figure:{}", row.name));
        frames(2);
        EXPECT_EQ(session->window.figure, row.figure) << row.name;
    }
}

struct Shown {
    Figure figure;
    const char* item; ///< a part of it
    Scene scene = defaultScene();
};

TEST_F(FiguresTab, EachFitsWhateverRoomItHas) {
    for (const Shown& each :
         {Shown{Figure::Edge, "edge:lens"}, Shown{Figure::Upload, "upload:texels"},
          Shown{Figure::Objects, "objects:gen"}, Shown{Figure::Cost, "cost:measure"},
          Shown{Figure::Emboss, "emboss:heights", *exampleScene("nehe-bumps-2-units.json")}}) {
        for (const auto& [width, height, scale] :
             {std::tuple(1280, 800, 1.0F), {1024, 700, 1.5F}, {700, 500, 2.0F}}) {
            start(each.scene, width, height, scale);
            show(each.figure);
            EXPECT_TRUE(has(each.item));
            expectSoundFrame();
        }
    }
    for (const Figure figure : {Figure::Environments, Figure::Sheet}) {
        for (const float scale : {0.75F, 1.0F, 2.5F}) {
            start(defaultScene(), 1024, 700, scale);
            moveTab(session->settings.workspace, Tab::Figures, Dock::Right);
            show(figure);
            expectSoundFrame();
        }
    }
}

} // namespace
} // namespace texplorer::ui::figures_tab_test

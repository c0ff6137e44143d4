#include "tests/ui/workbench.h"

#include <fmt/core.h>

namespace texplorer::ui::figures_tab_test {
namespace {

using namespace test;

class FiguresTab : public Workbench {};

TEST_F(FiguresTab, AClickOnItsNameChoosesAFigure) {
    session->window.wantedTab = Tab::Figures;
    frames(3);
    for (const FigureRow& row : figureRows) {
        click(fmt::format("figure:{}", row.name));
        frames(2);
        EXPECT_EQ(session->window.figure, row.figure) << row.name;
    }
}

} // namespace
} // namespace texplorer::ui::figures_tab_test

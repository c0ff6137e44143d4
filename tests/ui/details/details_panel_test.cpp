#include "app/ui/state/layout.h"
#include "app/ui/widgets/keys.h"
#include "tests/ui/workbench.h"

namespace texplorer::ui::details_panel_test {
namespace {

using namespace test;

class Docks : public Workbench {
protected:
    [[nodiscard]] Workspace& workspace() { return session->settings.workspace; }
    void doubleClick(std::string_view name) { doubleClickAt(place(name)); }
    /// Chooses in the menu View.
    void choose(std::initializer_list<const char*> items) {
        click("menu:View");
        for (const std::string item : items)
            click("menu:" + item);
    }
};

TEST_F(Docks, AClickBringsATabToTheFront) {
    ASSERT_TRUE(isShown(workspace(), Tab::Explain));
    click("tab:Memory");
    EXPECT_EQ(frontOf(workspace(), Dock::Below), Tab::Memory);
    EXPECT_FALSE(has("explain:none"));
    click("tab:Explain");
    EXPECT_TRUE(has("explain:none"));
}

TEST_F(Docks, AWantedTabIsOpenedWhereItLies) {
    closeTab(workspace(), Tab::Memory);
    frames(2);
    EXPECT_FALSE(has("tab:Memory"));
    session->window.wantedTab = Tab::Memory;
    frames(3);
    EXPECT_TRUE(has("tab:Memory"));
    EXPECT_TRUE(isShown(workspace(), Tab::Memory));
    EXPECT_TRUE(layout.belowDock.contains(place("tab:Memory").x, place("tab:Memory").y));
}

TEST_F(Docks, TheMenuOfATabMovesIt) {
    click("tab:Explain", ImGuiMouseButton_Right);
    click("menu:On the right");
    EXPECT_EQ(dockOf(workspace(), Tab::Explain), Dock::Right);
    EXPECT_EQ(frontOf(workspace(), Dock::Right), Tab::Explain);
    EXPECT_TRUE(layout.rightDock.contains(place("tab:Explain").x, place("tab:Explain").y));
    click("tab:Explain", ImGuiMouseButton_Right);
    click("menu:Closed");
    EXPECT_FALSE(isOpen(workspace(), Tab::Explain));
    EXPECT_FALSE(has("tab:Explain"));
}

TEST_F(Docks, ATabThatIsDraggedToTheOtherDockFallsThere) {
    putListRight();
    const ImVec2 from = place("tab:Memory");
    const ImVec2 to(static_cast<float>(layout.rightDock.x + layout.rightDock.width / 2),
                    static_cast<float>(layout.rightDock.y + layout.rightDock.height / 2));
    drag(from, {to.x - from.x, to.y - from.y});
    EXPECT_EQ(dockOf(workspace(), Tab::Memory), Dock::Right);
    EXPECT_TRUE(isShown(workspace(), Tab::Memory));
    drag(place("tab:Memory"), {-300, -200}); // onto the view: nothing is there
    EXPECT_EQ(dockOf(workspace(), Tab::Memory), Dock::Right);
}

TEST_F(Docks, ATabCanBeDraggedIntoADockThatIsNotThere) {
    for (const TabRow& row : tabRows) {
        if (dockOf(workspace(), row.tab) == Dock::Below)
            moveTab(workspace(), row.tab, Dock::Right);
    }
    frames(3);
    ASSERT_TRUE(layout.belowDock.isEmpty());
    const ImVec2 from = place("tab:Memory");
    drag(from, {500 - from.x, 700 - from.y});
    EXPECT_EQ(dockOf(workspace(), Tab::Memory), Dock::Below);
    EXPECT_FALSE(layout.belowDock.isEmpty());
}

TEST_F(Docks, ADoubleClickOnATabMaximisesAndTheNextRestores) {
    doubleClick("tab:Explain");
    EXPECT_EQ(layout.belowDock.y, layout.menu.bottom());
    EXPECT_EQ(layout.belowDock.bottom(), layout.status.y);
    EXPECT_FALSE(has("view"));
    EXPECT_FALSE(has("texture space"));
    EXPECT_EQ(pixelsOfNoPanel(picture()), 0);
    doubleClick("tab:Explain");
    EXPECT_TRUE(has("view"));
    doubleClick("tab:Explain");
    key(key::escape);
    EXPECT_TRUE(has("view"));
}

TEST_F(Docks, ButtonsMaximiseCloseAndOpen) {
    putListRight();
    click("maximise:right");
    EXPECT_EQ(maximisedOf(workspace()), Maximised::Right);
    click("maximise:right");
    EXPECT_EQ(maximisedOf(workspace()), Maximised::None);
    click("close:below");
    EXPECT_FALSE(isOpen(workspace(), Tab::Explain));
    click("panels:right");
    click("menu:Explain");
    EXPECT_EQ(dockOf(workspace(), Tab::Explain), Dock::Right);
    EXPECT_TRUE(isShown(workspace(), Tab::Explain));
    click("tab:Explain", ImGuiMouseButton_Middle);
    EXPECT_FALSE(isOpen(workspace(), Tab::Explain));
}

TEST_F(Docks, OneWithoutOpenTabsLeavesItsRoom) {
    const int height = layout.view.height;
    for (const TabRow& row : tabRows)
        closeTab(workspace(), row.tab);
    frames(3);
    EXPECT_GT(layout.view.height, height);
    EXPECT_EQ(layout.texture.bottom(), layout.status.y);
    EXPECT_EQ(pixelsOfNoPanel(picture()), 0);
}

TEST_F(Docks, TheSeamAboveTheDockIsDraggedAndGivenBack) {
    const int height = layout.belowDock.height;
    drag(place("below seam"), {0, -60});
    EXPECT_NEAR(layout.belowDock.height, height + 60, 1);
    doubleClick("below seam");
    EXPECT_EQ(layout.belowDock.height, height);
}

TEST_F(Docks, LayoutsAreChosenInTheMenu) {
    choose({"Layout", "Teacher"});
    EXPECT_EQ(layoutOf(workspace())->name, "teacher");
    EXPECT_TRUE(layout.belowDock.isEmpty());
    EXPECT_FALSE(layout.texture.isEmpty());
    choose({"Layout", "Minimal"});
    EXPECT_EQ(layout.view.width, layout.window.width);
    EXPECT_EQ(pixelsOfNoPanel(picture()), 0);
    choose({"Panels", "Parameters"});
    EXPECT_FALSE(layout.parameters.isEmpty());
}

TEST_F(Docks, TheTextureSpaceIsMaximisedAndClosed) {
    putListRight();
    choose({"Panels", "Texture space", "Maximised"});
    EXPECT_EQ(layout.texture.height, layout.parameters.height);
    key(key::escape);
    EXPECT_LT(layout.texture.height, layout.parameters.height);
    workspace().textureSpace = false;
    frames(2);
    EXPECT_TRUE(layout.texture.isEmpty());
    EXPECT_FALSE(has("texture space"));
    EXPECT_EQ(layout.rightDock.y, layout.menu.bottom());
}

TEST_F(Docks, WhatIsWantedOfTheParametersOpensThem) {
    workspace() = workspaceOf(layoutRows[2]);
    frames(2);
    session->out.wantedSection = Section::Matrix;
    frames(2);
    EXPECT_FALSE(layout.parameters.isEmpty());
}

} // namespace
} // namespace texplorer::ui::details_panel_test

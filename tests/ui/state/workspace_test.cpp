#include "app/ui/state/workspace.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>

namespace texplorer::ui::workspace_test {
namespace {

TEST(Workspace, BeginsAsForAStudent) {
    const Workspace workspace;
    ASSERT_NE(layoutOf(workspace), nullptr);
    EXPECT_EQ(layoutOf(workspace)->name, "student");
    EXPECT_TRUE(isShown(workspace, Tab::Explain));
    EXPECT_EQ(dockOf(workspace, Tab::Explain), Dock::Below);
    for (const TabRow& row : tabRows)
        EXPECT_EQ(dockOf(workspace, row.tab), row.tab == Tab::Lesson ? Dock::Right : Dock::Below)
            << row.label;
    EXPECT_FALSE(isOpen(workspace, Tab::Lesson)) << "until one is chosen";
    EXPECT_FALSE(frontOf(workspace, Dock::Right)) << "the right column is texture space's";
}

TEST(Workspace, ATabIsShownWhereItLies) {
    Workspace workspace;
    showTab(workspace, Tab::Memory);
    EXPECT_TRUE(isShown(workspace, Tab::Memory));
    EXPECT_FALSE(isShown(workspace, Tab::Explain));
    moveTab(workspace, Tab::Vertices, Dock::Right);
    moveTab(workspace, Tab::Memory, Dock::Right);
    EXPECT_EQ(frontOf(workspace, Dock::Right), Tab::Memory);
    EXPECT_NE(frontOf(workspace, Dock::Below), Tab::Memory);
    closeTab(workspace, Tab::Memory);
    EXPECT_FALSE(isShown(workspace, Tab::Memory));
    EXPECT_TRUE(frontOf(workspace, Dock::Right)) << "another one comes to the front";
    showTab(workspace, Tab::Memory);
    EXPECT_EQ(frontOf(workspace, Dock::Right), Tab::Memory) << "it opens where it was";
}

TEST(Workspace, ADockWithoutTabsIsNotThere) {
    Workspace workspace = workspaceOf(layoutRows[1]);
    EXPECT_FALSE(frontOf(workspace, Dock::Right));
    EXPECT_FALSE(frontOf(workspace, Dock::Below));
    toggleMaximised(workspace, Maximised::Below);
    EXPECT_EQ(maximisedOf(workspace), Maximised::None) << "there is nothing to maximise";
}

TEST(Workspace, WhatIsMaximisedHidesTheOthersUntilOneIsAskedFor) {
    Workspace workspace;
    toggleMaximised(workspace, Maximised::Below);
    EXPECT_EQ(maximisedOf(workspace), Maximised::Below);
    EXPECT_TRUE(isShown(workspace, Tab::Explain));
    moveTab(workspace, Tab::Vertices, Dock::Right);
    toggleMaximised(workspace, Maximised::Below);
    EXPECT_FALSE(isShown(workspace, Tab::Vertices));
    showTab(workspace, Tab::Memory);
    EXPECT_EQ(maximisedOf(workspace), Maximised::Below) << "it is in the same dock";
    showTab(workspace, Tab::Vertices);
    EXPECT_EQ(maximisedOf(workspace), Maximised::None);
    toggleMaximised(workspace, Maximised::TextureSpace);
    toggleMaximised(workspace, Maximised::TextureSpace);
    EXPECT_EQ(maximisedOf(workspace), Maximised::None);
}

TEST(Workspace, IsNoNamedLayoutOnceATabIsClosed) {
    for (const LayoutRow& row : layoutRows) {
        Workspace workspace = workspaceOf(row);
        workspace.seams.below = 0.5F;
        ASSERT_NE(layoutOf(workspace), nullptr) << row.name;
        EXPECT_EQ(layoutOf(workspace)->name, row.name);
        moveTab(workspace, Tab::Explain, Dock::Right);
        EXPECT_EQ(layoutOf(workspace), nullptr) << row.name;
    }
}

TEST(Workspace, IsTheSameAfterItWasWrittenAndRead) {
    for (const LayoutRow& row : layoutRows) {
        Workspace workspace = workspaceOf(row);
        moveTab(workspace, Tab::Memory, Dock::Right);
        closeTab(workspace, Tab::File);
        workspace.seams = {300.5F, 400, 0.25F, 0.75F};
        EXPECT_EQ(parseWorkspace(writeWorkspace(workspace)), workspace) << row.name;
    }
}

TEST(Workspace, WhatJsonLeavesOutIsAsAtTheStart) {
    EXPECT_EQ(parseWorkspace("{}"), Workspace{});
    EXPECT_EQ(parseWorkspace(R"({"tabs": {"of another version": {"dock": "left"}}, "unknown": [1]})"),
              Workspace{});
    const std::optional<Workspace> read = parseWorkspace(
        R"({"parameters": false, "tabs": {"memory": {"dock": "right"}}, "seams": {"split": 0.5}})");
    ASSERT_TRUE(read);
    EXPECT_FALSE(read->parameters);
    EXPECT_TRUE(isOpen(*read, Tab::Memory));
    EXPECT_EQ(dockOf(*read, Tab::Memory), Dock::Right);
    EXPECT_EQ(read->seams.split, 0.5F);
}

TEST(Workspace, IsRefusedAsAWhole) {
    for (const char* json :
         {"{", "[]", R"({"textureSpace": 1})", R"({"tabs": [[[]]]})", R"({"tabs": {"file": "right"}})",
          R"({"tabs": {"file": {"dock": "left"}}})", R"({"tabs": {"file": {"open": null}}})",
          R"({"front": {"right": 3}})", R"({"seams": {"details": -1}})", R"({"seams": {"below": 1.5}})",
          R"({"seams": {"split": "half"}})"})
        EXPECT_EQ(parseWorkspace(json), std::nullopt) << json;
    const std::string deep = R"({"tabs": )" + std::string(20000, '[') + std::string(20000, ']') + "}";
    EXPECT_EQ(parseWorkspace(deep), std::nullopt);
}

TEST(Layouts, KeepALessonThatIsOpen) {
    for (const LayoutRow& row : layoutRows) {
        Workspace workspace;
        moveTab(workspace, Tab::Lesson, Dock::Below);
        chooseLayout(workspace, row);
        EXPECT_TRUE(isShown(workspace, Tab::Lesson)) << row.name;
        EXPECT_EQ(dockOf(workspace, Tab::Lesson), Dock::Below) << row.name;
        ASSERT_TRUE(layoutOf(workspace)) << row.name;
        EXPECT_EQ(layoutOf(workspace)->name, row.name);
        closeTab(workspace, Tab::Lesson);
        chooseLayout(workspace, row);
        EXPECT_FALSE(isOpen(workspace, Tab::Lesson)) << row.name;
    }
}

} // namespace
} // namespace texplorer::ui::workspace_test

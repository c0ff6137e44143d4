// The examples of core/lesson/example in the window.

#include "app/ui/model/findings.h"
#include "tests/ui/workbench.h"
#include "texplorer/lesson/example.h"

#include <gmock/gmock.h>

#include <algorithm>

namespace texplorer::ui::examples_test {
namespace {

using namespace test;

class Examples : public Workbench {};

TEST_F(Examples, EveryFileHasARowAndEveryRowAFile) {
    std::vector<std::string_view> files;
    for (const ExampleFile& file : exampleFiles())
        files.push_back(file.name);
    std::vector<std::string_view> rows;
    for (const Example& example : examples())
        rows.push_back(example.file);
    EXPECT_THAT(rows, testing::UnorderedElementsAreArray(files));
}

/// Examples must not contain mistakes.
TEST_F(Examples, NothingIsWrongWithThem) {
    for (const Example& example : examples()) {
        const Result<Scene> scene = exampleScene(example.file);
        ASSERT_TRUE(scene) << example.file << ": " << describe(scene.error());
        for (const Finding& finding : diagnose(*scene, ImageSource{}))
            EXPECT_GE(finding.severity, Severity::Note)
                << example.file << ": " << finding.path << ": " << finding.sentence;
    }
}

TEST_F(Examples, AreDrawnByTheWindow) {
    for (const Example& example : examples()) {
        SCOPED_TRACE(example.file);
        start(*exampleScene(example.file));
        static_cast<void>(picture()); // expects no message from a renderer
        expectSoundFrame();
    }
}

TEST_F(Examples, OpenFromTheFileMenu) {
    click("menu:File");
    click("menu:Examples");
    click("menu:Spiral line");
    ASSERT_EQ(scene().models.size(), 1U);
    EXPECT_EQ(scene().models[0].mesh.primitive, Primitive::LineStrip);
    EXPECT_TRUE(session->document.file.empty()) << "Save asks for a name";
    EXPECT_FALSE(session->document.history.canUndo());
}

TEST_F(Examples, AskAboutUnsavedChangesFirst) {
    scrollTo("passes[0].units[0].enabled");
    click("passes[0].units[0].enabled");
    const Scene mine = scene();
    click("menu:File");
    click("menu:Examples");
    click("menu:Spiral line");
    EXPECT_EQ(session->asking.dialog, Dialog::Discard);
    EXPECT_EQ(scene(), mine);
}

TEST_F(Examples, WhatDoesNotExistIsSaid) {
    const Result<Scene> scene = exampleScene("none.json");
    ASSERT_FALSE(scene);
    EXPECT_EQ(scene.error().code, ErrorCode::NotFound);
}

} // namespace
} // namespace texplorer::ui::examples_test

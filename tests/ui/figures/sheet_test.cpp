#include "app/ui/files/texshot_command.h"
#include "app/ui/model/preview.h"
#include "app/ui/model/sheet_choice.h"
#include "app/ui/widgets/keys.h"
#include "tests/support/temp_dir.h"
#include "tests/ui/edits.h"
#include "tests/ui/figures/figure_bench.h"

namespace texplorer::ui::sheet_test {
namespace {

using namespace test;

class Sheet : public FigureBench {
protected:
    Sheet() {
        start(defaultScene(), 1920, 1600);
        session->settings.workspace.seams.below = 0.7F; // no cell has to be scrolled to
        show(Figure::Sheet);
    }

    void write(std::string_view field, std::string_view values) {
        click(field);
        key('A', {ctrl});
        type(values);
        key(key::enter);
        frames(2);
    }
    void choosePair(std::string_view name) {
        click("sheet:pair");
        frames(2);
        click(name);
        frames(2);
    }
};

TEST_F(Sheet, BeginsWithTheFilterLaboratory) {
    for (const char* filter :
         {"GL_NEAREST", "GL_LINEAR", "GL_NEAREST_MIPMAP_NEAREST", "GL_LINEAR_MIPMAP_NEAREST",
          "GL_NEAREST_MIPMAP_LINEAR", "GL_LINEAR_MIPMAP_LINEAR"})
        for (const char* anisotropy : {"1", "2", "4", "8", "16"})
            EXPECT_TRUE(has(fmt::format("sheet cell:{},{}", anisotropy, filter)));
    EXPECT_TRUE(has("sheet:own"));
}

TEST_F(Sheet, AClickTakesBothValuesInOneStep) {
    const Scene before = scene();
    const std::size_t step = steps();
    click("sheet cell:2,GL_NEAREST");
    EXPECT_EQ(texture().minFilter, MinFilter::Nearest);
    EXPECT_EQ(texture().maxAnisotropy, 2);
    EXPECT_EQ(steps(), step + 1);
    take(*session, Undo{});
    EXPECT_EQ(scene(), before);
}

TEST_F(Sheet, TheViewShowsTheCellUnderThePointer) {
    moveTo(place("sheet cell:2,GL_LINEAR"));
    frames(2);
    EXPECT_EQ(shownScene(*session).textures[0].minFilter, MinFilter::Linear);
    EXPECT_EQ(shownScene(*session).textures[0].maxAnisotropy, 2);
    EXPECT_EQ(texture().maxAnisotropy, 1);
    moveTo(place("view"));
    frames(2);
    EXPECT_FALSE(session->look.preview);
}

TEST_F(Sheet, HasOtherPairs) {
    choosePair("sheet pair:environments");
    EXPECT_TRUE(has("sheet cell:GL_DECAL,GL_INTENSITY"));
    choosePair("sheet pair:wraps");
    click("sheet cell:GL_REPEAT,GL_CLAMP_TO_EDGE");
    EXPECT_EQ(texture().wrapS, Wrap::ClampToEdge) << "s goes across";
    EXPECT_EQ(texture().wrapT, Wrap::Repeat);
    click("sheet:swap");
    frames(2);
    click("sheet cell:GL_REPEAT,GL_CLAMP_TO_EDGE");
    EXPECT_EQ(texture().wrapS, Wrap::Repeat);
    EXPECT_EQ(texture().wrapT, Wrap::ClampToEdge);
}

TEST_F(Sheet, TakesAnyParameterAndItsValues) {
    click("sheet:Rows");
    frames(2);
    type("bias");
    frames(2);
    click("sheet offer:textures[0].lodBias");
    frames(2);
    EXPECT_TRUE(has("sheet cell:-2,GL_LINEAR")) << "a few around the current one";
    write("sheet values:Rows", "0..1/3");
    EXPECT_TRUE(has("sheet cell:0.5,GL_LINEAR"));
    EXPECT_FALSE(has("sheet cell:-2,GL_LINEAR"));
    click("sheet cell:0.5,GL_LINEAR");
    EXPECT_EQ(texture().lodBias, 0.5F);
}

TEST_F(Sheet, SaysWhatItCantShow) {
    write("sheet values:Rows", "0..4/5");
    EXPECT_TRUE(has("sheet:problem")) << "anisotropy begins with 1";
    write("sheet values:Rows", "1..16/16");
    EXPECT_FALSE(has("sheet:problem"));
    EXPECT_TRUE(has("sheet:too many"));
    EXPECT_TRUE(has("sheet cell:8,GL_NEAREST"));
    EXPECT_FALSE(has("sheet cell:9,GL_NEAREST"));
}

TEST_F(Sheet, TakesTwoParametersThatArePickedInThePanel) {
    session->settings.workspace = {};
    session->window.figure = Figure::Block;
    open("Texture");
    scrollTo("textures[0].wrapS#label");
    click("textures[0].wrapS#label", ImGuiMouseButton_Right);
    frames(2);
    click("textures[0].wrapS#menu:rows");
    frames(3);
    EXPECT_TRUE(isShown(session->settings.workspace, Tab::Figures));
    EXPECT_EQ(session->window.figure, Figure::Sheet);
    EXPECT_EQ(axesOf(*session)[0], (SheetAxis{"textures[0].wrapS", "*"}));
    scrollTo("textures[0].magFilter#label");
    click("textures[0].magFilter#label", ImGuiMouseButton_Right);
    frames(2);
    click("textures[0].magFilter#menu:columns");
    frames(3);
    EXPECT_TRUE(has("sheet cell:GL_REPEAT,GL_LINEAR"));
    varyOnSheet(*session, "textures[0].wrapS", 1);
    EXPECT_EQ(axesOf(*session)[0].path, "textures[0].magFilter") << "they have changed places";
    EXPECT_EQ(axesOf(*session)[1].path, "textures[0].wrapS");
}

TEST_F(Sheet, OnlyTakesWhatHasFewValues) {
    session->settings.workspace = {};
    open("Model");
    scrollTo("models[0].name#label");
    click("models[0].name#label", ImGuiMouseButton_Right);
    frames(2);
    EXPECT_TRUE(has("models[0].name#menu:reset"));
    EXPECT_FALSE(has("models[0].name#menu:rows"));
}

TEST_F(Sheet, IsFoundInTheMenu) {
    session->window.figure = Figure::Block;
    session->window.wantedTab = Tab::Commands;
    frames(3);
    click("menu:File");
    frames(2);
    click("menu:Sheet of variations…");
    frames(3);
    EXPECT_TRUE(has("sheet:own"));
}

TEST_F(Sheet, ItsCommandIsCopied) {
    write("sheet values:Rows", "1,4");
    click("sheet:copy");
    EXPECT_STREQ(ImGui::GetClipboardText(), sweepCommand(*session).value().c_str());
    EXPECT_TRUE(session->look.notice.isGood);
    scene().textures.push_back({});
    click("sheet:copy");
    EXPECT_THAT(session->look.notice.text, testing::HasSubstr("No command can draw this sheet: "));
}

TEST_F(Sheet, IsWrittenAsAFile) {
    const test::TempDir folder;
    write("sheet values:Rows", "1,4");
    click("sheet:save");
    frames(2);
    click("sheet file:words");
    doubleClickAt(place("sheet file:width"));
    key('A', {ctrl});
    type("64");
    key(key::enter);
    frames(2);
    EXPECT_EQ(session->sheet.width, 64);
    EXPECT_EQ(session->sheet.labels, sheet::LabelKind::Words);
    click("sheet file:choose");
    frames(3);
    ASSERT_EQ(session->asking.dialog, Dialog::SaveSheet);
    EXPECT_EQ(states.dialogs.browser.typed, "scene-sheet.png");
    key('A', {ctrl});
    type((folder / "sheet.png").string());
    key(key::enter);
    frames(3);
    EXPECT_EQ(session->asking.dialog, Dialog::None);
    EXPECT_EQ(session->look.notice.text, "Written: " + (folder / "sheet.png").string());
    EXPECT_TRUE(session->look.notice.isGood);
    EXPECT_TRUE(std::filesystem::exists(folder / "sheet.png"));
}

TEST_F(Sheet, WhatCantBeWrittenIsSaidBeforeAFileIsAskedFor) {
    session->sheet.width = 16000;
    click("sheet:save");
    frames(2);
    EXPECT_TRUE(has("sheet:problem"));
    click("sheet file:choose");
    frames(2);
    EXPECT_EQ(session->asking.dialog, Dialog::None);
}

TEST_F(Sheet, StandsWithoutATexture) {
    scene().textures.clear();
    unit().enabled = false;
    frames(2);
    EXPECT_TRUE(has("sheet:problem")) << "there is no texture";
    expectSoundFrame();
}

} // namespace
} // namespace texplorer::ui::sheet_test

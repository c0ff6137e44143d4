#include "app/ui/files/asking.h"
#include "app/ui/files/scene_files.h"
#include "app/ui/widgets/keys.h"
#include "tests/support/temp_dir.h"
#include "tests/ui/workbench.h"
#include "texplorer/codec/png/png.h"
#include "texplorer/files/file_io.h"
#include "texplorer/scene/params/json.h"
#include "texplorer/scene/storage/scene_file.h"

#include <gmock/gmock.h>
#include <imgui_internal.h>

#include <set>

namespace texplorer::ui::file_browser_test {
namespace {

using namespace test;

using testing::HasSubstr;

class FileBrowserDialog : public Workbench {
protected:
    void write(const std::filesystem::path& path, std::string_view text) {
        ASSERT_TRUE(writeFileAtomically(path, viewBytes(text)).has_value());
    }
    /// Types a path into the open browser and confirms it.
    void enter(const std::filesystem::path& path) {
        type(path.string());
        key(key::enter);
    }
    void change() { choose("textures[0].wrapS", "GL_CLAMP"); }
    /// A picture as texshot writes it, in "made.png".
    Bytes writePicture(const Scene& drawn) {
        Bytes png = encodePng(plain, {.texts = {{sceneKeyword, writeScene(drawn)}}}).value();
        EXPECT_TRUE(writeFileAtomically(folder / "made.png", png));
        return png;
    }

    texplorer::test::TempDir folder;
    const Image plain{PixelFormat::Rgb8, 2, 2, 1, Bytes(12, std::byte{7})};
};

TEST_F(FileBrowserDialog, SaysWhatAnEmptyFolderLacks) {
    session->document.file = folder / "mine.texplorer.json";
    key('S', {ctrl, shift});
    ASSERT_EQ(session->asking.dialog, Dialog::SaveScene);
    EXPECT_TRUE(has("browser:There are no files to replace here."));
    key(key::escape);
    key('O', {ctrl});
    ASSERT_EQ(session->asking.dialog, Dialog::OpenScene);
    EXPECT_TRUE(has("browser:There are no files to open here."));
}

TEST_F(FileBrowserDialog, ASceneIsSavedAndOpenedAgain) {
    change();
    key('S', {ctrl});
    ASSERT_EQ(session->asking.dialog, Dialog::SaveScene);
    enter(folder / "mine");
    EXPECT_EQ(session->asking.dialog, Dialog::None);
    EXPECT_EQ(session->document.file, folder / "mine.texplorer.json"); // the extension is added
    EXPECT_FALSE(isDirty(session->document));
    const Scene saved = scene();
    EXPECT_EQ(parseScene(readText(folder / "mine.texplorer.json").value()).value(), saved);
    EXPECT_THAT(requests.title, HasSubstr("mine.texplorer.json"));

    choose("textures[0].wrapS", "GL_REPEAT");
    EXPECT_TRUE(isDirty(session->document));
    key('S', {ctrl}); // straight into the same file
    EXPECT_EQ(session->asking.dialog, Dialog::None);
    EXPECT_EQ(parseScene(readText(folder / "mine.texplorer.json").value()).value().textures[0].wrapS,
              Wrap::Repeat);

    key('O', {ctrl});
    ASSERT_EQ(session->asking.dialog, Dialog::OpenScene);
    write(folder / "other.json", R"({"version": 1, "textures": [{"wrapT": "GL_CLAMP"}]})");
    enter(folder / "other.json");
    EXPECT_EQ(texture().wrapT, Wrap::Clamp);
    EXPECT_EQ(session->document.file, folder / "other.json");
    EXPECT_FALSE(session->document.history.canUndo());
}

TEST_F(FileBrowserDialog, APictureThatTexshotHasDrawnIsAScene) {
    Scene drawn = defaultScene();
    drawn.textures[0].wrapS = Wrap::MirroredRepeat;
    drawn.view.distance = 9; // not the start's, which is fitted to the view
    const Bytes png = writePicture(drawn);
    ASSERT_TRUE(writeFileAtomically(folder / "plain.png", encodePng(plain).value()));
    for (const char* name : {"a.json", "b.texplorer.json", "c.suite.json", "d.txt"})
        write(folder / name, R"({"version": 1})");
    session->document.file = folder / "a.json";
    key('O', {ctrl});
    std::set<std::string> listed;
    for (const FileBrowser::Entry& each : states.dialogs.browser.entries) {
        if (!each.isOther)
            listed.insert(each.name);
    }
    EXPECT_EQ(listed, (std::set<std::string>{"a.json", "b.texplorer.json", "d.txt", "made.png"}));
    enter(folder / "plain.png");
    EXPECT_THAT(states.dialogs.browser.error, HasSubstr("a PNG without a scene"));
    key(key::escape);

    key('O', {ctrl});
    enter(folder / "made.png");
    EXPECT_EQ(scene(), drawn);
    EXPECT_TRUE(session->document.file.empty());
    EXPECT_FALSE(isDirty(session->document));
    EXPECT_THAT(requests.title, HasSubstr("made.texplorer.json - "));
    key('S', {ctrl}); // asks for a name, and has one
    ASSERT_EQ(session->asking.dialog, Dialog::SaveScene);
    key(key::enter);
    EXPECT_EQ(session->document.file, folder / "made.texplorer.json");
    EXPECT_EQ(readFile(folder / "made.png").value(), png);
}

TEST_F(FileBrowserDialog, WhatIsMeantByAPictureWithItsSceneIsAsked) {
    Scene drawn = defaultScene();
    drawn.textures[0].wrapS = Wrap::MirroredRepeat;
    const std::filesystem::path made = folder / "made.png";
    static_cast<void>(writePicture(drawn));
    requestOpen(*session, {made});
    frames(3);
    ASSERT_EQ(session->asking.dialog, Dialog::Picture);
    click("picture:cancel");
    EXPECT_EQ(session->asking.dialog, Dialog::None);
    EXPECT_EQ(scene().textures, defaultScene().textures);

    requestOpen(*session, {made});
    frames(3);
    click("picture:image");
    frames(2);
    EXPECT_EQ(texture().source, SourceKind::File);
    EXPECT_TRUE(session->document.history.canUndo());

    requestOpen(*session, {made}); // now there is something to lose
    frames(3);
    click("picture:scene");
    frames(3);
    ASSERT_EQ(session->asking.dialog, Dialog::Discard);
    click("discard:drop");
    frames(2);
    EXPECT_EQ(texture().wrapS, Wrap::MirroredRepeat);

    start(defaultScene());
    ASSERT_TRUE(openArguments(*session, {made}));
    frames(3);
    ASSERT_EQ(session->asking.dialog, Dialog::Picture);
    click("picture:image");
    frames(2);
    EXPECT_EQ(texture().source, SourceKind::File);
    EXPECT_FALSE(session->document.history.canUndo()) << "to begin with it is no edit";
}

TEST_F(FileBrowserDialog, AnExistingFileIsNotReplacedUnasked) {
    write(folder / "old.json", "precious");
    key('S', {ctrl, shift});
    enter(folder / "old.json");
    EXPECT_EQ(session->asking.dialog, Dialog::SaveScene);
    EXPECT_THAT(states.dialogs.browser.error, HasSubstr("old.json exists"));
    EXPECT_EQ(readText(folder / "old.json").value(), "precious");
    click("browser:ok");
    EXPECT_EQ(session->asking.dialog, Dialog::None);
    EXPECT_NE(readText(folder / "old.json").value(), "precious");
}

struct Refused {
    const char* file;
    const char* content; // nullptr: there is no such file
    const char* sentence;
};

TEST_F(FileBrowserDialog, WhatIsNoSceneIsSaidAndChangesNothing) {
    const Scene before = scene();
    for (const auto& [file, content, sentence] :
         {Refused{"none.json", nullptr, "no file"},
          Refused{"cut.json", R"({"version": 1, "textures": [)", ""},
          Refused{"name.json", R"({"textures": [{"wrapS": "GL_SOMETIMES"}]})", "GL_REPEAT"}}) {
        SCOPED_TRACE(file);
        if (content)
            write(folder / file, content);
        key('O', {ctrl});
        enter(folder / file);
        EXPECT_EQ(session->asking.dialog, Dialog::OpenScene) << "the list stays open";
        EXPECT_THAT(states.dialogs.browser.error, HasSubstr(sentence));
        EXPECT_TRUE(has("browser:error"));
        key(key::escape);
        EXPECT_EQ(session->asking.dialog, Dialog::None);
        EXPECT_EQ(scene(), before);
        EXPECT_TRUE(session->document.file.empty());
    }
}

TEST_F(FileBrowserDialog, AMissingImageIsSaidOnceTheListIsClosed) {
    const Scene before = scene();
    write(folder / "image.json", R"({"textures": [{"source": "file", "file": "gone.bmp"}]})");
    key('O', {ctrl});
    enter(folder / "image.json");
    EXPECT_EQ(session->asking.dialog, Dialog::None);
    EXPECT_THAT(session->look.notice.text, HasSubstr("gone.bmp"));
    EXPECT_TRUE(has("notice"));
    EXPECT_EQ(scene(), before);
    EXPECT_TRUE(session->document.file.empty());
}

TEST_F(FileBrowserDialog, AFolderThatCannotBeWrittenIsSaid) {
    key('S', {ctrl});
    enter(folder / "no such folder" / "a.json");
    EXPECT_EQ(session->asking.dialog, Dialog::SaveScene);
    EXPECT_THAT(states.dialogs.browser.error, HasSubstr("no folder"));
    key(key::escape);
    EXPECT_TRUE(session->document.file.empty());
}

TEST_F(FileBrowserDialog, TheListGoesIntoFoldersAndUp) {
    std::filesystem::create_directory(folder / "inner");
    write(folder / "inner" / "scene.json", writeScene(defaultScene()));
    write(folder / "inner" / "notes.txt", "not a scene");
    key('O', {ctrl});
    enter(folder.path());
    EXPECT_TRUE(has("entry:inner"));
    doubleClickAt(place("entry:inner"));
    EXPECT_EQ(states.dialogs.browser.folder.filename(), "inner");
    EXPECT_TRUE(has("entry:scene.json"));
    EXPECT_FALSE(has("entry:notes.txt"));
    click("browser:all");
    EXPECT_TRUE(has("entry:notes.txt"));
    click("browser:up");
    EXPECT_TRUE(has("entry:inner"));
    doubleClickAt(place("entry:inner"));
    key(key::down); // notes.txt
    key(key::down);
    key(key::enter);
    EXPECT_EQ(session->document.file.filename(), "scene.json");
}

TEST_F(FileBrowserDialog, ChangesAreNotLostUnasked) {
    change();
    requestQuit(*session);
    frames(3);
    EXPECT_EQ(session->asking.dialog, Dialog::Discard);
    EXPECT_TRUE(ImGui::FindWindowByName("Unsaved changes in this scene"));
    EXPECT_FALSE(requests.quit);
    click("discard:cancel");
    EXPECT_EQ(session->asking.dialog, Dialog::None);
    EXPECT_EQ(texture().wrapS, Wrap::Clamp);

    click("menu:File");
    click("menu:New");
    click("discard:drop");
    EXPECT_EQ(texture().wrapS, Wrap::Repeat);

    change();
    requestQuit(*session);
    frames(3);
    click("discard:save");
    ASSERT_EQ(session->asking.dialog, Dialog::SaveScene);
    type((folder / "kept.json").string());
    setHeld(key::enter, true);
    bool quit = false;
    for (int i = 0; i < 3; ++i) {
        frames(1);
        quit |= requests.quit;
    }
    EXPECT_TRUE(quit) << "saved, and then the window closes";
    EXPECT_TRUE(std::filesystem::exists(folder / "kept.json"));
}

TEST_F(FileBrowserDialog, LookingAroundIsNothingToSave) {
    drag({static_cast<float>(layout.picture.x + 20), static_cast<float>(layout.picture.y + 20)}, {50, 10});
    EXPECT_TRUE(session->document.history.canUndo());
    requestQuit(*session);
    frames(1);
    EXPECT_TRUE(requests.quit);
}

TEST_F(FileBrowserDialog, UndoingEverythingLeavesNothingToSave) {
    change();
    EXPECT_TRUE(isDirty(session->document));
    key('Z', {ctrl});
    EXPECT_FALSE(isDirty(session->document));
}

} // namespace
} // namespace texplorer::ui::file_browser_test

#include "app/ui/files/scene_files.h"
#include "app/ui/widgets/keys.h"
#include "tests/support/temp_dir.h"
#include "tests/ui/workbench.h"
#include "texplorer/files/file_io.h"
#include "texplorer/scene/params/json.h"

#include <gmock/gmock.h>

#include <fstream>

namespace texplorer::ui::changed_file_dialog_test {
namespace {

using namespace test;

using testing::HasSubstr;

class ChangedFileDialog : public Workbench {
protected:
    /// A scene is opened, and edited here and elsewhere.
    ChangedFileDialog() {
        write(R"({"version": 1})");
        EXPECT_TRUE(openScene(*session, file));
        frames(3);
        choose("textures[0].wrapS", "GL_CLAMP");
        write(R"({"version": 1, "textures": [{"wrapT": "GL_CLAMP"}]})");
    }
    void newScene() {
        click("menu:File");
        click("menu:New");
    }
    void write(std::string_view text) const { std::ofstream(file) << text; }
    [[nodiscard]] Scene saved() const { return parseScene(readText(file).value()).value(); }

    texplorer::test::TempDir folder;
    std::filesystem::path file = folder / "scene.json";
};

TEST_F(ChangedFileDialog, NamesWhatDiffersAndKeepsMine) {
    key('S', {ctrl});
    frames(3);
    ASSERT_EQ(session->asking.dialog, Dialog::FileHasChanged);
    EXPECT_TRUE(has("changed:textures[0].wrapS"));
    EXPECT_TRUE(has("changed:textures[0].wrapT"));
    click("changed:mine");
    EXPECT_EQ(session->asking.dialog, Dialog::None);
    EXPECT_EQ(saved(), scene());
    EXPECT_FALSE(isDirty(session->document));
}

TEST_F(ChangedFileDialog, TakesTheirs) {
    key('S', {ctrl});
    frames(3);
    click("changed:theirs");
    frames(3);
    EXPECT_EQ(texture().wrapT, Wrap::Clamp);
    EXPECT_FALSE(isDirty(session->document));
    key('Z', {ctrl});
    EXPECT_EQ(texture().wrapS, Wrap::Clamp);
}

TEST_F(ChangedFileDialog, SavesElsewhere) {
    const Scene theirs = saved();
    key('S', {ctrl});
    frames(3);
    click("changed:elsewhere");
    frames(3);
    ASSERT_EQ(session->asking.dialog, Dialog::SaveScene);
    type((folder / "mine.json").string());
    key(key::enter);
    EXPECT_EQ(session->document.file, folder / "mine.json");
    EXPECT_EQ(saved(), theirs);
}

TEST_F(ChangedFileDialog, StandsBeforeWhatWaitsForTheSaving) {
    newScene();
    frames(3);
    ASSERT_EQ(session->asking.dialog, Dialog::Discard);
    click("discard:save");
    frames(3);
    ASSERT_EQ(session->asking.dialog, Dialog::FileHasChanged);
    key(key::escape);
    EXPECT_EQ(session->asking.dialog, Dialog::None);
    EXPECT_EQ(session->document.file, file) << "nothing has happened";
    newScene();
    frames(3);
    click("discard:save");
    frames(3);
    click("changed:mine");
    frames(3);
    EXPECT_TRUE(session->document.file.empty()) << "the new one";
    EXPECT_EQ(saved().textures[0].wrapS, Wrap::Clamp);
}

TEST_F(ChangedFileDialog, SaysThatTheFileIsNoSceneAnyMore) {
    write("{");
    key('S', {ctrl});
    frames(3);
    ASSERT_EQ(session->asking.dialog, Dialog::FileHasChanged);
    EXPECT_TRUE(has("changed:problem"));
    click("changed:theirs"); // which there are none of
    EXPECT_EQ(session->asking.dialog, Dialog::FileHasChanged);
    click("changed:mine");
    EXPECT_EQ(saved(), scene());
}

TEST_F(ChangedFileDialog, AsksAgainWhereWhatIsToBeOverwrittenChanges) {
    const std::filesystem::path other = folder / "other.json";
    std::ofstream(other) << "old";
    key('S', {ctrl, shift});
    type(other.string());
    key(key::enter);
    EXPECT_THAT(states.dialogs.browser.error, HasSubstr("other.json exists"));
    std::ofstream(other) << "of another program";
    click("browser:ok");
    EXPECT_EQ(session->asking.dialog, Dialog::SaveScene);
    EXPECT_EQ(readText(other).value(), "of another program");
    click("browser:ok");
    EXPECT_EQ(session->document.file, other);
}

} // namespace
} // namespace texplorer::ui::changed_file_dialog_test

#include "app/ui/editor/received_files.h"
#include "app/ui/files/asking.h"
#include "app/ui/files/loads.h"
#include "app/ui/files/scene_files.h"
#include "app/ui/files/scene_saving.h"
#include "tests/support/temp_dir.h"
#include "tests/ui/edits.h"
#include "texplorer/files/file_io.h"
#include "texplorer/scene/params/json.h"

#include <gmock/gmock.h>

#include <fstream>
#include <thread>

namespace texplorer::ui::scene_saving_test {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view begun = R"({"version": 1, "textures": [{"wrapS": "GL_REPEAT"}]})";
constexpr std::string_view others = R"({"version": 1, "textures": [{"wrapS": "GL_CLAMP "}]})";  // as long
constexpr std::string_view clamped = R"({"version": 1, "textures": [{"wrapS": "GL_CLAMP"} ]})"; // likewise

class SavedScene : public testing::Test {
protected:
    SavedScene() {
        edit(begun);
        EXPECT_TRUE(openScene(session, file));
        receiveFiles(session);
        session.document.scene.textures[0].wrapT = Wrap::ClampToEdge;
        recordEdit(session, "Wrap t");
    }
    /// As an editor does that writes into the file.
    void edit(std::string_view text) const { std::ofstream(file) << text; }
    [[nodiscard]] std::string text() const { return readText(file).value(); }
    void expectSaved() {
        save(session);
        EXPECT_EQ(session.asking.dialog, Dialog::None);
        EXPECT_EQ(parseScene(text()).value(), session.document.scene);
    }

    test::TempDir folder;
    fs::path file = folder / "scene.json";
    ServicesAtOnce services;
    Session session{services.lend()};
};

TEST_F(SavedScene, IsWrittenWhereNobodyElseHas) {
    save(session);
    EXPECT_EQ(parseScene(text()).value(), session.document.scene);
    session.document.scene.textures[0].wrapT = Wrap::Repeat;
    recordEdit(session, "Wrap t");
    save(session); // what it has written itself is no change
    EXPECT_EQ(session.asking.dialog, Dialog::None);
    EXPECT_FALSE(isDirty(session.document));
}

TEST_F(SavedScene, ThatAnotherProgramHasWrittenStaysUntilTheUserDecides) {
    const fs::file_time_type before = fs::last_write_time(file);
    edit(clamped);
    fs::last_write_time(file, before); // neither its time nor its size tells
    ASSERT_EQ(clamped.size(), begun.size());
    save(session);
    EXPECT_EQ(session.asking.dialog, Dialog::FileHasChanged);
    EXPECT_EQ(text(), clamped);
    EXPECT_TRUE(isDirty(session.document));
    ASSERT_NE(session.document.changedFile, nullptr);
    const std::vector<SceneChange>& changes = session.document.changedFile->changes;
    ASSERT_EQ(changes.size(), 2U);
    EXPECT_EQ(changes[0].path, "textures[0].wrapS");
    EXPECT_EQ(changes[0].from, "GL_CLAMP");
    EXPECT_EQ(changes[0].to, "GL_REPEAT");
    EXPECT_EQ(changes[1].path, "textures[0].wrapT");

    keepMine(session);
    save(session);
    EXPECT_EQ(parseScene(text()).value(), session.document.scene);
}

TEST_F(SavedScene, IsAskedAboutAgainWhereItChangesAgain) {
    edit(clamped);
    save(session);
    keepMine(session);
    edit(R"({"version": 1})");
    session.asking.dialog = Dialog::None;
    save(session);
    EXPECT_EQ(session.asking.dialog, Dialog::FileHasChanged);
    EXPECT_EQ(text(), R"({"version": 1})");
}

TEST_F(SavedScene, OfTheSameContentIsNoChangeWhateverItsTime) {
    edit(begun);
    fs::last_write_time(file, fs::last_write_time(file) + std::chrono::hours(1));
    expectSaved();
}

TEST_F(SavedScene, InAnotherSpellingIsNoChange) {
    edit("{\n  \"textures\": [{\"wrapS\": \"GL_REPEAT\"}],\n  \"version\": 1}");
    expectSaved();
}

TEST_F(SavedScene, ThatIsGoneIsWrittenAnew) {
    fs::remove(file);
    expectSaved();
}

TEST_F(SavedScene, ThatIsNoSceneAnyMoreStays) {
    edit(others);
    save(session);
    EXPECT_EQ(session.asking.dialog, Dialog::FileHasChanged);
    ASSERT_NE(session.document.changedFile, nullptr);
    EXPECT_FALSE(session.document.changedFile->theirs);
    EXPECT_EQ(text(), others);
    keepMine(session);
    save(session);
    EXPECT_EQ(parseScene(text()).value(), session.document.scene);
}

TEST_F(SavedScene, OfAnotherProgramIsTakenAsAStepOfUndo) {
    const Scene mine = session.document.scene;
    edit(clamped);
    save(session);
    session.asking.dialog = Dialog::None;
    takeTheirs(session);
    receiveFiles(session);
    EXPECT_EQ(session.document.scene, parseScene(clamped).value());
    EXPECT_EQ(text(), clamped);
    EXPECT_FALSE(isDirty(session.document));
    take(session, Undo{});
    EXPECT_EQ(session.document.scene, mine);
    EXPECT_TRUE(isDirty(session.document));
    save(session); // mine, after all: what the file has is known
    EXPECT_EQ(session.asking.dialog, Dialog::None);
    EXPECT_EQ(parseScene(text()).value(), mine);
}

TEST_F(SavedScene, ByAnotherNameIsTheSameFile) {
    fs::create_symlink(file, folder / "link.json");
    edit(clamped);
    const Result<Saving> saved = saveScene(session, folder / "link.json");
    ASSERT_TRUE(saved);
    EXPECT_EQ(*saved, Saving::FileHasChanged);
    EXPECT_EQ(text(), clamped);
}

TEST_F(SavedScene, ElsewhereReplacesNothingThatWasNotAgreedTo) {
    const fs::path other = folder / "other.json";
    std::ofstream(other) << "precious";
    const std::optional<FileFingerprint> agreed = fingerprintOf(other);
    EXPECT_FALSE(saveScene(session, other));
    std::ofstream(other) << "more precious";
    EXPECT_FALSE(saveScene(session, other, agreed));
    EXPECT_EQ(readText(other).value(), "more precious");
    EXPECT_TRUE(saveScene(session, other, fingerprintOf(other)));
    EXPECT_EQ(session.document.file, other);
}

TEST_F(SavedScene, RestoredAfterItsFileHasChangedIsAskedAbout) {
    const UnsavedScene draft{file, folder.path(), session.document.scene, session.document.fileHash};
    for (const bool changes : {false, true}) {
        if (changes)
            edit(clamped);
        Session other(services.lend());
        restoreUnsaved(other, draft);
        receiveFiles(other);
        ASSERT_EQ(other.document.file, file);
        save(other);
        EXPECT_EQ(other.asking.dialog, changes ? Dialog::FileHasChanged : Dialog::None);
        edit(begun);
    }
}

/// A number is counted in the file: what another window has written is taken, and the edit made again.
void count(const fs::path& file, int Texture::*number, int step, int edits) {
    ServicesAtOnce services;
    Session session(services.lend());
    ASSERT_TRUE(openScene(session, file));
    receiveFiles(session);
    for (int i = 0; i < edits; ++i) {
        for (;;) {
            session.document.scene.textures[0].*number += step;
            recordEdit(session, "A level");
            const Result<Saving> saved = saveScene(session, file);
            ASSERT_TRUE(saved) << describe(saved.error());
            if (*saved == Saving::Written)
                break;
            takeTheirs(session);
            receiveFiles(session);
        }
    }
}

TEST_F(SavedScene, OfTwoWindowsAtTheSameTimeLosesNothing) {
    constexpr int edits = 20;
    {
        const std::jthread one([this] { count(file, &Texture::baseLevel, 1, edits); });
        const std::jthread two([this] { count(file, &Texture::maxLevel, -1, edits); });
    }
    const Texture saved = readScene(file).value().scene.textures[0];
    EXPECT_EQ(saved.baseLevel, edits);
    EXPECT_EQ(saved.maxLevel, Texture{}.maxLevel - edits);
}

} // namespace
} // namespace texplorer::ui::scene_saving_test

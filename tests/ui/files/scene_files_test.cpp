#include "app/ui/editor/received_files.h"
#include "app/ui/files/asking.h"
#include "app/ui/files/loads.h"
#include "app/ui/files/scene_files.h"
#include "app/ui/files/scene_saving.h"
#include "app/ui/model/notice.h"
#include "tests/support/small_bmp.h"
#include "tests/support/temp_dir.h"
#include "tests/ui/edits.h"
#include "texplorer/files/file_io.h"
#include "texplorer/scene/params/json.h"

#include <gmock/gmock.h>

namespace texplorer::ui::scene_files_test {
namespace {

using testing::HasSubstr;

class SceneFiles : public testing::Test {
protected:
    void write(const std::filesystem::path& path, std::string_view text) {
        std::filesystem::create_directories(path.parent_path());
        ASSERT_TRUE(writeFileAtomically(path, viewBytes(text)).has_value());
    }
    void open(Session& into, const std::filesystem::path& file) {
        ASSERT_TRUE(openScene(into, file));
        receiveFiles(into);
    }

    const std::string red = test::onePixelBmp({0, 0, '\xFF'});
    test::TempDir folder;
    ServicesAtOnce services;
    Session session{services.lend()};
};

TEST_F(SceneFiles, TheWindowsTitleHasNoControlCharacters) {
    session.document.file = folder / "\x1B]0;x\a\n\xE2\x80\xAE.json";
    EXPECT_EQ(windowTitle(session.document), "\\u001b]0;x\\u0007\\u000a\\u202e.json - Texplorer");
}

TEST_F(SceneFiles, AnImageIsGivenATextureWhereThereIsNone) {
    write(folder / "red.bmp", red);
    session.document.scene.textures.clear();
    session.document.scene.passes[0].units[0].enabled = false;
    importImage(session, folder / "red.bmp");
    receiveFiles(session);
    EXPECT_EQ(session.document.scene.textures.size(), 1U);
    EXPECT_TRUE(session.document.scene.passes[0].units[0].enabled);
}

TEST_F(SceneFiles, OfMeshesSaysWhatIsMissing) {
    write(folder / "square.obj", "mtllib gone.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n");
    open(session, folder / "square.obj");
    EXPECT_EQ(session.document.scene.models.size(), 1U);
    EXPECT_EQ(session.look.notice.text.english(),
              "square.obj: the material library gone.mtl can't be read: drawn without its materials");
    write(folder / "gone.mtl", "newmtl wood\nmap_Kd gone.png\n");
    write(folder / "wood.obj", "mtllib gone.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nusemtl wood\nf 1 2 3\n");
    open(session, folder / "wood.obj");
    EXPECT_TRUE(session.look.notice.text.empty());
    ASSERT_EQ(session.asking.refused.size(), 1U);
    EXPECT_THAT(describe(session.asking.refused[0]).english(), HasSubstr("gone.png"));
}

TEST_F(SceneFiles, ImagePathsFollowTheSceneFile) {
    write(folder / "pictures" / "red.bmp", red);
    importImage(session, folder / "pictures" / "red.bmp");
    receiveFiles(session);
    ASSERT_TRUE(saveScene(session, folder / "a.json").has_value());
    EXPECT_EQ(session.document.scene.textures[0].file, "pictures/red.bmp");
    std::filesystem::create_directory(folder / "elsewhere");
    ASSERT_TRUE(saveScene(session, folder / "elsewhere" / "b.json").has_value());
    EXPECT_EQ(session.document.scene.textures[0].file, (folder / "pictures" / "red.bmp").string());
    EXPECT_NE(session.document.images.find(session.document.scene.textures[0]), nullptr);

    Session other(services.lend());
    open(other, folder / "a.json");
    EXPECT_NE(other.document.images.find(other.document.scene.textures[0]), nullptr);
    open(other, folder / "elsewhere" / "b.json");
    EXPECT_NE(other.document.images.find(other.document.scene.textures[0]), nullptr);
}

TEST_F(SceneFiles, AModelThatIsSeenIsSelected) {
    write(folder / "sphere.json", R"({"version": 1, "models": [
        {"shape": "cube", "visible": false}, {"shape": "sphere"}]})");
    open(session, folder / "sphere.json");
    EXPECT_EQ(session.look.selection.model, 1);
    write(folder / "none.json", R"({"version": 1, "models": [{"shape": "cube", "visible": false}]})");
    open(session, folder / "none.json");
    EXPECT_EQ(session.look.selection.model, 0);
}

struct Bad {
    const char* name;
    const char* content; // nullptr: there is no such file
};

TEST_F(SceneFiles, WhatIsNeitherSceneNorImageIsRefusedInOneSentenceAndChangesNothing) {
    const std::filesystem::path path = folder / "file.bin";
    const Scene before = session.document.scene;
    const auto import = [](Session& into, const std::filesystem::path& file) {
        importImage(into, file);
        return Result<void>();
    };
    const auto argument = [](Session& into, const std::filesystem::path& file) {
        return openArguments(into, {file});
    };
    using Opening = Result<void> (*)(Session&, const std::filesystem::path&);
    for (const Bad& bad : {Bad{"Missing", nullptr}, Bad{"Empty", ""}, Bad{"Text", "Hello, world!"},
                           Bad{"HalfScene", R"({"textures": [{"wrapS":)"}, Bad{"HalfBmp", "BM"}}) {
        SCOPED_TRACE(bad.name);
        if (bad.content)
            write(path, bad.content);
        for (const Opening opening :
             {Opening(openFile), Opening(import), Opening(openScene), Opening(argument)}) {
            session.look.notice = {};
            report(session, opening(session, path));
            receiveFiles(session);
            EXPECT_FALSE(session.look.notice.text.empty());
            EXPECT_EQ(session.look.notice.text.english().find('\n'), std::string::npos);
        }
        EXPECT_EQ(session.document.scene, before);
        EXPECT_FALSE(session.document.history.canUndo());
        EXPECT_TRUE(session.document.file.empty());
    }
}

TEST_F(SceneFiles, AFolderIsNoFile) {
    EXPECT_FALSE(openFile(session, folder.path()).has_value());
    EXPECT_FALSE(saveScene(session, folder.path()).has_value());
    EXPECT_TRUE(session.document.file.empty());
}

TEST_F(SceneFiles, ADroppedSceneAsksBeforeItReplacesChanges) {
    write(folder / "scene.json", R"({"version": 1, "textures": [{"wrapT": "GL_CLAMP"}]})");
    session.document.scene.textures[0].wrapS = Wrap::Clamp;
    recordEdit(session, "Wrap s");
    requestOpen(session, {folder / "scene.json"});
    receiveFiles(session);
    EXPECT_EQ(session.asking.dialog, Dialog::Discard);
    EXPECT_EQ(session.document.scene.textures[0].wrapT, Wrap::Repeat);
    take(session, Undo{});
    session.asking.dialog = Dialog::None;
    requestOpen(session, {folder / "scene.json"});
    receiveFiles(session);
    EXPECT_EQ(session.document.scene.textures[0].wrapT, Wrap::Clamp);
}

TEST_F(SceneFiles, ADroppedFileThatIsNothingIsReported) {
    write(folder / "notes.txt", "Hello");
    requestOpen(session, {folder / "notes.txt"});
    receiveFiles(session);
    EXPECT_THAT(session.look.notice.text, HasSubstr("notes.txt"));
}

} // namespace
} // namespace texplorer::ui::scene_files_test

#include "app/ui/editor/received_files.h"
#include "app/ui/files/asking.h"
#include "app/ui/files/loads.h"
#include "app/ui/files/scene_files.h"
#include "app/ui/files/scene_saving.h"
#include "app/ui/model/notice.h"
#include "tests/support/temp_dir.h"
#include "tests/ui/edits.h"
#include "texplorer/files/file_io.h"
#include "texplorer/scene/params/json.h"

#include <gmock/gmock.h>

namespace texplorer::ui::scene_files_test {
namespace {

using testing::HasSubstr;

/// A BMP of one red pixel, byte by byte.
std::string redBmp() {
    std::string file("BM"
                     "\x3A\0\0\0\0\0\0\0\x36\0\0\0"         // 58 bytes, pixels from offset 54
                     "\x28\0\0\0\1\0\0\0\1\0\0\0\1\0\x18\0" // 1 x 1, 24 bits
                     "\0\0\0\0\4\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0"
                     "\0\0\xFF\0", // blue, green, red, padding
                     58);
    return file;
}

class SceneFiles : public testing::Test {
protected:
    void write(const std::filesystem::path& path, std::string_view text) {
        std::filesystem::create_directories(path.parent_path());
        ASSERT_TRUE(writeFileAtomically(path, viewBytes(text)).has_value());
    }
    test::TempDir folder;
    ServicesAtOnce services;
    Session session{services.lend()};
};

TEST_F(SceneFiles, AnImageBecomesTheBoundTexture) {
    write(folder / "red.bmp", redBmp());
    importImage(session, folder / "red.bmp");
    receiveFiles(session);
    const Texture& texture = session.document.scene.textures[0];
    EXPECT_EQ(texture.source, SourceKind::File);
    const auto image = session.document.images.find(texture);
    ASSERT_NE(image, nullptr);
    EXPECT_EQ(widthOf(image->surfaces.front()), 1);
    EXPECT_EQ(session.document.history.undoName(), "Open red.bmp");
    take(session, Undo{});
    EXPECT_EQ(session.document.scene.textures[0].source, SourceKind::Pattern);
}

TEST_F(SceneFiles, TheWindowsTitleHasNoControlCharacters) {
    session.document.file = folder / "\x1B]0;x\a\n\xE2\x80\xAE.json";
    EXPECT_EQ(windowTitle(session.document), "\\u001b]0;x\\u0007\\u000a\\u202e.json - Texplorer");
}

TEST_F(SceneFiles, AnImageIsGivenATextureWhereThereIsNone) {
    write(folder / "red.bmp", redBmp());
    session.document.scene.textures.clear();
    session.document.scene.passes[0].units[0].enabled = false;
    importImage(session, folder / "red.bmp");
    receiveFiles(session);
    EXPECT_EQ(session.document.scene.textures.size(), 1U);
    EXPECT_TRUE(session.document.scene.passes[0].units[0].enabled);
}

TEST_F(SceneFiles, ImagePathsFollowTheSceneFile) {
    write(folder / "pictures" / "red.bmp", redBmp());
    importImage(session, folder / "pictures" / "red.bmp");
    receiveFiles(session);
    ASSERT_TRUE(saveScene(session, folder / "a.json").has_value());
    EXPECT_EQ(session.document.scene.textures[0].file, "pictures/red.bmp");
    std::filesystem::create_directory(folder / "elsewhere");
    ASSERT_TRUE(saveScene(session, folder / "elsewhere" / "b.json").has_value());
    EXPECT_EQ(session.document.scene.textures[0].file, (folder / "pictures" / "red.bmp").string());
    EXPECT_NE(session.document.images.find(session.document.scene.textures[0]), nullptr);

    Session other(services.lend());
    ASSERT_TRUE(openScene(other, folder / "a.json").has_value());
    receiveFiles(other);
    EXPECT_NE(other.document.images.find(other.document.scene.textures[0]), nullptr);
    ASSERT_TRUE(openScene(other, folder / "elsewhere" / "b.json").has_value());
    receiveFiles(other);
    EXPECT_NE(other.document.images.find(other.document.scene.textures[0]), nullptr);
}

TEST_F(SceneFiles, AModelThatIsSeenIsSelected) {
    write(folder / "sphere.json", R"({"version": 1, "models": [
        {"shape": "cube", "visible": false}, {"shape": "sphere"}]})");
    ASSERT_TRUE(openScene(session, folder / "sphere.json").has_value());
    receiveFiles(session);
    EXPECT_EQ(session.look.selection.model, 1);
    write(folder / "none.json", R"({"version": 1, "models": [{"shape": "cube", "visible": false}]})");
    ASSERT_TRUE(openScene(session, folder / "none.json").has_value());
    receiveFiles(session);
    EXPECT_EQ(session.look.selection.model, 0);
}

struct Bad {
    const char* name;
    const char* content; // nullptr: there is no such file
};

class BadFile : public SceneFiles, public testing::WithParamInterface<Bad> {};

TEST_P(BadFile, IsRefusedInOneSentenceAndChangesNothing) {
    const std::filesystem::path path = folder / "file.bin";
    if (GetParam().content)
        write(path, GetParam().content);
    const Scene before = session.document.scene;
    const auto import = [](Session& into, const std::filesystem::path& file) {
        importImage(into, file);
        return Result<void>();
    };
    const auto argument = [](Session& into, const std::filesystem::path& file) {
        return openArguments(into, {file});
    };
    using Opening = Result<void> (*)(Session&, const std::filesystem::path&);
    for (const Opening open : {Opening(openFile), Opening(import), Opening(openScene), Opening(argument)}) {
        session.look.notice = {};
        report(session, open(session, path));
        receiveFiles(session);
        EXPECT_FALSE(session.look.notice.text.empty());
        EXPECT_EQ(session.look.notice.text.find('\n'), std::string::npos);
    }
    EXPECT_EQ(session.document.scene, before);
    EXPECT_FALSE(session.document.history.canUndo());
    EXPECT_TRUE(session.document.file.empty());
}

INSTANTIATE_TEST_SUITE_P(All, BadFile,
                         testing::Values(Bad{"Missing", nullptr}, Bad{"Empty", ""},
                                         Bad{"Text", "Hello, world!"},
                                         Bad{"HalfScene", R"({"textures": [{"wrapS":)"},
                                         Bad{"HalfBmp", "BM"}),
                         [](const auto& test) { return test.param.name; });

TEST_F(SceneFiles, AFolderIsNoFile) {
    EXPECT_FALSE(openFile(session, folder.path()).has_value());
    EXPECT_FALSE(saveScene(session, folder.path()).has_value());
    EXPECT_TRUE(session.document.file.empty());
}

TEST_F(SceneFiles, TheCommandLineTakesASceneAndImages) {
    write(folder / "red.bmp", redBmp());
    write(folder / "scene.json", R"({"version": 1, "textures": [{"wrapS": "GL_CLAMP"}]})");
    const auto opened =
        openArguments(session, {folder / "red.bmp", folder / "scene.json", folder / "red.bmp"});
    ASSERT_TRUE(opened.has_value()) << describe(opened.error());
    receiveFiles(session);
    ASSERT_EQ(session.document.scene.textures.size(), 2U);
    EXPECT_EQ(session.document.scene.textures[0].wrapS, Wrap::Clamp);
    EXPECT_EQ(session.document.scene.textures[0].source, SourceKind::File);
    EXPECT_FALSE(isDirty(session.document));
    EXPECT_FALSE(session.document.history.canUndo());
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
    requestOpen(session, {folder / "gone.bmp"});
    receiveFiles(session);
    EXPECT_THAT(session.look.notice.text, HasSubstr("gone.bmp"));
}

} // namespace
} // namespace texplorer::ui::scene_files_test

#include "app/ui/model/document.h"
#include "app/ui/window/workbench.h"
#include "core/base/file_io.h"
#include "core/scene/params/json.h"
#include "tests/support/temp_dir.h"

#include <gmock/gmock.h>

namespace texplorer::ui {
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

class Document : public testing::Test {
protected:
    void write(const std::filesystem::path& path, std::string_view text) {
        std::filesystem::create_directories(path.parent_path());
        ASSERT_TRUE(writeFileAtomically(path, viewBytes(text)).has_value());
    }
    test::TempDir folder;
    Session session = makeSession(defaultScene(), ImageSource{});
};

TEST_F(Document, AnImageBecomesTheBoundTexture) {
    write(folder / "red.bmp", redBmp());
    ASSERT_TRUE(importImage(session, folder / "red.bmp").has_value());
    const Texture& texture = session.scene.textures[0];
    EXPECT_EQ(texture.source, SourceKind::File);
    const auto image = session.images.find(texture);
    ASSERT_NE(image, nullptr);
    EXPECT_EQ(widthOf(image->surfaces.front()), 1);
    EXPECT_EQ(session.history.undoName(), "Open red.bmp");
    undo(session);
    EXPECT_EQ(session.scene.textures[0].source, SourceKind::Pattern);
}

TEST_F(Document, TheWindowsTitleHasNoControlCharacters) {
    session.file = folder / "\x1B]0;x\a\n\xE2\x80\xAE.json";
    EXPECT_EQ(windowTitle(session), "\\u001b]0;x\\u0007\\u000a\\u202e.json - Texplorer");
}

TEST_F(Document, AnImageIsGivenATextureWhereThereIsNone) {
    write(folder / "red.bmp", redBmp());
    session.scene.textures.clear();
    session.scene.passes[0].units[0].enabled = false;
    ASSERT_TRUE(importImage(session, folder / "red.bmp").has_value());
    EXPECT_EQ(session.scene.textures.size(), 1U);
    EXPECT_TRUE(session.scene.passes[0].units[0].enabled);
}

TEST_F(Document, ImagePathsFollowTheSceneFile) {
    write(folder / "pictures" / "red.bmp", redBmp());
    ASSERT_TRUE(importImage(session, folder / "pictures" / "red.bmp").has_value());
    ASSERT_TRUE(saveScene(session, folder / "a.json").has_value());
    EXPECT_EQ(session.scene.textures[0].file, "pictures/red.bmp");
    std::filesystem::create_directory(folder / "elsewhere");
    ASSERT_TRUE(saveScene(session, folder / "elsewhere" / "b.json").has_value());
    EXPECT_EQ(session.scene.textures[0].file, (folder / "pictures" / "red.bmp").string());
    EXPECT_NE(session.images.find(session.scene.textures[0]), nullptr);

    Session other = makeSession(defaultScene(), ImageSource{});
    ASSERT_TRUE(openScene(other, folder / "a.json").has_value());
    EXPECT_NE(other.images.find(other.scene.textures[0]), nullptr);
    ASSERT_TRUE(openScene(other, folder / "elsewhere" / "b.json").has_value());
    EXPECT_NE(other.images.find(other.scene.textures[0]), nullptr);
}

TEST_F(Document, AModelThatIsSeenIsSelected) {
    write(folder / "sphere.json", R"({"version": 1, "models": [
        {"shape": "cube", "visible": false}, {"shape": "sphere"}]})");
    ASSERT_TRUE(openScene(session, folder / "sphere.json").has_value());
    EXPECT_EQ(session.selection.model, 1);
    write(folder / "none.json", R"({"version": 1, "models": [{"shape": "cube", "visible": false}]})");
    ASSERT_TRUE(openScene(session, folder / "none.json").has_value());
    EXPECT_EQ(session.selection.model, 0);
}

struct Bad {
    const char* name;
    const char* content; // nullptr: there is no such file
};

class BadFile : public Document, public testing::WithParamInterface<Bad> {};

TEST_P(BadFile, IsRefusedInOneSentenceAndChangesNothing) {
    const std::filesystem::path path = folder / "file.bin";
    if (GetParam().content)
        write(path, GetParam().content);
    const Scene before = session.scene;
    for (auto* open : {openFile, importImage, openScene}) {
        const Result<void> result = open(session, path);
        ASSERT_FALSE(result.has_value());
        EXPECT_FALSE(result.error().message.empty());
        EXPECT_EQ(describe(result.error()).find('\n'), std::string::npos);
    }
    EXPECT_FALSE(openArguments(session, {path}).has_value());
    EXPECT_EQ(session.scene, before);
    EXPECT_FALSE(session.history.canUndo());
    EXPECT_TRUE(session.file.empty());
}

INSTANTIATE_TEST_SUITE_P(All, BadFile,
                         testing::Values(Bad{"Missing", nullptr}, Bad{"Empty", ""},
                                         Bad{"Text", "Hello, world!"},
                                         Bad{"HalfScene", R"({"textures": [{"wrapS":)"},
                                         Bad{"HalfBmp", "BM"}),
                         [](const auto& test) { return test.param.name; });

TEST_F(Document, AFolderIsNoFile) {
    EXPECT_FALSE(openFile(session, folder.path()).has_value());
    EXPECT_FALSE(saveScene(session, folder.path()).has_value());
    EXPECT_TRUE(session.file.empty());
}

TEST_F(Document, TheCommandLineTakesASceneAndImages) {
    write(folder / "red.bmp", redBmp());
    write(folder / "scene.json", R"({"version": 1, "textures": [{"wrapS": "GL_CLAMP"}]})");
    const auto opened =
        openArguments(session, {folder / "red.bmp", folder / "scene.json", folder / "red.bmp"});
    ASSERT_TRUE(opened.has_value()) << describe(opened.error());
    ASSERT_EQ(session.scene.textures.size(), 2U);
    EXPECT_EQ(session.scene.textures[0].wrapS, Wrap::Clamp);
    EXPECT_EQ(session.scene.textures[0].source, SourceKind::File);
    EXPECT_FALSE(isDirty(session));
    EXPECT_FALSE(session.history.canUndo());
}

TEST_F(Document, ADroppedSceneAsksBeforeItReplacesChanges) {
    write(folder / "scene.json", R"({"version": 1, "textures": [{"wrapT": "GL_CLAMP"}]})");
    session.scene.textures[0].wrapS = Wrap::Clamp;
    recordEdit(session, "Wrap s");
    requestOpen(session, {folder / "scene.json"});
    EXPECT_EQ(session.dialog, Dialog::Discard);
    EXPECT_EQ(session.scene.textures[0].wrapT, Wrap::Repeat);
    undo(session);
    session.dialog = Dialog::None;
    requestOpen(session, {folder / "scene.json"});
    EXPECT_EQ(session.scene.textures[0].wrapT, Wrap::Clamp);
}

TEST_F(Document, ADroppedFileThatIsNothingIsReported) {
    write(folder / "notes.txt", "Hello");
    requestOpen(session, {folder / "notes.txt"});
    EXPECT_THAT(session.notice.text, HasSubstr("notes.txt"));
    requestOpen(session, {folder / "gone.bmp"});
    EXPECT_THAT(session.notice.text, HasSubstr("gone.bmp"));
}

} // namespace
} // namespace texplorer::ui

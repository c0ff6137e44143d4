#include "app/ui/editor/received_files.h"
#include "app/ui/files/asking.h"
#include "app/ui/files/loads.h"
#include "app/ui/files/scene_files.h"
#include "app/ui/files/scene_saving.h"
#include "app/ui/model/kept.h"
#include "app/ui/model/notice.h"
#include "tests/support/small_bmp.h"
#include "tests/support/temp_dir.h"
#include "tests/ui/edits.h"
#include "texplorer/files/file_io.h"
#include "texplorer/scene/params/json.h"

#include <fmt/core.h>
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
        waitForFiles(into);
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

TEST_F(SceneFiles, OfManyVerticesNameTheirMeshes) {
    std::string text = "o many\n";
    for (int i = 0; i < 70000; ++i)
        text += fmt::format("v {} {} 0\n", i % 300, i / 300);
    for (int i = 1; i <= 69998; i += 3)
        text += fmt::format("f {} {} {}\n", i, i + 1, i + 2);
    write(folder / "many.obj", text + "o few\nf 1 2 3\n");
    open(session, folder / "many.obj");
    ASSERT_EQ(session.document.scene.models.size(), 2U);
    const MeshData& many = session.document.scene.models[0].mesh;
    EXPECT_EQ(many.file, "many.obj");
    EXPECT_EQ(many.positions.size(), 69999U);
    EXPECT_FALSE(isDirty(session.document));
    const Scene before = session.document.scene;
    std::filesystem::create_directory(folder / "elsewhere");
    ASSERT_TRUE(saveScene(session, folder / "elsewhere" / "a.json").has_value());
    EXPECT_LT(std::filesystem::file_size(folder / "elsewhere" / "a.json"), 20000U);
    Session other(services.lend());
    open(other, folder / "elsewhere" / "a.json");
    EXPECT_EQ(other.document.scene.models[0].mesh.positions, many.positions);
    EXPECT_EQ(other.document.scene.models[1].mesh.positions.size(), 3U);

    const auto move = [&](int model) {
        take(session,
             Step{.name = "Move",
                  .edits = {edit::Set{fmt::format("models[{}].mesh.positions[0]", model), "0,0,0"}}});
    };
    move(0);
    EXPECT_THAT(session.look.notice.text.english(), HasSubstr("at most 65536 and 262144 can be edited"));
    EXPECT_EQ(session.document.scene.models[0].mesh.positions, before.models[0].mesh.positions);
    move(1);
    EXPECT_EQ(session.document.scene.models[1].mesh.file, "");
    EXPECT_EQ(session.document.scene.models[1].mesh.positions[0], glm::vec3(0));
    take(session, Undo{});
    EXPECT_EQ(session.document.scene.models[1].mesh.positions, before.models[1].mesh.positions);
    EXPECT_NE(session.document.scene.models[1].mesh.file, "");
}

TEST_F(SceneFiles, MeshesArriveInEveryStepAndInA) {
    const std::string triangle = "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n";
    write(folder / "a.json", R"({"models": [{"shape": "mesh", "mesh": {"file": "a.obj"}}]})");
    write(folder / "a.obj", triangle);
    write(folder / "b.obj", triangle + "f 1 3 2\n");
    open(session, folder / "a.json");
    keepAsA(session);
    take(session, Step{.name = "File", .edits = {edit::Set{"models[0].mesh.file", "b.obj"}}});
    take(session, Undo{}); // before it has arrived
    waitForFiles(session);
    take(session, Redo{});
    waitForFiles(session);
    EXPECT_EQ(session.document.scene.models[0].mesh.indices.size(), 6U);
    take(session, Undo{});
    session.document.images.put("a.obj", session.document.images.meshesOf("b.obj")); // as a changed file
    receiveFiles(session);
    EXPECT_EQ(session.document.scene.models[0].mesh.indices.size(), 6U);
    EXPECT_EQ(session.document.kept.scene->models[0].mesh.indices.size(), 6U);
    EXPECT_FALSE(isDirty(session.document));
}

TEST_F(SceneFiles, MeshesFollowTheirFile) {
    constexpr const char* triangle = "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n";
    write(folder / "a.json", R"({"models": [{"shape": "mesh", "mesh": {"file": "late.obj"}}]})");
    ASSERT_TRUE(openScene(session, folder / "a.json"));
    receiveFiles(session);
    EXPECT_THAT(session.look.notice.text.english(), HasSubstr("late.obj"));
    write(folder / "late.obj", triangle);
    open(session, folder / "a.json");
    EXPECT_EQ(session.document.scene.models.at(0).mesh.positions.size(), 3U);
    write(folder / "b.obj", std::string(triangle) + "f 1 3 2\n");
    take(session, Step{.name = "File", .edits = {edit::Set{"models[0].mesh.file", "b.obj"}}});
    EXPECT_TRUE(session.document.scene.models[0].mesh.positions.empty());
    receiveFiles(session);
    EXPECT_EQ(session.document.scene.models[0].mesh.indices.size(), 6U);
    take(session, Undo{});
    EXPECT_EQ(session.document.scene.models[0].mesh.indices.size(), 3U);
    take(session, Redo{});
    EXPECT_EQ(session.document.scene.models[0].mesh.indices.size(), 6U) << "it was filled in the history";
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

#include "tests/support/temp_dir.h"
#include "texplorer/base/sentence_format.h"
#include "texplorer/files/file_io.h"
#include "texplorer/scene/edit/edit.h"
#include "texplorer/scene/params/json.h"
#include "texplorer/scene/params/params.h"
#include "texplorer/scene/storage/scene_file.h"
#include "texplorer/texture/image_source.h"

#include <fmt/core.h>
#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <fstream>
#include <sys/stat.h>

namespace texplorer::mesh_file_test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

/// A square of so many vertices in each direction, in the plane z = 0 from (0, 0) to (1, 1).
std::string gridText(int count) {
    std::string text;
    const auto share = [&](int i) { return static_cast<float>(i) / static_cast<float>(count - 1); };
    for (int y = 0; y < count; ++y)
        for (int x = 0; x < count; ++x)
            text += fmt::format("v {} {} 0\nvt {} {}\n", share(x), share(y), share(x), share(y));
    for (int y = 0; y + 1 < count; ++y)
        for (int x = 0; x + 1 < count; ++x) {
            const int a = y * count + x + 1;
            const int d = a + count;
            text += fmt::format("f {0}/{0} {1}/{1} {2}/{2} {3}/{3}\n", a, a + 1, d + 1, d);
        }
    return text;
}

constexpr const char* twoParts = "v 0 0 0\nv 4 0 0\nv 4 4 0\no a\nf 1 2 3\no b\nf 3 2 1\n";

class MeshFiles : public testing::Test {
protected:
    void write(const char* name, std::string_view text) const { std::ofstream(dir / name) << text; }
    static Scene sceneWith(const std::string& file, int part = 0) {
        Scene scene = defaultScene();
        scene.models = {Model{.shape = Shape::Mesh}};
        scene.models[0].mesh.file = file;
        scene.models[0].mesh.part = part;
        return scene;
    }
    std::string problemOf(Scene scene) const {
        const Result<void> loaded = ImageSource(dir.path()).load(scene);
        EXPECT_THAT(scene.models[0].mesh.positions, testing::IsEmpty());
        return loaded ? "none" : describe(loaded.error()).english();
    }
    test::TempDir dir;
};

// The corners of the box, from (0, 0, 0) to (4, 4, 0), are moved to a distance of 2.
TEST_F(MeshFiles, HaveTheVerticesOfTheirModels) {
    write("two.obj", twoParts);
    Scene scene = sceneWith("two.obj");
    scene.models.push_back(sceneWith("two.obj", 1).models[0]);
    ImageSource images(dir.path());
    ASSERT_TRUE(images.load(scene));
    const MeshData& first = scene.models[0].mesh;
    ASSERT_EQ(first.positions.size(), 3U);
    EXPECT_NEAR(first.positions[0].x, -std::sqrt(2.0F), 1e-6F);
    EXPECT_NEAR(first.positions[2].y, std::sqrt(2.0F), 1e-6F);
    EXPECT_THAT(first.indices, ElementsAre(0, 1, 2));
    EXPECT_EQ(scene.models[1].mesh.positions[0], first.positions[2]);
    Scene again = sceneWith("two.obj");
    images.fillMeshes(again);
    EXPECT_EQ(again.models[0].mesh.positions.data(), first.positions.data()) << "they share the list";
}

TEST_F(MeshFiles, StayNamesInTheScenesText) {
    write("two.obj", twoParts);
    Scene scene = sceneWith("two.obj", 1);
    scene.models[0].mesh.primitive = Primitive::Points;
    ImageSource images(dir.path());
    ASSERT_TRUE(images.load(scene));
    const std::string text = writeScene(scene);
    EXPECT_THAT(text, AllOf(HasSubstr("\"file\": \"two.obj\",\n        \"part\": 1\n"),
                            testing::Not(HasSubstr("positions"))));
    Scene read = parseScene(text).value();
    EXPECT_NE(read, scene);
    images.fillMeshes(read);
    EXPECT_EQ(read, scene);
    renameFiles(read, [](const std::string& name) { return "../" + name; });
    EXPECT_EQ(read.models[0].mesh.file, "../two.obj");
    EXPECT_THAT(filesOf(read), testing::Contains("../two.obj"));
}

TEST_F(MeshFiles, ThatCannotBeReadAreOneSentence) {
    write("wrong.obj", "v 0 0 0\nf 1 2 3\n");
    write("picture.png", twoParts);
    std::filesystem::create_directory(dir / "folder.obj");
    ASSERT_EQ(::mkfifo((dir / "pipe.obj").c_str(), 0600), 0);
    const std::string in = "models[0].mesh.file: ";
    EXPECT_THAT(problemOf(sceneWith("gone.obj")), AllOf(HasSubstr(in), HasSubstr("gone.obj")));
    EXPECT_THAT(problemOf(sceneWith("wrong.obj")),
                AllOf(HasSubstr(in), HasSubstr("line 2: expected v from 1 to 1, found 2")));
    EXPECT_THAT(problemOf(sceneWith("picture.png")), HasSubstr("expected an OBJ file"));
    EXPECT_THAT(problemOf(sceneWith("folder.obj")), HasSubstr("folder.obj"));
    EXPECT_THAT(problemOf(sceneWith("pipe.obj")), HasSubstr("pipe.obj"));
    write("two.obj", twoParts);
    EXPECT_EQ(problemOf(sceneWith("two.obj", 2)), "none") << "a finding of the diagnosis";
    Scene hidden = sceneWith("gone.obj");
    hidden.models[0].shape = Shape::Cube;
    EXPECT_EQ(problemOf(hidden), "none");
}

TEST_F(MeshFiles, ThatAreTooLargeForAFileAreRefused) {
    write("huge.obj", "");
    std::filesystem::resize_file(dir / "huge.obj", maxObjBytes + 1);
    EXPECT_THAT(problemOf(sceneWith("huge.obj")), HasSubstr("268435457"));
}

// 200² vertices are a scene's own; of 257² the scene names the file.
TEST_F(MeshFiles, AreNamedByScenesOfLargeMeshes) {
    write("small.obj", gridText(200));
    const Result<SceneContent> small = readSceneFile(dir / "small.obj");
    ASSERT_TRUE(small) << describe(small.error());
    const Scene own = parseScene(small->text).value();
    EXPECT_EQ(own.models[0].mesh.positions.size(), 40000U);
    EXPECT_EQ(own.models[0].mesh.file, "");
    write("large.obj", gridText(257));
    const Result<SceneContent> large = readSceneFile(dir / "large.obj");
    ASSERT_TRUE(large) << describe(large.error());
    EXPECT_LT(large->text.size(), 20000U);
    Scene named = parseScene(large->text).value();
    EXPECT_EQ(named.models[0].mesh.file, "large.obj");
    ImageSource images;
    images.put("large.obj", large->meshes);
    images.fillMeshes(named);
    EXPECT_EQ(named.models[0].mesh.positions.size(), 66049U);
    EXPECT_FALSE(sceneOfObj(*large->meshes, ""));
}

TEST_F(MeshFiles, OfAMillionVerticesAreRead) {
    write("million.obj", gridText(1000));
    Scene scene = sceneWith("million.obj");
    ASSERT_TRUE(ImageSource(dir.path()).load(scene));
    const MeshData& mesh = scene.models[0].mesh;
    EXPECT_EQ(mesh.positions.size(), 1'000'000U);
    EXPECT_EQ(mesh.texCoords.size(), 1'000'000U);
    EXPECT_EQ(mesh.indices.size(), 6U * 999 * 999);
    const Scene copy = scene;
    EXPECT_EQ(copy.models[0].mesh.positions.data(), mesh.positions.data());
    const std::array edits{Edit(edit::Set{"models[0].mesh.positions[7]", "0,0,0"})};
    const Result<void> edited = makeEdits(scene, edits);
    ASSERT_FALSE(edited);
    EXPECT_EQ(
        describe(edited.error()).english(),
        "the part of million.obj has 1000000 vertices and 5988006 indices; at most 65536 and 262144 can be "
        "edited");
    EXPECT_EQ(scene, copy);
}

TEST_F(MeshFiles, WhoseVerticesAreEditedBecomeTheScenesOwn) {
    write("two.obj", twoParts);
    Scene given = sceneWith("two.obj");
    given.models.push_back(sceneWith("two.obj", 1).models[0]);
    ImageSource images(dir.path());
    ASSERT_TRUE(images.load(given));
    const auto edited = [&](const Edit& edit) {
        Scene scene = given;
        const Result<void> made = makeEdits(scene, {&edit, 1});
        EXPECT_TRUE(made) << describe(made.error());
        EXPECT_EQ(scene.models[1], given.models[1]);
        return scene.models[0].mesh;
    };
    const MeshData moved = edited(edit::Set{"models[0].mesh.positions[2]", "9,9,9"});
    EXPECT_EQ(moved.file, "");
    EXPECT_EQ(moved.positions[2], glm::vec3(9));
    EXPECT_EQ(moved.positions[1], given.models[0].mesh.positions[1]);
    EXPECT_EQ(edited(edit::Set{"models[0].texCoords0[1]", "2,3"}).file, "");
    EXPECT_EQ(edited(edit::Set{"models[0].noTexCoord0", "1"}).file, "");
    EXPECT_EQ(edited(edit::Set{"models[0].mesh.primitive", "GL_POINTS"}).file, "two.obj");
    EXPECT_EQ(edited(edit::Set{"models[0].mesh.part", "1"}).file, "two.obj");
    EXPECT_EQ(edited(edit::Set{"models[0].mesh.file", "other.obj"}).file, "other.obj");
    EXPECT_EQ(edited(edit::Set{"models[0].size", "2"}).file, "two.obj");
}

TEST_F(MeshFiles, StayWhereNoVertexOfTheirsIsEdited) {
    write("two.obj", twoParts);
    Scene scene = sceneWith("two.obj");
    ASSERT_TRUE(ImageSource(dir.path()).load(scene));
    const auto fileAfter = [](Scene edited, const char* path, const char* value) {
        const Edit edit = edit::Set{path, value};
        const Result<void> made = makeEdits(edited, {&edit, 1});
        EXPECT_TRUE(made) << describe(made.error());
        return edited.models[0].mesh.file;
    };
    Scene cube = scene;
    cube.models[0].shape = Shape::Cube;
    EXPECT_EQ(fileAfter(cube, "models[0].texCoords0[1]", "2,3"), "two.obj");
    Scene own = scene; // with vertices and coordinates of its own
    own.models[0].mesh.file.clear();
    own.models[0].texCoords[0] = TexCoords(own.models[0].mesh.positions.size(), glm::vec4(1));
    EXPECT_EQ(fileAfter(own, "models[0].mesh.file", "two.obj"), "two.obj");
}

TEST_F(MeshFiles, LeaveNoListsOfTheScenesText) {
    const Scene read = parseScene(R"({"models": [{"shape": "mesh", "mesh": {"file": "a.obj", "part": 1,
        "positions": [[0, 0, 0]], "indices": [7, 8, 9]}}]})")
                           .value();
    EXPECT_EQ(read.models[0].mesh, (MeshData{.file = "a.obj", .part = 1}));
}

TEST_F(MeshFiles, AreNotChangedByKeyFrames) {
    write("two.obj", twoParts);
    Scene scene = sceneWith("two.obj");
    ASSERT_TRUE(ImageSource(dir.path()).load(scene));
    for (const char* path : {"models[0].mesh.file", "models[0].mesh.part", "models[0].mesh.positions[0]"})
        EXPECT_THAT(checkMovable(scene, path, "0").error().message.english(), HasSubstr("key frames can't"))
            << path;
    EXPECT_TRUE(checkMovable(scene, "models[0].mesh.primitive", "GL_POINTS"));
}

} // namespace
} // namespace texplorer::mesh_file_test

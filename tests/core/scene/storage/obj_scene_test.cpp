#include "tests/support/temp_dir.h"
#include "texplorer/base/sentence_format.h"
#include "texplorer/files/file_io.h"
#include "texplorer/mesh/obj_lines.h"
#include "texplorer/scene/params/json.h"
#include "texplorer/scene/storage/obj_scene.h"
#include "texplorer/scene/storage/scene_file.h"

#include <glm/geometric.hpp>
#include <gmock/gmock.h>

#include <fstream>
#include <span>

namespace texplorer::obj_scene_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class ObjScene : public testing::Test {
protected:
    void write(const char* name, const std::string& text) const { std::ofstream(dir / name) << text; }
    static Result<Scene> sceneIn(const std::filesystem::path& file) {
        return readSceneFile(file).and_then([](const SceneContent& read) { return parseScene(read.text); });
    }
    test::TempDir dir;
};

constexpr const char* box = "mtllib box.mtl\nv 100 0 0\nv 104 0 0\nv 104 2 0\nvt 0 0\nvt 1 0\nvt 1 1\n"
                            "o lid\nusemtl wood\nf 1/1 2/2 3/3\no base\nusemtl stone\nf 1/1 3/3 2/2\n"
                            "o plate\nusemtl plain\nf 1 2 3\n";

TEST_F(ObjScene, HasAPassForEachImage) {
    write("box.obj", box);
    write("box.mtl", "newmtl wood\nmap_Kd wood.png\nnewmtl stone\nmap_Kd wood.png\nKd 1 0 0\nnewmtl plain\n");
    const Result<Scene> scene = sceneIn(dir / "box.obj");
    ASSERT_TRUE(scene) << describe(scene.error());
    ASSERT_EQ(scene->models.size(), 3U);
    EXPECT_EQ(scene->models[0].name, "lid");
    EXPECT_FALSE(scene->models[0].ownMaterial);
    EXPECT_EQ(scene->models[1].material.color, glm::vec4(1, 0, 0, 1));
    ASSERT_EQ(scene->passes.size(), 2U);
    EXPECT_THAT(scene->passes[0].models, ElementsAre(0, 1));
    EXPECT_THAT(scene->passes[1].models, ElementsAre(2));
    EXPECT_EQ(scene->textures[0].file, "wood.png");
    EXPECT_EQ(scene->textures[1].source, SourceKind::Pattern);
    EXPECT_EQ(scene->passes[1].units[0].texture, 1);
}

TEST_F(ObjScene, HasImagesBesideTheirLibrary) {
    write("box.obj",
          "mtllib parts/box.mtl\nmtllib plain.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nusemtl wood\nf 1 2 3\n"
          "usemtl stone\nf 1 2 3\n");
    std::filesystem::create_directory(dir / "parts");
    write("parts/box.mtl", "newmtl wood\nmap_Kd images\\wood.png\n");
    write("plain.mtl", "newmtl stone\nmap_Kd stone.png\n");
    const Result<Scene> scene = sceneIn(dir / "box.obj");
    ASSERT_TRUE(scene) << describe(scene.error());
    ASSERT_EQ(scene->textures.size(), 2U);
    EXPECT_EQ(scene->textures[0].file, "parts/images/wood.png");
    EXPECT_EQ(scene->textures[1].file, "stone.png");
}

// The box from (100, 0, 0) to (104, 2, 0) has half a diagonal of the square root of 5.
TEST_F(ObjScene, IsInTheMiddle) {
    write("box.obj", box);
    const Result<Scene> scene = sceneIn(dir / "box.obj");
    ASSERT_TRUE(scene) << describe(scene.error());
    const std::vector<glm::vec3>& positions = scene->models[0].mesh.positions;
    EXPECT_NEAR(positions[0].x, -4 / std::sqrt(5.0F), 1e-5F);
    EXPECT_NEAR(positions[0].y, -2 / std::sqrt(5.0F), 1e-5F);
    EXPECT_NEAR(glm::length(positions[2]), 2, 1e-5F);
}

TEST_F(ObjScene, WithMoreImagesThanPassesIsDrawnWithTheFirst) {
    std::string text = "mtllib many.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\n";
    std::string library;
    for (int i = 0; i < 10; ++i) {
        library += "newmtl m" + std::to_string(i) + "\nmap_Kd " + std::to_string(i) + ".png\n";
        text += "usemtl m" + std::to_string(i) + "\nf 1 2 3\n";
    }
    write("many.obj", text);
    write("many.mtl", library);
    const Result<Scene> scene = sceneIn(dir / "many.obj");
    ASSERT_TRUE(scene) << describe(scene.error());
    EXPECT_EQ(scene->passes.size(), maxPasses);
    EXPECT_THAT(scene->passes.back().models, ElementsAre(7, 8, 9));
}

TEST_F(ObjScene, NamesItsLibraries) {
    write("box.obj", box);
    EXPECT_EQ(readSceneFile(dir / "box.obj")->notes.size(), 1U);
    write("box.mtl", "newmtl wood\nnewmtl stone\nnewmtl plain\n");
    EXPECT_THAT(readSceneFile(dir / "box.obj")->meshes->libraries, ElementsAre(dir / "box.mtl"));
}

TEST_F(ObjScene, ThatIsWrongNamesTheFile) {
    write("wrong.obj", "v 0 0 0\nf 1 2 3\n");
    const Result<Scene> scene = sceneIn(dir / "wrong.obj");
    ASSERT_FALSE(scene);
    EXPECT_THAT(describe(scene.error()).english(),
                testing::AllOf(HasSubstr("wrong.obj"), HasSubstr("line 2: expected v from 1 to 1, found 2")));
    EXPECT_FALSE(readSceneFile(dir / "gone.obj"));
}

TEST(ObjContent, BeginsWithOneOfItsWords) {
    const auto begins = [](std::string_view text) { return beginsAsObj(std::as_bytes(std::span(text))); };
    EXPECT_TRUE(begins("# a comment\n\n  mtllib x.mtl\n"));
    EXPECT_TRUE(begins("v 0 0 0"));
    EXPECT_FALSE(begins("version 1\nv 0 0 0\n"));
    EXPECT_FALSE(begins("{\n"));
    EXPECT_FALSE(begins("# only a comment"));
}

} // namespace
} // namespace texplorer::obj_scene_test

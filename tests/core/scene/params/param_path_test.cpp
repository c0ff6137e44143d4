#include "texplorer/scene/params/params.h"

#include <gtest/gtest.h>

#include <tuple>

namespace texplorer::param_path_test {
namespace {

struct Refusal {
    const char* name;
    const char* path;
    const char* text;
    const char* error;
};

class RefusedPaths : public testing::TestWithParam<Refusal> {};

TEST_P(RefusedPaths, SayWhatWouldBeAcceptedAndChangeNothing) {
    Scene scene = defaultScene();
    const auto set = setParam(scene, GetParam().path, GetParam().text);
    ASSERT_FALSE(set);
    EXPECT_EQ(describe(set.error()), GetParam().error);
    EXPECT_EQ(scene, defaultScene());
}

INSTANTIATE_TEST_SUITE_P(
    Scene, RefusedPaths,
    testing::Values(
        Refusal{
            "Empty", "", "1",
            "no such parameter; expected one of view, light, material, models, textures, passes, timeline"},
        Refusal{"Typo", "textures[0].minfilter", "GL_LINEAR",
                R"(textures[0].minfilter: no such parameter; did you mean "minFilter"?)"},
        Refusal{"WithoutWhatItBelongsTo", "minFilter", "GL_LINEAR",
                "minFilter: no such parameter; did you mean textures[0].minFilter?"},
        Refusal{"WithoutItsUnit", "passes[0].envMode", "GL_ADD",
                "passes[0].envMode: no such parameter; did you mean passes[0].units[0].envMode?"},
        Refusal{"TypoOfAList", "texture[0].minFilter", "GL_LINEAR",
                R"(texture[0]: no such parameter; did you mean "textures"?)"},
        Refusal{
            "Unknown", "material.roughness", "1",
            "material.roughness: no such parameter; expected one of color, colorMaterial, ambient, diffuse, specular, emission, shininess, shadeModel"},
        Refusal{"NoIndex", "textures.minFilter", "GL_LINEAR",
                "textures: an index is needed, as in textures[0]; the scene has 1"},
        Refusal{"IndexTooLarge", "textures[3].minFilter", "GL_LINEAR",
                "textures[3]: expected an existing index, counted from 0; the scene has 1"},
        Refusal{"IndexHuge", "textures[99999999999999999999].minFilter", "GL_LINEAR",
                "textures[99999999999999999999]: expected an existing index, counted from 0; the "
                "scene has 1"},
        Refusal{"IndexNegative", "textures[-1].minFilter", "GL_LINEAR",
                R"(textures[-1]: expected a number in the brackets, found "-1")"},
        Refusal{"IndexEmpty", "textures[].minFilter", "GL_LINEAR",
                R"(textures[]: expected a number in the brackets, found "")"},
        Refusal{"ModeThatTheCoordinateLacks", "passes[0].units[0].texGenQ.mode", "GL_SPHERE_MAP",
                "passes[0].units[0].texGenQ.mode: expected one of GL_EYE_LINEAR, GL_OBJECT_LINEAR, found "
                "\"GL_SPHERE_MAP\""},
        Refusal{"IndexOfUnits", "passes[0].units[4].envMode", "GL_ADD",
                "passes[0].units[4]: expected an existing index, counted from 0; the pass has 4"},
        Refusal{"IndexOfMatrix", "passes[0].units[0].matrix[0].op", "scale",
                "passes[0].units[0].matrix[0]: expected an existing index, counted from 0; the "
                "unit has 0"},
        Refusal{"NewUnit", "passes[0].units[+].envMode", "GL_ADD",
                "passes[0].units: it already has 4 elements"},
        Refusal{
            "NewStepOfNothing", "textures[0].preparation[+].op", "nothing",
            "textures[0].preparation[0].op: expected one of scale, invert, luminance, luminance-to-alpha, "
            "alpha-from, swizzle, premultiply, spread, sharpen, resize, normals, found \"nothing\""},
        Refusal{"IndexOnAStruct", "view[0].azimuth", "1", "view[0]: it is not a list: expected no index"},
        Refusal{"IndexOnAValue", "view.azimuth[0]", "1",
                "view.azimuth[0]: it is a single value: expected no index"},
        Refusal{"OpenBracket", "textures[0.minFilter", "1",
                R"(textures[0: no such parameter; did you mean "textures"?)"},
        Refusal{
            "TooShort", "material", "1",
            "material: it has parameters of its own; expected one of color, colorMaterial, ambient, diffuse, specular, emission, shininess, shadeModel"},
        Refusal{"TooLong", "view.azimuth.degrees", "1",
                "view.azimuth: it is a value without parts: expected the path to end here"},
        Refusal{"Value", "view.azimuth", "north",
                R"(view.azimuth: expected a number from -360 to 360 deg, found "north")"},
        Refusal{
            "NoSuchTexture", "passes[0].units[0].texture", "1",
            "passes[0].units[0].texture: an enabled unit needs an existing texture: it uses number 1, the "
            "scene has 1 texture"},
        Refusal{"TexCoordIndex", "models[0].texCoords0[24]", "0,0",
                "models[0].texCoords0[24]: the cube has 24 vertices, expected 0 to 23"},
        Refusal{"TexCoordNoNumber", "models[0].texCoords0[a]", "0,0",
                R"(models[0].texCoords0[a]: expected the number of a vertex in the brackets, found "a")"},
        Refusal{
            "TexCoordValue", "models[0].texCoords0[5]", "0.2",
            R"(models[0].texCoords0[5]: expected 2 to 4 finite numbers separated by commas, found "0.2")"},
        Refusal{
            "TexCoordInfinite", "models[0].texCoords0[5]", "inf,0",
            R"(models[0].texCoords0[5]: expected 2 to 4 finite numbers separated by commas, found "inf,0")"},
        Refusal{"LeftOutOfNoVertex", "models[0].noTexCoord0", "2,24",
                "models[0].noTexCoord0: there is no vertex 24, the cube has 24 vertices"},
        Refusal{"LeftOutTwice", "models[0].noTexCoord3", "2,3,2",
                "models[0].noTexCoord3: expected each vertex once, found 2 twice"},
        Refusal{"LeftOutIndex", "models[0].noTexCoord0[0]", "1",
                "models[0].noTexCoord0[0]: it is set as a whole: expected no index"},
        Refusal{"TexCoordCount", "models[0].texCoords0", "0,0;1,0",
                "models[0].texCoords0: expected 24 coordinates, one for each vertex of the cube, or none; "
                "found 2"}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(ParamPath, AKeyFrameAcceptsTheNumbersThatSettingDoes) {
    Scene scene = defaultScene();
    scene.models[0].shape = Shape::Mesh;
    scene.models[0].mesh = {.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, .indices = {0, 1, 2}};
    for (const auto& [path, fine, wrong] :
         {std::tuple("models[0].mesh.indices", "2,1,0", "0,1,3"),
          std::tuple("models[0].mesh.indices[1]", "2", "3"), std::tuple("models[0].noTexCoord0", "2,0", "3"),
          std::tuple("models[1].noTexCoord3", "560", "4,4"), std::tuple("passes[0].models", "1,0", "2")}) {
        Scene edited = scene;
        EXPECT_TRUE(checkMovable(scene, path, fine)) << path;
        EXPECT_TRUE(setParam(edited, path, fine)) << path;
        const Result<void> moved = checkMovable(scene, path, wrong);
        const Result<void> set = setParam(edited, path, wrong);
        ASSERT_FALSE(moved) << path;
        ASSERT_FALSE(set) << path;
        EXPECT_EQ(describe(moved.error()), describe(set.error()));
    }
}

TEST(ParamPath, SetsOneParameter) {
    Scene scene = defaultScene();
    ASSERT_TRUE(setParam(scene, "textures[0].minFilter", "GL_NEAREST"));
    Scene expected = defaultScene();
    expected.textures[0].minFilter = MinFilter::Nearest;
    EXPECT_EQ(scene, expected);
}

TEST(ParamPath, SetsAParameterOfANewElement) {
    Scene scene = defaultScene();
    ASSERT_TRUE(setParam(scene, "textures[0].preparation[+].op", "spread"));
    ASSERT_TRUE(setParam(scene, "textures[0].preparation[+].amount", "3"));
    EXPECT_EQ(scene.textures[0].preparation,
              (std::vector<ImageStep>{{.op = ImageOp::Spread}, {.op = ImageOp::Scale, .amount = 3}}));
    scene.textures[0].preparation.resize(maxImageSteps);
    EXPECT_FALSE(setParam(scene, "textures[0].preparation[+].op", "spread"));
    EXPECT_FALSE(getParam(scene, "textures[0].preparation[+].op")) << "there is nothing to read";
}

TEST(ParamPath, TexCoordsOfAModelAreFilledFromItsMeshFirst) {
    Scene scene = defaultScene();
    const Mesh cube = makeMesh({Shape::Cube, 32, 16});
    EXPECT_EQ(getParam(scene, "models[0].texCoords0[5]").value_or("?"),
              formatTexCoord(cube.vertices[5].texCoord));

    ASSERT_TRUE(setParam(scene, "models[0].texCoords0[5]", "0.2,0.3"));
    const TexCoords& list = scene.models[0].texCoords[0];
    ASSERT_EQ(list.size(), 24U);
    for (std::size_t i = 0; i < list.size(); ++i)
        EXPECT_EQ(list[i], i == 5 ? glm::vec4(0.2F, 0.3F, 0, 1) : cube.vertices[i].texCoord) << i;
    EXPECT_TRUE(scene.models[0].texCoords[1].empty());
    EXPECT_EQ(getParam(scene, "models[0].texCoords0[5]").value_or("?"), "0.2,0.3");

    ASSERT_TRUE(setParam(scene, "models[0].texCoords0", ""));
    EXPECT_EQ(scene, defaultScene());
}

TEST(ParamPath, VerticesOfAMeshAreSetOneByOne) {
    Scene scene = defaultScene();
    scene.models[0].shape = Shape::Mesh;
    MeshData& mesh = scene.models[0].mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.colors = {{1, 0, 0, 1}, {0, 1, 0, 0.5F}, {0, 0, 1, 1}};
    mesh.indices = {0, 1, 2};
    ASSERT_TRUE(setParam(scene, "models[0].mesh.positions[1]", "2,0.5,-1"));
    EXPECT_THAT(mesh.positions,
                testing::ElementsAre(glm::vec3(0), glm::vec3(2, 0.5F, -1), glm::vec3(0, 1, 0)));
    ASSERT_TRUE(setParam(scene, "models[0].mesh.indices[2]", "1"));
    EXPECT_THAT(mesh.indices, testing::ElementsAre(0, 1, 1));
    EXPECT_EQ(getParam(scene, "models[0].mesh.positions[1]").value_or("?"), "2,0.5,-1");
    EXPECT_EQ(getParam(scene, "models[0].mesh.colors[1]").value_or("?"), "0,1,0,0.5");
    const auto refused = [&](std::string_view path, std::string_view text) {
        const auto set = setParam(scene, path, text);
        return set ? Sentence("set") : describe(set.error());
    };
    EXPECT_EQ(refused("models[0].mesh.positions[3]", "0,0,0"),
              "models[0].mesh.positions[3]: expected an existing index, counted from 0; the list has 3");
    EXPECT_EQ(refused("models[0].mesh.normals[0]", "0,0,1"),
              "models[0].mesh.normals[0]: expected an existing index, counted from 0; the list has 0");
    EXPECT_EQ(refused("models[0].mesh.positions[0]", "0,0,0;1,1,1"),
              "models[0].mesh.positions[0]: expected the value of one element, found 2");
    EXPECT_EQ(refused("models[0].mesh.positions[0]", ""),
              "models[0].mesh.positions[0]: expected the value of one element, found 0");
    EXPECT_EQ(mesh.positions.size(), 3U);
    Scene moved = scene;
    ASSERT_TRUE(putBetween(moved, "models[0].mesh.positions[0]", "0,0,0", "1,2,4", 0.5));
    EXPECT_EQ(moved.models[0].mesh.positions[0], glm::vec3(0.5F, 1, 2));
    EXPECT_TRUE(checkMovable(scene, "models[0].mesh.positions[0]", "1,1,1"));
    EXPECT_FALSE(checkMovable(scene, "models[0].mesh.positions[0]", "1,1"));
}

TEST(ParamPath, ADisabledUnitMayAskForATextureThatComesLater) {
    Scene scene;
    ASSERT_TRUE(setParam(scene, "passes[0].units[1].texture", "5"));
    const auto enabled = setParam(scene, "passes[0].units[1].enabled", "true");
    ASSERT_FALSE(enabled);
    EXPECT_EQ(enabled.error().message,
              "an enabled unit needs an existing texture: it uses number 5, the scene has 0 textures");
    EXPECT_FALSE(scene.passes[0].units[1].enabled);
}

TEST(ParamPath, VisitsInTableOrder) {
    std::vector<std::string> paths;
    forEachParam(defaultScene(),
                 [&](const std::string& path, const ParamRow&, const Value&) { paths.push_back(path); });
    EXPECT_EQ(paths.front(), "view.azimuth");
    EXPECT_EQ(paths.back(), "passes[0].units[3].emboss.carrier");
    EXPECT_EQ(std::ranges::count(paths, "models[1].texCoords3"), 1);
}

} // namespace
} // namespace texplorer::param_path_test

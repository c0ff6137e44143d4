#include "texplorer/scene/params/json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace texplorer::json_parse_test {
namespace {

struct Refusal {
    const char* name;
    std::string json;
    const char* where;
    const char* message; ///< the beginning of it
};

std::string repeat(std::string_view text, std::size_t count, std::string_view separator = "") {
    std::string all;
    for (std::size_t i = 0; i < count; ++i)
        all.append(i == 0 ? "" : separator).append(text);
    return all;
}

class RefusedScenes : public testing::TestWithParam<Refusal> {};

TEST_P(RefusedScenes, SayWhereAndWhatWouldBeAccepted) {
    const auto scene = parseScene(GetParam().json);
    ASSERT_FALSE(scene);
    EXPECT_EQ(scene.error().where, GetParam().where) << scene.error().message;
    EXPECT_THAT(scene.error().message, testing::StartsWith(GetParam().message));
    EXPECT_LT(scene.error().message.english().size(), 400U) << "one sentence, whatever the file holds";
    EXPECT_EQ(scene.error().message.english().find('\n'), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(
    Shape, RefusedScenes,
    testing::Values(
        Refusal{"EmptyFile", "", "", "expected an object, found an empty file"},
        Refusal{"Blank", " \n", "line 2, column 1", "the file ends; expected a value"},
        Refusal{"RootArray", "[]", "", "expected an object, found an array"},
        Refusal{"RootNumber", "5", "", "expected an object, found 5"},
        Refusal{"RootText", "\"scene\"", "", "expected an object, found \"scene\""},
        Refusal{"RootNull", "null", "", "expected an object, found null"},
        Refusal{"Truncated", R"({"view": {"azimuth": 5)", "line 1, column 23",
                "the file ends in the middle of an object; expected ',' or '}'"},
        Refusal{"TruncatedKey", R"({"view": {"azimuth": 5},)", "line 1, column 25",
                "the file ends in the middle of an object; expected a key in quotes"},
        Refusal{"TruncatedBeforeTheValue", R"({"view":)", "line 1, column 9",
                "the file ends in the middle of an object; expected a value"},
        Refusal{"TruncatedArray", R"({"models": [{})", "line 1, column 15",
                "the file ends in the middle of an array; expected ',' or ']'"},
        Refusal{"TruncatedText", R"({"vie)", "line 1, column 6",
                "the file ends in the middle of a text; expected a quote"},
        Refusal{"NoColon", R"({"view" {}})", "line 1, column 9", "expected ':' after the key, found '{'"},
        Refusal{"KeyWithoutQuotes", R"({view: {}})", "line 1, column 2",
                "expected a key in quotes, found 'view'"},
        Refusal{"MissingComma", "{\"view\": {}\n \"light\": {}}", "line 2, column 2",
                "expected ',' or '}', found a text in quotes"},
        Refusal{"TrailingComma", R"({"view": {},})", "line 1, column 13",
                "expected a key in quotes, found '}'"},
        Refusal{"WordAfterTheRoot", R"({"version": 1} x)", "line 1, column 16",
                "expected the end of the file, found 'x'"},
        Refusal{"HalfAWord", R"({"version": nul})", "line 1, column 13", "expected a value, found 'nul'"},
        Refusal{"TwoRoots", "{} {}", "line 1, column 4", "expected the end of the file, found '{'"},
        Refusal{"Comment", "{ // view\n}", "line 1, column 3", "expected a key in quotes"},
        Refusal{"Nan", R"({"view": {"azimuth": NaN}})", "line 1, column 22", "expected a value, found 'NaN'"},
        Refusal{"InvalidUtf8", "{\"textures\": [{\"file\": \"a\xff\"}]}", "line 1, column 26",
                "expected UTF-8, found the byte FF"},
        Refusal{"InvalidUtf8Key", "{\"\xc3\x28\": 1}", "line 1, column 3",
                "expected UTF-8, found the byte C3"},
        Refusal{"Utf16", std::string("\xff\xfe{\0}\0", 6), "", "expected UTF-8, found UTF-16"},
        Refusal{"DeepArrays", repeat("[", 100000), "", "expected an object, found an array"},
        Refusal{"DeepObjects", repeat(R"({"view":)", 100000), "/view/view", "unknown key; expected one of"},
        Refusal{"DeepInAValue", R"({"view": {"target": )" + repeat("[", 100000), "/view/target/0",
                "expected a number between -3.4e38 and 3.4e38, found an array"},
        Refusal{"DeepInTexCoords", R"({"models": [{"texCoords0": )" + repeat("[", 100000),
                "/models/0/texCoords0/0/0", "expected a number between -3.4e38 and 3.4e38, found an array"}),
    [](const auto& test) { return std::string(test.param.name); });

INSTANTIATE_TEST_SUITE_P(
    Keys, RefusedScenes,
    testing::Values(
        Refusal{"Typo", R"({"textures": [{"minfilter": "GL_LINEAR"}]})", "/textures/0/minfilter",
                R"(unknown key; did you mean "minFilter"?)"},
        Refusal{
            "Unknown", R"({"camera": {}})", "/camera",
            "unknown key; expected one of version, view, light, material, models, textures, passes, timeline"},
        Refusal{"VersionBelowTheRoot", R"({"view": {"version": 1}})", "/view/version", "unknown key"},
        Refusal{"Twice", R"({"view": {"azimuth": 1, "distance": 2, "azimuth": 3}})", "/view/azimuth",
                R"(expected each key once, found "azimuth" twice)"},
        Refusal{"ListTwice", R"({"textures": [], "textures": []})", "/textures", "expected each key once"},
        Refusal{"VersionTwice", R"({"version": 1, "version": 1})", "/version", "expected each key once"},
        Refusal{"Slash", R"({"a/b~c": 1})", "/a~1b~0c", "unknown key"},
        Refusal{"Empty", R"({"": 1})", "", "unknown key"},
        Refusal{"Long", "{\"" + repeat("k", 1000000) + "\": 1}",
                "/kkkkkkkkkkkkkkkkkkkkkkkkkkkkkkkkkkkkkkkk...", "unknown key"}),
    [](const auto& test) { return std::string(test.param.name); });

INSTANTIATE_TEST_SUITE_P(
    Version, RefusedScenes,
    testing::Values(Refusal{"Future", R"({"version": 2, "weather": "sunny"})", "/version",
                            "the file has version 2, but this Texplorer reads versions up to 1"},
                    Refusal{"Zero", R"({"version": 0})", "/version", "expected version 1, found 0"},
                    Refusal{"Text", R"({"version": "1"})", "/version", R"(expected version 1, found "1")"},
                    Refusal{"Fraction", R"({"version": 1.5})", "/version", "expected version 1, found 1.5"},
                    Refusal{"Object", R"({"version": {}})", "/version",
                            "expected version 1, found an object"},
                    Refusal{"Array", R"({"version": []})", "/version", "expected version 1, found an array"}),
    [](const auto& test) { return std::string(test.param.name); });

INSTANTIATE_TEST_SUITE_P(
    Values, RefusedScenes,
    testing::Values(
        Refusal{"TextForANumber", R"({"view": {"azimuth": "5"}})", "/view/azimuth",
                R"(expected a number from -360 to 360 deg, found "5")"},
        Refusal{"NullForANumber", R"({"view": {"azimuth": null}})", "/view/azimuth",
                "expected a number from -360 to 360 deg, found null"},
        Refusal{"ArrayForANumber", R"({"view": {"azimuth": [5]}})", "/view/azimuth",
                "expected a number from -360 to 360 deg, found an array"},
        Refusal{"ObjectForANumber", R"({"view": {"azimuth": {}}})", "/view/azimuth",
                "expected a number from -360 to 360 deg, found an object"},
        Refusal{"NumberForAnObject", R"({"view": 5})", "/view", "expected an object, found 5"},
        Refusal{"ArrayForAnObject", R"({"view": []})", "/view", "expected an object, found an array"},
        Refusal{"ObjectForAList", R"({"textures": {}})", "/textures", "expected an array, found an object"},
        Refusal{"NumberForAList", R"({"textures": 1})", "/textures", "expected an array, found 1"},
        Refusal{"NumberInAList", R"({"textures": [{}, 1]})", "/textures/1", "expected an object, found 1"},
        Refusal{"NumberForABool", R"({"passes": [{"blend": 1}]})", "/passes/0/blend",
                "expected true or false, found 1"},
        Refusal{"BoolForANumber", R"({"view": {"azimuth": true}})", "/view/azimuth",
                "expected a number from -360 to 360 deg, found true"},
        Refusal{"Overflow", R"({"view": {"azimuth": 1e999}})", "/view/azimuth",
                "expected a number from -360 to 360 deg, found 1e999"},
        Refusal{"OverflowInAColor", R"({"view": {"background": [0, 0, -1e39, 1]}})", "/view/background/2",
                "expected a number between -3.4e38 and 3.4e38, found -1e39"},
        Refusal{"OutOfRange", R"({"textures": [{}, {"maxAnisotropy": 17}]})", "/textures/1/maxAnisotropy",
                "expected a number from 1 to 16, found 17"},
        Refusal{"ColorOutOfRange", R"({"view": {"background": [0, 0, 1.5, 1]}})", "/view/background",
                "expected 4 numbers (red, green, blue, alpha), each from 0 to 1, found 1.5"},
        Refusal{"ColorTooShort", R"({"view": {"background": [0, 0, 0]}})", "/view/background",
                "expected 4 numbers (red, green, blue, alpha), each from 0 to 1, found 3"},
        Refusal{"ColorTooLong", R"({"view": {"background": [0, 0, 0, 0, 0]}})", "/view/background/4",
                "expected 4 numbers (red, green, blue, alpha), each from 0 to 1, found more than 4"},
        Refusal{"VectorTooLong", R"({"view": {"target": [0, 0, 0, 0]}})", "/view/target/3",
                "expected 3 numbers, each from -1000 to 1000, found more than 3"},
        Refusal{"TextInAVector", R"({"view": {"target": [0, "0", 0]}})", "/view/target/1",
                R"(expected a number between -3.4e38 and 3.4e38, found "0")"},
        Refusal{"BillionSlices", R"({"models": [{"shape": "sphere", "slices": 1000000000}]})",
                "/models/0/slices", "expected a whole number from 3 to 256, found 1000000000"},
        Refusal{"HugeSlices", R"({"models": [{"slices": 10000000000000000000}]})", "/models/0/slices",
                "expected a whole number from 3 to 256, found 10000000000000000000"},
        Refusal{"SmallestWhole", R"({"passes": [{"units": [{"texture": -9223372036854775808}]}]})",
                "/passes/0/units/0/texture",
                "expected a whole number from 0 to 63, found -9223372036854775808"},
        Refusal{"WholeThatFitsNoInt", R"({"passes": [{"units": [{"texture": 4294967296}]}]})",
                "/passes/0/units/0/texture", "expected a whole number from 0 to 63, found 4294967296"},
        Refusal{"FractionForAWhole", R"({"models": [{"slices": 4.5}]})", "/models/0/slices",
                "expected a whole number from 3 to 256, found 4.5"},
        Refusal{
            "EnumTypo", R"({"textures": [{"wrapS": "GL_REPEET"}]})", "/textures/0/wrapS",
            R"(expected one of GL_REPEAT, GL_MIRRORED_REPEAT, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_BORDER, GL_CLAMP, )"
            R"(found "GL_REPEET"; did you mean "GL_REPEAT"?)"},
        Refusal{"EnumNumber", R"({"textures": [{"magFilter": 9729}]})", "/textures/0/magFilter",
                "expected one of GL_NEAREST, GL_LINEAR, found 9729"},
        Refusal{"EnumWithBlanks", R"({"textures": [{"magFilter": " GL_LINEAR"}]})", "/textures/0/magFilter",
                "expected one of GL_NEAREST, GL_LINEAR, found"},
        Refusal{"FileWithZeroByte", R"({"textures": [{"file": "a\u0000b"}]})", "/textures/0/file",
                "expected UTF-8 text of at most 4096 bytes, found a zero byte in it"},
        Refusal{"LongFile", R"({"textures": [{"file": ")" + repeat("a", 5000) + "\"}]}", "/textures/0/file",
                "expected UTF-8 text of at most 4096 bytes, found 5000 bytes"}),
    [](const auto& test) { return std::string(test.param.name); });

INSTANTIATE_TEST_SUITE_P(
    Counts, RefusedScenes,
    testing::Values(
        Refusal{"NoPass", R"({"passes": []})", "/passes", "expected 1 to 8 elements, found 0"},
        Refusal{"ManyTextures", R"({"textures": [)" + repeat("{}", 65, ",") + "]}", "/textures/64",
                "expected at most 64 elements, found more"},
        Refusal{"ManyModels", R"({"models": [)" + repeat("{}", 1000000, ",") + "]}", "/models/16",
                "expected at most 16 elements, found more"},
        Refusal{"FiveUnits", R"({"passes": [{"units": [{}, {}, {}, {}, {}]}]})", "/passes/0/units/4",
                "expected at most 4 elements, found more"},
        Refusal{"ManyMatrixSteps",
                R"({"passes": [{"units": [{"matrix": [)" + repeat("{}", 33, ",") + "]}]}]}",
                "/passes/0/units/0/matrix/32", "expected at most 32 elements, found more"},
        Refusal{"FewTexCoords", R"({"models": [{}, {"texCoords1": [[0, 0], [1, 0]]}]})",
                "/models/1/texCoords1",
                "expected 24 coordinates, one for each vertex of the cube, or none; found 2"},
        Refusal{"TexCoordsOfAnotherShape",
                R"({"models": [{"texCoords0": [)" + repeat("[0, 0]", 24, ",") + R"(], "shape": "quad"}]})",
                "/models/0/texCoords0",
                "expected 4 coordinates, one for each vertex of the quad, or none; found 24"},
        Refusal{"LeftOutOfNoVertex", R"({"models": [{"shape": "quad", "noTexCoord1": [0, 4]}]})",
                "/models/0/noTexCoord1/1", "there is no vertex 4, the quad has 4 vertices"},
        Refusal{"LeftOutTwice", R"({"models": [{}, {"noTexCoord0": [5, 5]}]})", "/models/1/noTexCoord0/1",
                "expected each vertex once, found 5 twice"},
        Refusal{"EndlessTexCoords", R"({"models": [{"texCoords0": [)" + repeat("[0,0]", 1000000, ","),
                "/models/0/texCoords0/66049", "expected at most 66049 elements, found more"},
        Refusal{"TexCoordOfOne", R"({"models": [{"texCoords0": [[0, 0], [1]]}]})", "/models/0/texCoords0/1",
                "expected an array of 2 to 4 numbers, found 1"},
        Refusal{"TexCoordOfFive", R"({"models": [{"texCoords0": [[0, 0, 0, 1, 1]]}]})",
                "/models/0/texCoords0/0/4",
                "expected 2 to 4 finite numbers for each vertex, found more than 4"},
        Refusal{"TexCoordNumber", R"({"models": [{"texCoords0": [0, 0]}]})", "/models/0/texCoords0/0",
                "expected an array of 2 to 4 numbers, found 0"},
        Refusal{"TexCoordOverflow", R"({"models": [{"texCoords0": [[0, 1e999]]}]})",
                "/models/0/texCoords0/0/1", "expected a number between -3.4e38 and 3.4e38, found 1e999"},
        Refusal{"NoSuchTexture", R"({"passes": [{"units": [{}, {"enabled": true, "texture": 1}]}]})",
                "/passes/0/units/1/texture",
                "an enabled unit needs an existing texture: it uses number 1, the scene has 1 texture"},
        Refusal{"NoTextures", R"({"textures": []})", "/passes/0/units/0/texture",
                "an enabled unit needs an existing texture: it uses number 0, the scene has 0 textures"}),
    [](const auto& test) { return std::string(test.param.name); });

/// A scene whose only model has this mesh.
std::string sceneOfMesh(const std::string& members) {
    return R"({"models": [{"shape": "mesh", "mesh": {)" + members + "}}]}";
}
std::string twoPositionsAnd(const std::string& members) {
    return sceneOfMesh(R"("positions": [[0, 0, 0], [1, 0, 0]], )" + members);
}

INSTANTIATE_TEST_SUITE_P(
    Meshes, RefusedScenes,
    testing::Values(
        Refusal{"ManyPositions", sceneOfMesh(R"("positions": [)" + repeat("[0,0,0]", 65537, ",") + "]"),
                "/models/0/mesh/positions/65536", "expected at most 65536 elements, found more"},
        Refusal{"EndlessNormals", R"({"models": [{"mesh": {"normals": [)" + repeat("[0,0,1]", 1000000, ","),
                "/models/0/mesh/normals/65536", "expected at most 65536 elements, found more"},
        Refusal{"EndlessIndices", R"({"models": [{"mesh": {"indices": [)" + repeat("0", 1000000, ","),
                "/models/0/mesh/indices/262144", "expected at most 262144 elements, found more"},
        Refusal{"NoSuchPosition", twoPositionsAnd(R"("indices": [0, 1, 2, 3])"), "/models/0/mesh/indices/2",
                "expected the number of a position (the mesh has 2), found 2"},
        Refusal{"IndexWithoutPositions", sceneOfMesh(R"("indices": [0])"), "/models/0/mesh/indices/0",
                "expected the number of a position (the mesh has 0), found 0"},
        Refusal{"NegativeIndex", twoPositionsAnd(R"("indices": [0, -1])"), "/models/0/mesh/indices/1",
                "expected a whole number, found -1"},
        Refusal{"FractionForAnIndex", twoPositionsAnd(R"("indices": [0.5])"), "/models/0/mesh/indices/0",
                "expected a whole number, found 0.5"},
        Refusal{"IndexThatFitsNoInt", twoPositionsAnd(R"("indices": [4294967296])"),
                "/models/0/mesh/indices/0", "expected a whole number, found 4294967296"},
        Refusal{"IndexBeyondAnyMesh", twoPositionsAnd(R"("indices": [0, 65536])"), "/models/0/mesh/indices",
                "expected whole numbers, each from 0 to 65535, found 65536"},
        Refusal{"TextForAnIndex", twoPositionsAnd(R"("indices": ["0"])"), "/models/0/mesh/indices/0",
                R"(expected a whole number, found "0")"},
        Refusal{"ArrayForAnIndex", twoPositionsAnd(R"("indices": [[0]])"), "/models/0/mesh/indices/0",
                "expected a whole number, found an array"},
        Refusal{"OverflowForAnIndex", twoPositionsAnd(R"("indices": [1e999])"), "/models/0/mesh/indices/0",
                "expected a whole number, found 1e999"},
        Refusal{"NumberForIndices", twoPositionsAnd(R"("indices": 1)"), "/models/0/mesh/indices",
                "expected whole numbers, each from 0 to 65535, found 1"},
        Refusal{"FewNormals", twoPositionsAnd(R"("normals": [[0, 0, 1]])"), "/models/0/mesh/normals",
                "expected 2, one for each position, or none; found 1"},
        Refusal{"ManyColors", twoPositionsAnd(R"("colors": [[0, 0, 0], [0, 0, 0], [0, 0, 0]])"),
                "/models/0/mesh/colors", "expected 2, one for each position, or none; found 3"},
        Refusal{"FewCoordinatesOfAMeshThatIsNotShown", R"({"models": [{"mesh": {"texCoords": [[0, 0]]}}]})",
                "/models/0/mesh/texCoords", "expected 0, one for each position, or none; found 1"},
        Refusal{"FewCoordinatesOfAUnit",
                R"({"models": [{"shape": "mesh", "mesh": {"positions": [[0, 0, 0], [1, 0, 0]]},
                    "texCoords2": [[0, 0]]}]})",
                "/models/0/texCoords2",
                "expected 2 coordinates, one for each vertex of the mesh, or none; found 1"},
        Refusal{"PositionOverflow", sceneOfMesh(R"("positions": [[0, 1e999, 0]])"),
                "/models/0/mesh/positions/0/1", "expected a number between -3.4e38 and 3.4e38, found 1e999"},
        Refusal{"PositionBeyondAFloat", sceneOfMesh(R"("positions": [[0, 0, -1e39]])"),
                "/models/0/mesh/positions/0/2", "expected a number between -3.4e38 and 3.4e38, found -1e39"},
        Refusal{"PositionNan", R"({"models": [{"mesh": {"positions": [[NaN, 0, 0]]}}]})", "line 1, column 38",
                "expected a value, found 'NaN'"},
        Refusal{"PositionNull", sceneOfMesh(R"("positions": [[0, null, 0]])"), "/models/0/mesh/positions/0/1",
                "expected a number between -3.4e38 and 3.4e38, found null"},
        Refusal{"PositionOfTwo", sceneOfMesh(R"("positions": [[0, 0, 0], [0, 0]])"),
                "/models/0/mesh/positions/1", "expected an array of 3 numbers, found 2"},
        Refusal{"PositionOfFour", sceneOfMesh(R"("positions": [[0, 0, 0, 1]])"),
                "/models/0/mesh/positions/0/3",
                "expected 3 finite numbers for each vertex, found more than 3"},
        Refusal{"PositionNumber", sceneOfMesh(R"("positions": [0, 0, 0])"), "/models/0/mesh/positions/0",
                "expected an array of 3 numbers, found 0"},
        Refusal{"ColorOutOfRange", twoPositionsAnd(R"("colors": [[0, 0, 0], [0, 1.5, 0, 1]])"),
                "/models/0/mesh/colors",
                "expected 3 or 4 numbers (red, green, blue, alpha) for each vertex, each from 0 to 1, found "
                "1.5 at vertex 1"},
        Refusal{"ColorOfTwo", twoPositionsAnd(R"("colors": [[0, 0]])"), "/models/0/mesh/colors/0",
                "expected an array of 3 to 4 numbers, found 2"},
        Refusal{"PrimitiveTypo", sceneOfMesh(R"("primitive": "GL_TRIANGLE")"), "/models/0/mesh/primitive",
                "expected one of GL_POINTS, GL_LINES, GL_LINE_STRIP, GL_LINE_LOOP, GL_TRIANGLES, "},
        Refusal{"ArrayForAMesh", R"({"models": [{"mesh": []}]})", "/models/0/mesh",
                "expected an object, found an array"}),
    [](const auto& test) { return std::string(test.param.name); });

/// A scene with one step of a texture matrix that has so many numbers.
std::string matrixOf(std::size_t count, const std::string& number = "1") {
    return R"({"passes": [{"units": [{"matrix": [{"matrix": [)" + repeat(number, count, ", ") + "]}]}]}]}";
}

INSTANTIATE_TEST_SUITE_P(
    Models, RefusedScenes,
    testing::Values(
        Refusal{"NamesNone", R"({"passes": [{"models": []}]})", "/passes/0/models",
                "expected whole numbers, each from 0 to 15, found an empty array; a pass without a list of "
                "models draws all"},
        Refusal{"NamesOneThatThereIsNot", R"({"models": [{}], "passes": [{}, {"models": [0, 1]}]})",
                "/passes/1/models/1", "there is no model 1, the scene has 1 model"},
        Refusal{"NamesOneOfNone", R"({"models": [], "passes": [{"models": [0]}]})", "/passes/0/models/0",
                "there is no model 0, the scene has 0 models"},
        Refusal{"NamesOneTwice", R"({"models": [{}, {}], "passes": [{"models": [1, 0, 1]}]})",
                "/passes/0/models/2", "expected each model once, found 1 twice"},
        Refusal{"NamesOneBeyondAny", R"({"passes": [{"models": [16]}]})", "/passes/0/models",
                "expected whole numbers, each from 0 to 15, found 16"},
        Refusal{"NamesTooMany", R"({"passes": [{"models": [)" + repeat("0", 17, ",") + "]}]}",
                "/passes/0/models/16", "expected at most 16 elements, found more"},
        Refusal{"NamesByText", R"({"passes": [{"models": ["cube"]}]})", "/passes/0/models/0",
                R"(expected a whole number, found "cube")"},
        Refusal{"LineWidth", R"({"models": [{"lineWidth": 0}]})", "/models/0/lineWidth",
                "expected a number from 0.5 to 64 pixels, found 0"},
        Refusal{"PointSize", R"({"models": [{"pointSize": 65}]})", "/models/0/pointSize",
                "expected a number from 0.5 to 64 pixels, found 65"},
        Refusal{"Scale", R"({"models": [{"scale": [1, 0, 1]}]})", "/models/0/scale",
                "expected 3 numbers, each from 0.01 to 100, found 0"},
        Refusal{"RotationOrder", R"({"models": [{"rotationOrder": "xyx"}]})", "/models/0/rotationOrder",
                "expected one of zyx, zxy, yzx, yxz, xzy, xyz, found"},
        Refusal{"ShadingOfOneModel", R"({"models": [{"material": {"shadeModel": "GL_FLAT"}}]})",
                "/models/0/material/shadeModel", "unknown key; "},
        Refusal{"NameWithZeroByte", R"({"models": [{"name": "a\u0000b"}]})", "/models/0/name",
                "expected UTF-8 text of at most 4096 bytes, found a zero byte in it"},
        Refusal{"NumberForAName", R"({"passes": [{"name": 1}]})", "/passes/0/name",
                "expected UTF-8 text of at most 4096 bytes, found 1"},
        Refusal{"MatrixTooShort", matrixOf(15), "/passes/0/units/0/matrix/0/matrix",
                "expected 16 numbers, each from -1e+06 to 1e+06, found 15"},
        Refusal{"MatrixTooLong", matrixOf(17), "/passes/0/units/0/matrix/0/matrix/16",
                "expected 16 numbers, each from -1e+06 to 1e+06, found more than 16"},
        Refusal{"MatrixOutOfRange", matrixOf(16, "2e6"), "/passes/0/units/0/matrix/0/matrix",
                "expected 16 numbers, each from -1e+06 to 1e+06, found 2e+06"},
        Refusal{"MatrixOfColumns", matrixOf(4, "[1, 0, 0, 0]"), "/passes/0/units/0/matrix/0/matrix/0",
                "expected a number between -3.4e38 and 3.4e38, found an array"},
        Refusal{"MatrixOfText", matrixOf(1, R"("1")"), "/passes/0/units/0/matrix/0/matrix/0",
                R"(expected a number between -3.4e38 and 3.4e38, found "1")"},
        Refusal{"EmbossTooDeep", R"({"passes": [{"units": [{"emboss": {"depth": 2}}]}]})",
                "/passes/0/units/0/emboss/depth", "expected a number from -1 to 1, found 2"}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(ParseScene, AFileLargerThanTheLimitIsNotLookedAt) {
    const auto scene = parseScene(std::string(maxSceneBytes + 1, ' '));
    ASSERT_FALSE(scene);
    EXPECT_EQ(scene.error().code, ErrorCode::TooLarge);
    EXPECT_EQ(scene.error().message, "expected a scene of at most 16777216 bytes, found 16777217");
}

TEST(ParseScene, NothingMayFollowANul) {
    for (const std::string_view text : {std::string_view("{\"version\": 1}\n\0{\"version\": 2}", 29),
                                        std::string_view("{\"version\": 1}\n\0", 16)}) {
        const auto scene = parseScene(text);
        ASSERT_FALSE(scene);
        EXPECT_EQ(describe(scene.error()), "line 2, column 1: expected JSON, found a NUL character");
    }
}

TEST(ParseScene, WhatAFileLeavesOutKeepsItsDefault) {
    EXPECT_EQ(parseScene("{}").value(), defaultScene());
    EXPECT_EQ(parseScene("\xEF\xBB\xBF{\"version\": 1}").value(), defaultScene()) << "with a byte order mark";

    Scene expected = defaultScene();
    expected.view.azimuth = -7.5F;
    EXPECT_EQ(parseScene(R"({"view": {"azimuth": -7.5}})").value(), expected);
}

TEST(ParseScene, AListReplacesTheDefaultsAndItsElementsBeginWithGlsValues) {
    Scene expected = defaultScene();
    expected.textures = {Texture{}, Texture{}};
    expected.textures[1].wrapS = Wrap::Clamp;
    EXPECT_EQ(parseScene(R"({"textures": [{}, {"wrapS": "GL_CLAMP"}]})").value(), expected);

    expected = defaultScene();
    expected.passes = {Pass{}};
    EXPECT_EQ(parseScene(R"({"passes": [{}]})").value(), expected);

    expected.passes[0].units[1].envMode = EnvMode::Add;
    EXPECT_EQ(parseScene(R"({"passes": [{"units": [{}, {"envMode": "GL_ADD"}]}]})").value(), expected);
}

TEST(ParseScene, OrderOfKeysDoesNotMatter) {
    const auto scene = parseScene(R"({"passes": [{"units": [{"texture": 1, "enabled": true}]}],
        "models": [{"texCoords0": [[0, 0], [1, 0, 2], [1, 1, 2, 3], [0, 1]], "shape": "quad"}],
        "textures": [{}, {}], "version": 1})");
    ASSERT_TRUE(scene) << describe(scene.error());
    EXPECT_EQ(scene->models[0].texCoords[0],
              (TexCoords{{0, 0, 0, 1}, {1, 0, 2, 1}, {1, 1, 2, 3}, {0, 1, 0, 1}}));
}

TEST(ParseScene, TakesVerticesOfTheirOwn) {
    const auto scene = parseScene(R"({"models": [{"mesh": {
        "indices": [2, 1, 0.0, 1],
        "colors": [[0, 0.5, 1], [1, 1, 1, 0.25], [0, 0, 0]],
        "texCoords": [[0, 1], [2, 3, 4], [5, 6, 7, 8]],
        "normals": [],
        "positions": [[0, 0, 0], [1e30, -2, 3], [-0.0, 1e-45, 0.1]],
        "primitive": "GL_LINE_STRIP"}, "shape": "mesh"}]})");
    ASSERT_TRUE(scene) << describe(scene.error());
    MeshData expected;
    expected.primitive = Primitive::LineStrip;
    expected.positions = {{0, 0, 0}, {1e30F, -2, 3}, {-0.0F, 1e-45F, 0.1F}};
    expected.colors = {{0, 0.5F, 1, 1}, {1, 1, 1, 0.25F}, {0, 0, 0, 1}};
    expected.texCoords = {{0, 1, 0, 1}, {2, 3, 4, 1}, {5, 6, 7, 8}};
    expected.indices = {2, 1, 0, 1};
    EXPECT_EQ(scene->models[0].mesh, expected);
    EXPECT_EQ(scene->models[0].shape, Shape::Mesh);
}

TEST(ParseScene, TakesTheModelsOfAPassInTheirOrder) {
    const auto scene = parseScene(R"({"passes": [{"models": [2, 0]}, {}], "models": [{}, {}, {}]})");
    ASSERT_TRUE(scene) << describe(scene.error());
    EXPECT_THAT(scene->passes[0].models, testing::ElementsAre(2, 0));
    EXPECT_THAT(scene->passes[1].models, testing::IsEmpty());
}

TEST(ParseScene, TakesAMatrixColumnByColumn) {
    const auto scene = parseScene(R"({"passes": [{"units": [{"matrix": [{"op": "load",
        "matrix": [1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16]}]}]}]})");
    ASSERT_TRUE(scene) << describe(scene.error());
    const MatrixStep& step = scene->passes[0].units[0].matrix.at(0);
    EXPECT_EQ(step.op, MatrixOp::Load);
    EXPECT_EQ(step.matrix[0], glm::vec4(1, 2, 3, 4));
    EXPECT_EQ(step.matrix[3], glm::vec4(13, 14, 15, 16));
}

TEST(ParseScene, TakesTextureMatricesOfModels) {
    const auto scene = parseScene(R"({"models": [{"pushMatrix": false, "units": [{}, {"matrix": [
        {"op": "scale", "amount": [2, 3, 1]}]}]}],
        "passes": [{"units": [{"matrixStart": "glPushMatrix"}, {"matrixStart": "keep"}]}]})");
    ASSERT_TRUE(scene) << describe(scene.error());
    EXPECT_FALSE(scene->models[0].pushMatrix);
    EXPECT_TRUE(scene->models[0].units[0].matrix.empty());
    EXPECT_EQ(scene->models[0].units[1].matrix.at(0).amount, glm::vec3(2, 3, 1));
    EXPECT_EQ(scene->passes[0].units[0].matrixStart, MatrixStart::Push);
    EXPECT_EQ(scene->passes[0].units[1].matrixStart, MatrixStart::Keep);
    EXPECT_EQ(scene->passes[0].units[2].matrixStart, MatrixStart::Identity);
}

TEST(ParseScene, TakesAMaterialOfAModel) {
    const auto scene = parseScene(R"({"models": [{"ownMaterial": true, "material": {
        "colorMaterial": false, "emission": [0.5, 0.25, 0, 1]}}]})");
    ASSERT_TRUE(scene) << describe(scene.error());
    Material expected;
    expected.colorMaterial = false;
    expected.emission = {0.5F, 0.25F, 0, 1};
    EXPECT_TRUE(scene->models[0].ownMaterial);
    EXPECT_EQ(scene->models[0].material, expected);
}

TEST(ParseScene, NumbersAreRoundedOnceToTheNearestFloat) {
    const auto azimuth = [](std::string_view number) {
        return parseScene(R"({"view": {"azimuth": )" + std::string(number) + "}}").value().view.azimuth;
    };
    EXPECT_EQ(azimuth("0.1"), 0.1F);
    EXPECT_EQ(azimuth("1e-45"), 1e-45F);
    EXPECT_EQ(azimuth("1e-999"), 0.0F);
    EXPECT_EQ(azimuth("360"), 360.0F);
    // 1 + 2^-24 + 2^-60: just above the middle of two floats; a double would lose the last bit and round
    // down.
    EXPECT_EQ(azimuth("1.00000005960464477625798618"), 1.00000012F);
}

TEST(ParseScene, AWholeNumberMayHaveAPoint) {
    EXPECT_EQ(parseScene(R"({"models": [{"slices": 8.0}]})").value().models[0].slices, 8);
    EXPECT_EQ(parseScene(R"({"models": [{"slices": 1e1}]})").value().models[0].slices, 10);
}

TEST(ParseScene, EveryTruncationIsRefused) {
    const std::string whole = writeScene(defaultScene());
    for (std::size_t length = 0; length + 2 < whole.size(); ++length) {
        const auto scene = parseScene(std::string_view(whole).substr(0, length));
        ASSERT_FALSE(scene) << "cut after " << length << " bytes";
        ASSERT_FALSE(scene.error().message.empty());
    }
}

TEST(ParseScene, EveryChangedByteIsReadOrRefused) {
    const std::string whole = writeScene(defaultScene());
    for (const char byte : {'\0', '"', '9', '{', ']', '\xff'})
        for (std::size_t at = 0; at < whole.size(); ++at) {
            std::string text = whole;
            text[at] = byte;
            if (const auto scene = parseScene(text)) {
                EXPECT_EQ(parseScene(writeScene(*scene)).value(), *scene) << "at " << at;
            }
        }
}

TEST(ParseScene, TakesNumbersForTheNamesThatAreNumbers) {
    const auto scaled = [](const std::string& scale) {
        return parseScene(R"({"version": 1, "passes": [{"units": [{"combine": {"rgbScale": )" + scale +
                          R"(, "alphaScale": )" + scale + "}}]}]}");
    };
    for (const auto& [text, scale] : {std::pair{"1", CombineScale::One}, std::pair{"2", CombineScale::Two},
                                      std::pair{"4", CombineScale::Four}, std::pair{"2.0", CombineScale::Two},
                                      std::pair{"\"4\"", CombineScale::Four}}) {
        const auto scene = scaled(text);
        ASSERT_TRUE(scene) << text << ": " << describe(scene.error());
        EXPECT_EQ(scene->passes[0].units[0].combine.rgbScale, scale) << text;
        EXPECT_EQ(scene->passes[0].units[0].combine.alphaScale, scale) << text;
    }
    for (const char* text : {"3", "2.5", "-2", "1e30", "0"}) {
        const auto scene = scaled(text);
        ASSERT_FALSE(scene) << text;
        EXPECT_EQ(scene.error().where, "/passes/0/units/0/combine/rgbScale");
        EXPECT_THAT(scene.error().message, testing::StartsWith("expected one of 1, 2, 4, found "));
    }
    EXPECT_FALSE(parseScene(R"({"version": 1, "textures": [{"minFilter": 9728}]})"))
        << "enumerants have names, not numbers";
}

TEST(ParseScene, TakesTheNameOfASchemaAtTheTop) {
    EXPECT_EQ(parseScene(R"({"$schema": "https://example.org/scene.json", "version": 1})"), defaultScene());
    for (const auto& [json, message] :
         {std::pair{R"({"$schema": 1})", "expected a text, found 1"},
          std::pair{R"({"$schema": {}})", "expected a text, found an object"},
          std::pair{R"({"$schema": []})", "expected a text, found an array"},
          std::pair{R"({"$schema": "a", "$schema": "a"})", "expected each key once"}}) {
        const auto scene = parseScene(json);
        ASSERT_FALSE(scene) << json;
        EXPECT_EQ(scene.error().where, "/$schema");
        EXPECT_THAT(scene.error().message, testing::StartsWith(message));
    }
    EXPECT_THAT(parseScene(R"({"view": {"$schema": "a"}})").error().message,
                testing::StartsWith("unknown key"));
}

} // namespace
} // namespace texplorer::json_parse_test

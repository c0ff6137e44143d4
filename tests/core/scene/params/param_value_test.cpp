#include "texplorer/scene/params/params.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace texplorer::param_value_test {
namespace {

const ParamRow& texture(std::string_view key) {
    return *findParam(textureTable(), key);
}

struct Refusal {
    const char* name;
    const StructTable& (*table)();
    const char* key;
    const char* text;
    const char* message;
};

class RefusedTexts : public testing::TestWithParam<Refusal> {};

TEST_P(RefusedTexts, SayWhatIsAccepted) {
    const auto value = parseValue(*findParam(GetParam().table(), GetParam().key), GetParam().text);
    ASSERT_FALSE(value);
    EXPECT_EQ(describe(value.error()), GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    Values, RefusedTexts,
    testing::Values(
        Refusal{"Word", textureTable, "maxAnisotropy", "lots",
                R"(expected a number from 1 to 16, found "lots")"},
        Refusal{"Empty", textureTable, "maxAnisotropy", "", R"(expected a number from 1 to 16, found "")"},
        Refusal{"TooSmall", textureTable, "maxAnisotropy", "0.5",
                "expected a number from 1 to 16, found 0.5"},
        Refusal{"TooLarge", textureTable, "maxAnisotropy", "17", "expected a number from 1 to 16, found 17"},
        Refusal{"Tail", textureTable, "maxAnisotropy", "2x", R"(expected a number from 1 to 16, found "2x")"},
        Refusal{"Comma", textureTable, "maxAnisotropy", "2,5",
                R"(expected a number from 1 to 16, found "2,5")"},
        Refusal{"NotANumber", textureTable, "maxAnisotropy", "nan",
                R"(expected a number from 1 to 16, found "nan")"},
        Refusal{"Infinity", textureTable, "maxLod", "inf",
                R"(expected a number from -1000 to 1000 levels, found "inf")"},
        Refusal{"Overflow", textureTable, "maxLod", "1e999",
                R"(expected a number from -1000 to 1000 levels, found "1e999")"},
        Refusal{"Fraction", textureTable, "baseLevel", "1.5",
                R"(expected a whole number from 0 to 1000, found "1.5")"},
        Refusal{"IntOverflow", textureTable, "baseLevel", "99999999999",
                R"(expected a whole number from 0 to 1000, found "99999999999")"},
        Refusal{"IntTooLarge", textureTable, "baseLevel", "1001",
                "expected a whole number from 0 to 1000, found 1001"},
        Refusal{"Unit", viewTable, "fieldOfView", "171", "expected a number from 1 to 170 deg, found 171"},
        Refusal{"TooFewComponents", textureTable, "borderColor", "1,0,0",
                R"(expected 4 numbers (red, green, blue, alpha), each from 0 to 1, found "1,0,0")"},
        Refusal{"TooManyComponents", viewTable, "target", "1,2,3,4",
                R"(expected 3 numbers, each from -1000 to 1000, found "1,2,3,4")"},
        Refusal{"ComponentOutOfRange", textureTable, "borderColor", "1,0,2,0",
                "expected 4 numbers (red, green, blue, alpha), each from 0 to 1, found 2"},
        Refusal{"Bool", passTable, "blend", "1", R"(expected true or false, found "1")"},
        Refusal{"EnumTypo", textureTable, "magFilter", "GL_LINEER",
                R"(expected one of GL_NEAREST, GL_LINEAR, found "GL_LINEER"; did you mean "GL_LINEAR"?)"},
        Refusal{"EnumNumber", textureTable, "magFilter", "9729",
                R"(expected one of GL_NEAREST, GL_LINEAR, found "9729")"},
        Refusal{"EnumOfAnother", textureTable, "magFilter", "GL_LINEAR_MIPMAP_LINEAR",
                R"(expected one of GL_NEAREST, GL_LINEAR, found "GL_LINEAR_MIPMAP_LINEAR")"},
        Refusal{"ControlCharacters", passTable, "blend", "\x1b[31m",
                R"(expected true or false, found "\u001b[31m")"},
        Refusal{"Long", passTable, "blend", "aaaaaaaaaabbbbbbbbbbccccccccccddddddddddeeeeeeeeee",
                R"(expected true or false, found "aaaaaaaaaabbbbbbbbbbccccccccccdddddddddd...")"},
        Refusal{"TextNotUtf8", textureTable, "file", "a\xff.png",
                "expected UTF-8 text of at most 4096 bytes, found bytes that are not UTF-8"},
        Refusal{"TexCoordOfOneNumber", modelTable, "texCoords0", "0,0;1",
                R"(expected 2 to 4 finite numbers for each vertex, found "0,0;1")"},
        Refusal{"PointOfTwoNumbers", meshTable, "positions", "0,0,0;1,2",
                R"(expected 3 finite numbers for each vertex, found "0,0,0;1,2")"},
        Refusal{"PointOfFourNumbers", meshTable, "normals", "0,0,0,1",
                R"(expected 3 finite numbers for each vertex, found "0,0,0,1")"},
        Refusal{"PointThatIsNone", meshTable, "positions", "0,0,nan",
                R"(expected 3 finite numbers for each vertex, found "0,0,nan")"},
        Refusal{"NoPoint", meshTable, "positions", ";",
                R"(expected 3 finite numbers for each vertex, found ";")"},
        Refusal{"ColorOfTwoNumbers", meshTable, "colors", "0,0,0;1,1",
                R"(expected 3 or 4 numbers (red, green, blue, alpha) for each vertex, each from 0 to 1, )"
                R"(found "0,0,0;1,1")"},
        Refusal{"ColorOutOfRange", meshTable, "colors", "0,0,0;0,0,-1,1",
                "expected 3 or 4 numbers (red, green, blue, alpha) for each vertex, each from 0 to 1, found "
                "-1 at vertex 1"},
        Refusal{"IndexFraction", meshTable, "indices", "0,1.5",
                R"(expected whole numbers, each from 0 to 65535, found "0,1.5")"},
        Refusal{"IndexNegative", meshTable, "indices", "0,-1",
                "expected whole numbers, each from 0 to 65535, found -1"},
        Refusal{"IndexMissing", meshTable, "indices", "0,,1",
                R"(expected whole numbers, each from 0 to 65535, found "0,,1")"},
        Refusal{"ModelBeyondAny", passTable, "models", "16",
                "expected whole numbers, each from 0 to 15, found 16"},
        Refusal{"TooManyModels", passTable, "models", "0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0",
                "expected at most 16 elements, found 17"},
        Refusal{"MatrixOfFifteen", matrixStepTable, "matrix", "1,0,0,0,0,1,0,0,0,0,1,0,0,0,0",
                R"(expected 16 numbers, each from -1e+06 to 1e+06, found "1,0,0,0,0,1,0,0,0,0,1,0,0,0,0")"},
        Refusal{"MatrixEmpty", matrixStepTable, "matrix", "",
                R"(expected 16 numbers, each from -1e+06 to 1e+06, found "")"},
        Refusal{"MatrixOutOfRange", matrixStepTable, "matrix", "1,0,0,0,0,1,0,0,0,0,1,0,0,0,2e6,1",
                "expected 16 numbers, each from -1e+06 to 1e+06, found 2e+06"}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(ParamValue, FloatsAreTheShortestThatReadBackExactly) {
    const ParamRow& row = texture("maxLod");
    EXPECT_EQ(formatValue(row, 0.1F), "0.1");
    EXPECT_EQ(formatValue(row, 1000.0F), "1000");
    EXPECT_EQ(formatValue(row, -1.0F / 3), "-0.33333334");
    float number = 1000;
    for (int i = 0; i < 200; ++i, number = std::nextafter(number * 0.83F, 0.0F))
        EXPECT_EQ(std::get<float>(parseValue(row, formatValue(row, number)).value()), number);
}

TEST(ParamValue, BlanksAroundNumbersAreIgnored) {
    EXPECT_EQ(std::get<glm::vec4>(parseValue(texture("borderColor"), " 1, 0 ,0.5,1 ").value()),
              glm::vec4(1, 0, 0.5F, 1));
}

TEST(ParamValue, TextIsTakenAsItIs) {
    EXPECT_EQ(std::get<std::string>(parseValue(texture("file"), " b\xC3\xA4r 1.png ").value()),
              " b\xC3\xA4r 1.png ");
    EXPECT_FALSE(parseValue(texture("file"), std::string(maxTextBytes + 1, 'a')));
    EXPECT_FALSE(parseValue(texture("file"), std::string("a\0b", 3)));
}

TEST(ParamValue, MissingTexCoordComponentsAreZeroAndOne) {
    const auto list = parseValue(*findParam(modelTable(), "texCoords0"), "0.5,1;2,3,4;5,6,7,8");
    EXPECT_EQ(std::get<SharedList<glm::vec4>>(list.value()),
              (TexCoords{{0.5F, 1, 0, 1}, {2, 3, 4, 1}, {5, 6, 7, 8}}));
}

TEST(ParamValue, PointsAndColorsOfVerticesReadBack) {
    const ParamRow& positions = *findParam(meshTable(), "positions");
    const std::vector<glm::vec3> points{{0, 0.5F, -1}, {1e-45F, 3e38F, 1.0F / 3}};
    EXPECT_EQ(formatValue(positions, points), "0,0.5,-1;1e-45,3e+38,0.33333334");
    EXPECT_EQ(
        std::get<SharedList<glm::vec3>>(parseValue(positions, " 0, 0.5,-1 ;1e-45,3e38,0.33333334").value()),
        points);
    EXPECT_TRUE(std::get<SharedList<glm::vec3>>(parseValue(positions, "").value()).empty());

    // An alpha of 1 is left out.
    const ParamRow& colors = *findParam(meshTable(), "colors");
    const std::vector<glm::vec4> given{{0, 0.5F, 1, 1}, {1, 0, 0, 0}};
    EXPECT_EQ(formatValue(colors, given), "0,0.5,1;1,0,0,0");
    EXPECT_EQ(std::get<SharedList<glm::vec4>>(parseValue(colors, "0,0.5,1,1;1,0,0,0").value()), given);
    EXPECT_EQ(std::get<SharedList<glm::vec4>>(parseValue(colors, "0,0.5,1;1,0,0,0").value()), given);
}

TEST(ParamValue, IndicesReadBack) {
    const ParamRow& indices = *findParam(meshTable(), "indices");
    EXPECT_EQ(formatValue(indices, std::vector<int>{0, 65535, 7, 7}), "0,65535,7,7");
    EXPECT_EQ(std::get<SharedList<int>>(parseValue(indices, " 0, 65535,7 ,7").value()),
              (std::vector<int>{0, 65535, 7, 7}));
    EXPECT_EQ(formatValue(indices, std::vector<int>{}), "");
    EXPECT_TRUE(std::get<SharedList<int>>(parseValue(indices, " ").value()).empty());
}

// As OpenGL takes them: the offset is in the last four.
TEST(ParamValue, MatricesReadBackColumnByColumn) {
    const ParamRow& row = *findParam(matrixStepTable(), "matrix");
    glm::mat4 matrix(1);
    matrix[3] = {0.1F, 2, 3, 1};
    matrix[0].y = -1;
    EXPECT_EQ(formatValue(row, matrix), "1,-1,0,0,0,1,0,0,0,0,1,0,0.1,2,3,1");
    EXPECT_EQ(std::get<glm::mat4>(parseValue(row, "1, -1, 0, 0, 0,1,0,0,0,0,1,0,0.1,2,3,1").value()), matrix);
}

TEST(ParamValue, AValueOfAnotherKindIsRefused) {
    EXPECT_FALSE(checkValue(texture("maxLod"), 1));
    EXPECT_FALSE(checkValue(texture("magFilter"), 0x2600));
    EXPECT_FALSE(checkValue(texture("magFilter"), EnumValue{0x2700}));
    EXPECT_FALSE(checkValue(texture("maxLod"), std::numeric_limits<float>::quiet_NaN()));
    EXPECT_FALSE(checkValue(*findParam(modelTable(), "texCoords0"), TexCoords{{0, INFINITY, 0, 1}}));
    EXPECT_FALSE(checkValue(*findParam(meshTable(), "positions"), TexCoords{{0, 0, 0, 1}}));
    EXPECT_FALSE(checkValue(*findParam(meshTable(), "positions"), std::vector<glm::vec3>{{0, NAN, 0}}));
    EXPECT_FALSE(checkValue(*findParam(meshTable(), "colors"), std::vector<glm::vec4>{{0, NAN, 0, 1}}));
    EXPECT_FALSE(checkValue(*findParam(meshTable(), "indices"), 1));
    EXPECT_FALSE(checkValue(*findParam(matrixStepTable(), "matrix"), glm::vec4(1)));
    EXPECT_FALSE(checkValue(*findParam(matrixStepTable(), "matrix"), glm::mat4(NAN)));
}

} // namespace
} // namespace texplorer::param_value_test

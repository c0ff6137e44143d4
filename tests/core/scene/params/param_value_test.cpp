#include "core/scene/params/params.h"

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
                R"(expected 2 to 4 finite numbers for each vertex, found "0,0;1")"}),
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
    EXPECT_EQ(std::get<TexCoords>(list.value()), (TexCoords{{0.5F, 1, 0, 1}, {2, 3, 4, 1}, {5, 6, 7, 8}}));
}

TEST(ParamValue, AValueOfAnotherKindIsRefused) {
    EXPECT_FALSE(checkValue(texture("maxLod"), 1));
    EXPECT_FALSE(checkValue(texture("magFilter"), 0x2600));
    EXPECT_FALSE(checkValue(texture("magFilter"), EnumValue{0x2700}));
    EXPECT_FALSE(checkValue(texture("maxLod"), std::numeric_limits<float>::quiet_NaN()));
    EXPECT_FALSE(checkValue(*findParam(modelTable(), "texCoords0"), TexCoords{{0, INFINITY, 0, 1}}));
}

} // namespace
} // namespace texplorer::param_value_test

#include "texplorer/scene/params/sweep_axis.h"

#include <gmock/gmock.h>

namespace texplorer::sweep_axis_test {
namespace {

using testing::ElementsAre;

struct Case {
    const char* name;
    const char* text;
    std::vector<std::string> values;
};

class Axes : public testing::TestWithParam<Case> {};

TEST_P(Axes, HaveTheseValues) {
    const Result<SweepAxis> axis = parseSweepAxis(defaultScene(), GetParam().text);
    ASSERT_TRUE(axis) << describe(axis.error());
    EXPECT_EQ(axis->values, GetParam().values);
}

INSTANTIATE_TEST_SUITE_P(
    Text, Axes,
    testing::Values(
        Case{"Choices", "textures[0].magFilter=GL_NEAREST,GL_LINEAR", {"GL_NEAREST", "GL_LINEAR"}},
        Case{"AllChoices", "textures[0].magFilter=*", {"GL_NEAREST", "GL_LINEAR"}},
        Case{"Blanks", "textures[0].maxAnisotropy= 1 , 2 ", {"1", "2"}},
        Case{"ARange", "textures[0].maxAnisotropy=1..16/4", {"1", "6", "11", "16"}},
        Case{"ARangeOfFive", "textures[0].lodBias=-1..1", {"-1", "-0.5", "0", "0.5", "1"}},
        Case{"TenthsAreTenths", "passes[0].alphaRef=0..0.3/4", {"0", "0.1", "0.2", "0.3"}},
        Case{"ARangeBackwards", "textures[0].lodBias=2..0/3", {"2", "1", "0"}},
        Case{"ARangeAndMore", "textures[0].lodBias=0..1/2,4", {"0", "1", "4"}},
        Case{"WholeNumbers", "textures[0].baseLevel=0..2/5", {"0", "1", "2"}}, // 0, 0.5, 1, 1.5, 2
        Case{"TrueAndFalse", "passes[0].lighting=*", {"false", "true"}},
        Case{"DoublingNumbers", "textures[0].maxAnisotropy=*", {"1", "2", "4", "8", "16"}},
        Case{
            "CoordinatesOfAVertex", "models[0].texCoords0[2]=0,0;1,0.5;0,0,0,2", {"0,0", "1,0.5", "0,0,0,2"}},
        Case{"Colours", "material.color=1,0,0,1;0,1,0,1", {"1,0,0,1", "0,1,0,1"}}),
    [](const auto& tested) { return tested.param.name; });

TEST(SweepAxis, NumbersWithManyStepsAreSuggestedAroundTheCurrentOne) {
    Scene scene = defaultScene();
    const auto suggested = [&](const char* path) {
        const Result<SweepAxis> axis = sweepAxis(scene, path, "*");
        return axis ? axis->values : std::vector<std::string>{describe(axis.error())};
    };
    // -16 to 16 in steps of 0.02: 50 of them are 1.
    EXPECT_THAT(suggested("textures[0].lodBias"), ElementsAre("-2", "-1", "0", "1", "2"));
    scene.textures[0].lodBias = 3;
    EXPECT_THAT(suggested("textures[0].lodBias"), ElementsAre("1", "2", "3", "4", "5"));
    // At the end of the range they stay in it.
    scene.textures[0].lodBias = 16;
    EXPECT_THAT(suggested("textures[0].lodBias"), ElementsAre("12", "13", "14", "15", "16"));
    EXPECT_THAT(suggested("textures[0].baseLevel"), ElementsAre("0", "1", "2", "3", "4"));
}

struct Refusal {
    const char* name;
    const char* text;
    const char* error;
};

class RefusedAxes : public testing::TestWithParam<Refusal> {};

TEST_P(RefusedAxes, SayWhatWasExpected) {
    const Result<SweepAxis> axis = parseSweepAxis(defaultScene(), GetParam().text);
    ASSERT_FALSE(axis);
    EXPECT_EQ(describe(axis.error()), GetParam().error);
}

INSTANTIATE_TEST_SUITE_P(
    Text, RefusedAxes,
    testing::Values(
        Refusal{
            "NoValues", "textures[0].magFilter",
            R"(expected PATH=VALUES, as in textures[0].maxAnisotropy=1,2,4, found "textures[0].magFilter")"},
        Refusal{"NoSuchParameter", "textures[0].magFiltre=*",
                R"(textures[0].magFiltre: no such parameter; did you mean "magFilter"?)"},
        Refusal{"NoSuchChoice", "textures[0].magFilter=GL_NEAREST,GL_FAST",
                R"(textures[0].magFilter: expected one of GL_NEAREST, GL_LINEAR, found "GL_FAST")"},
        Refusal{"OutOfRange", "textures[0].maxAnisotropy=1,32",
                "textures[0].maxAnisotropy: expected a number from 1 to 16, found 32"},
        Refusal{"OneTwice", "textures[0].maxAnisotropy=1,2,1.0",
                R"(textures[0].maxAnisotropy: expected each value once, found "1" twice)"},
        Refusal{"HalfARange", "textures[0].lodBias=0..",
                R"(textures[0].lodBias: expected two numbers, as in 0..4/5, found "0..")"},
        Refusal{"OneValueOfARange", "textures[0].lodBias=0..1/1",
                R"(textures[0].lodBias: expected 2 to 256 values after the slash, found "1")"},
        Refusal{"TooManyOfARange", "textures[0].lodBias=0..1/257",
                R"(textures[0].lodBias: expected 2 to 256 values after the slash, found "257")"},
        Refusal{"TooMany", "textures[0].lodBias=-1..0/256,0..1/256",
                "textures[0].lodBias: expected at most 256 values, found 511"},
        Refusal{"AList", "models[0].texCoords0=0,0",
                "models[0].texCoords0: expected one element of the list, as in models[0].texCoords0[0]"},
        Refusal{"AListOfNumbers", "models[0].noTexCoord0=1",
                "models[0].noTexCoord0: expected a choice, a number, a colour or true or false"},
        Refusal{"NoElement", "models[0].texCoords0[1]=0,0;",
                R"(models[0].texCoords0[1]: expected 2 to 4 finite numbers for each vertex, found "")"},
        Refusal{"NothingSuggested", "material.color=*",
                "material.color: expected values: there are no default values here"}),
    [](const auto& tested) { return tested.param.name; });

TEST(SweepAxis, AnElementOfAListOfAMeshIsOne) {
    Scene scene = defaultScene();
    scene.models[0].shape = Shape::Mesh;
    scene.models[0].mesh = {.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, .indices = {0, 1, 2}};
    const auto valuesOf = [&](const char* text) {
        const Result<SweepAxis> axis = parseSweepAxis(scene, text);
        return axis ? axis->values : std::vector<std::string>{describe(axis.error())};
    };
    EXPECT_THAT(valuesOf("models[0].mesh.positions[2]=0,1,0; 0,2,0"), ElementsAre("0,1,0", "0,2,0"));
    EXPECT_THAT(valuesOf("models[0].mesh.indices[1]=1,2"), ElementsAre("1", "2"));
    EXPECT_THAT(valuesOf("models[0].mesh.positions[2]=0,1"),
                ElementsAre("models[0].mesh.positions[2]: expected 3 finite numbers for each vertex, found "
                            "\"0,1\""));
    EXPECT_THAT(
        valuesOf("models[0].mesh.positions[3]=0,1,0"),
        ElementsAre("models[0].mesh.positions[3]: expected an existing index, counted from 0; the list "
                    "has 3"));
}

// Where one types into a field, what is there twice for a moment is no mistake.
TEST(SweepAxis, OfAFieldLeavesOutWhatIsThereTwice) {
    const Result<SweepAxis> axis = sweepAxis(defaultScene(), "textures[0].maxAnisotropy", "1,2,1.0");
    ASSERT_TRUE(axis) << describe(axis.error());
    EXPECT_THAT(axis->values, ElementsAre("1", "2"));
}

} // namespace
} // namespace texplorer::sweep_axis_test

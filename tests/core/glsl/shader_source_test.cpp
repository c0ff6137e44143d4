// What a pass is written as: only what its state uses.

#include "tests/support/flat_scene.h"
#include "texplorer/glsl/shader_source.h"

#include <gmock/gmock.h>

#include <algorithm>

namespace texplorer::glsl::shader_source_test {
namespace {

using namespace test;
using testing::HasSubstr;
using testing::Not;

SampledUnits oneUnit(BaseFormat format = BaseFormat::Rgba) {
    return {SampledUnit{format, LateFlip::None}};
}

ShaderSource sourceOf(const Scene& scene, const SampledUnits& units = oneUnit()) {
    Result<ShaderSource> source = shaderSource(scene, 0, units);
    EXPECT_TRUE(source) << describe(source.error());
    return source ? std::move(*source) : ShaderSource();
}

struct Case {
    const char* name;
    void (*change)(Scene& scene);
    const char* vertex; ///< what appears with the change, and isn't there without; empty: nothing
    const char* fragment;
};

class Source : public testing::TestWithParam<Case> {};

TEST_P(Source, HoldsOnlyWhatTheStateUses) {
    Scene scene = texturedScene();
    const ShaderSource before = sourceOf(scene);
    GetParam().change(scene);
    const ShaderSource after = sourceOf(scene);
    if (*GetParam().vertex != '\0') {
        EXPECT_THAT(before.vertex.text, Not(HasSubstr(GetParam().vertex)));
        EXPECT_THAT(after.vertex.text, HasSubstr(GetParam().vertex));
    } else
        EXPECT_EQ(after.vertex.text, before.vertex.text);
    if (*GetParam().fragment != '\0') {
        EXPECT_THAT(before.fragment.text, Not(HasSubstr(GetParam().fragment)));
        EXPECT_THAT(after.fragment.text, HasSubstr(GetParam().fragment));
    } else
        EXPECT_EQ(after.fragment.text, before.fragment.text);
    for (const char* word : {"UNIT", "COORD", "MEMBER", "INDEX", "SOURCE", "LOCATION", "//@"}) {
        EXPECT_THAT(after.vertex.text, Not(HasSubstr(word)));
        EXPECT_THAT(after.fragment.text, Not(HasSubstr(word)));
    }
}

Unit& unitOf(Scene& scene) {
    return scene.passes[0].units[0];
}

INSTANTIATE_TEST_SUITE_P(
    All, Source,
    testing::Values(
        Case{"Lighting", [](Scene& s) { s.passes[0].lighting = true; }, "toLight", ""},
        Case{"SeparateSpecular",
             [](Scene& s) {
                 s.passes[0].lighting = true;
                 s.light.colorControl = ColorControl::SeparateSpecular;
             },
             "secondaryColor", "secondaryColor"},
        Case{"TwoSides",
             [](Scene& s) {
                 s.passes[0].lighting = true;
                 s.light.twoSide = true;
             },
             "backPrimaryColor = clamp(", "gl_FrontFacing"},
        Case{"TwoSidesWithoutLighting", [](Scene& s) { s.light.twoSide = true; }, "", ""},
        Case{"Fog", [](Scene& s) { s.passes[0].fog.enabled = true; }, "out float fogDistance",
             "exp(-fogDensity * fogDistance)"},
        Case{"LinearFog", [](Scene& s) { s.passes[0].fog = {.enabled = true, .mode = FogMode::Linear}; },
             "out float fogDistance", "fogEnd - fogStart"},
        Case{"FogWithoutPerspective",
             [](Scene& s) {
                 s.passes[0].fog.enabled = true;
                 s.view.perspectiveHint = HintMode::Fastest;
                 s.material.shadeModel = ShadeModel::Flat;
             },
             "out float fogDistanceTimesW", "fogDistanceTimesW / w"},
        Case{"FogThatIsOff",
             [](Scene& s) {
                 s.passes[0].fog.color = {1, 1, 1, 1};
             },
             "", ""},
        Case{"SeparateSpecularWithoutLighting",
             [](Scene& s) { s.light.colorControl = ColorControl::SeparateSpecular; }, "", ""},
        Case{"Flat", [](Scene& s) { s.material.shadeModel = ShadeModel::Flat; }, "flat out", "flat in"},
        Case{"Matrix", [](Scene& s) { unitOf(s).matrix = {MatrixStep{}}; }, "textureMatrix0", ""},
        Case{"TexGen", [](Scene& s) { unitOf(s).texGenR.enabled = true; }, "coord0.p = dot(plane0r", ""},
        Case{"PlaneOfACoordinateThatIsNotGenerated",
             [](Scene& s) {
                 unitOf(s).texGenR.eyePlane = {1, 2, 3, 4};
             },
             "", ""},
        Case{"LodBias", [](Scene& s) { unitOf(s).lodBias = 1; }, "", "lodBias0"},
        Case{"Volume", [](Scene& s) { unitOf(s).target = Target::Texture3D; }, "", "sampler3D texture0"},
        Case{"EnvironmentColor", [](Scene& s) { unitOf(s).envMode = EnvMode::Blend; }, "",
             "uniform vec4 environmentColor0"},
        Case{"CombineWithoutConstant", [](Scene& s) { unitOf(s).envMode = EnvMode::Combine; }, "",
             "vec3 rgb = rgb0 * rgb1;"},
        Case{"AlphaTest",
             [](Scene& s) {
                 s.passes[0].alphaTest = true;
                 s.passes[0].alphaFunc = CompareFunc::Less;
             },
             "", "discard"},
        Case{"AlphaTestThatAlwaysPasses", [](Scene& s) { s.passes[0].alphaTest = true; }, "", ""},
        Case{"Colour",
             [](Scene& s) {
                 s.material.color = {0, 0, 0, 0};
             },
             "", ""}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(ShaderSource, AUnitThatTakesNoPartLeavesNothing) {
    const ShaderSource source = sourceOf(texturedScene(), {});
    EXPECT_THAT(source.vertex.text, Not(HasSubstr("oord0")));
    EXPECT_THAT(source.fragment.text, Not(HasSubstr("texture")));
}

TEST(ShaderSource, EveryModeHasEveryFormat) {
    Scene scene = texturedScene();
    for (const EnumRow& mode : EnumTable<EnvMode>::rows)
        for (const EnumRow& format : EnumTable<BaseFormat>::rows) {
            unitOf(scene).envMode = static_cast<EnvMode>(mode.value);
            EXPECT_TRUE(shaderSource(scene, 0, oneUnit(static_cast<BaseFormat>(format.value))))
                << mode.name << ' ' << format.name;
        }
}

TEST(ShaderSource, CombineWithTheTextureOfAUnitThatIsOffPassesTheColourOn) {
    Scene scene = texturedScene();
    unitOf(scene).envMode = EnvMode::Combine;
    unitOf(scene).combine.source0Rgb = CombineSource::Texture1;
    EXPECT_THAT(sourceOf(scene).fragment.text, HasSubstr("which is undefined"));
    unitOf(scene).combine.rgb = CombineRgb::Replace;
    unitOf(scene).combine.source0Rgb = CombineSource::Texture0;
    unitOf(scene).combine.source1Rgb = CombineSource::Texture1; // which GL_REPLACE does not look at
    EXPECT_THAT(sourceOf(scene).fragment.text, HasSubstr("vec3 rgb = rgb0;"));
}

TEST(ShaderSource, EachLineKnowsWhereItWasWritten) {
    const StageSource stage = sourceOf(texturedScene()).fragment;
    EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(stage.text, '\n')), stage.lines.size());
    EXPECT_EQ(stage.lines[0].file, "fragment.glsl");
    EXPECT_EQ(stage.lines[0].line, 4);
}

TEST(ShaderPieces, AFileThatIsMissingOrSaysThingsTwiceIsRefused) {
    std::vector<ShaderFile> files = embeddedShaderFiles();
    ASSERT_TRUE(ShaderPieces::parse(files));
    files[1].text += "//@ GL_EYE_LINEAR\n";
    EXPECT_EQ(describe(ShaderPieces::parse(files).error()),
              "texgen.glsl: the piece \"GL_EYE_LINEAR\" is defined twice");
    files.erase(files.begin() + 1);
    EXPECT_EQ(describe(ShaderPieces::parse(files).error()),
              "texgen.glsl: the shaders need this file, which is missing");
}

} // namespace
} // namespace texplorer::glsl::shader_source_test

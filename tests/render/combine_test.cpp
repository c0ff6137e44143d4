// GL_COMBINE against tables 3.23 to 3.25 of the OpenGL 2.1 specification, worked out by hand for
//
//   fragment     Cf = (0.2, 0.4, 0.6)   Af = 0.8
//   texel        Ct = (0.6, 0.2, 0.8)   At = 0.4
//   environment  Cc = (0.4, 0.8, 0.2)   Ac = 0.6
//
// Where a case leaves alpha alone it is modulated: 0.8 * 0.4 = 0.32.

#include "tests/support/flat_scene.h"
#include "tests/support/render_fixture.h"

#include <GL/glew.h>
#include <gmock/gmock.h>

namespace texplorer::combine_test {
namespace {

using namespace test;

Scene combined() {
    Scene scene = texturedScene();
    scene.material.color = {0.2F, 0.4F, 0.6F, 0.8F};
    Unit& unit = scene.passes[0].units[0];
    unit.envMode = EnvMode::Combine;
    unit.envColor = {0.4F, 0.8F, 0.2F, 0.6F};
    return scene;
}

struct Case {
    const char* name;
    void (*edit)(Combine&);
    glm::vec4 expected;
};

class CombineTables : public RenderTest, public testing::WithParamInterface<Case> {};

TEST_P(CombineTables, GiveTheNumber) {
    images.put("image", plainImage(1, 1, {153, 51, 204, 102}));
    Scene scene = combined();
    GetParam().edit(scene.passes[0].units[0].combine);
    EXPECT_TRUE(isColor(onlyColor(scene), GetParam().expected));
    EXPECT_THAT(problems, testing::IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(
    OpenGL21, CombineTables,
    testing::Values(
        Case{"Initially", [](Combine&) {}, {0.12F, 0.08F, 0.48F, 0.32F}},
        Case{"Replace",
             [](Combine& c) {
                 c.rgb = CombineRgb::Replace;
                 c.alpha = CombineAlpha::Replace;
             },
             {0.6F, 0.2F, 0.8F, 0.4F}},
        Case{"AddEndsAtOne",
             [](Combine& c) {
                 c.rgb = CombineRgb::Add;
                 c.alpha = CombineAlpha::Add;
             },
             {0.8F, 0.6F, 1, 1}},
        Case{"AddSigned",
             [](Combine& c) {
                 c.rgb = CombineRgb::AddSigned;
                 c.alpha = CombineAlpha::AddSigned;
             },
             {0.3F, 0.1F, 0.9F, 0.7F}},
        // 0.2 - 0.4 and 0.4 - 0.8 end at 0
        Case{"Subtract",
             [](Combine& c) {
                 c.rgb = CombineRgb::Subtract;
                 c.alpha = CombineAlpha::Subtract;
             },
             {0.4F, 0, 0.2F, 0}},
        // The third argument is the constant's alpha: Ct * 0.6 + Cf * 0.4
        Case{"Interpolate",
             [](Combine& c) {
                 c.rgb = CombineRgb::Interpolate;
                 c.alpha = CombineAlpha::Interpolate;
             },
             {0.44F, 0.28F, 0.72F, 0.56F}},
        // 4 * (0.1 * -0.3 + -0.3 * -0.1 + 0.3 * 0.1)
        Case{"Dot3Rgb", [](Combine& c) { c.rgb = CombineRgb::Dot3Rgb; }, {0.12F, 0.12F, 0.12F, 0.32F}},
        Case{"Dot3RgbaOverrulesAlpha",
             [](Combine& c) {
                 c.rgb = CombineRgb::Dot3Rgba;
                 c.alpha = CombineAlpha::Replace;
             },
             {0.12F, 0.12F, 0.12F, 0.12F}},
        Case{"Dot3RgbaHasTheScaleOfAlpha",
             [](Combine& c) {
                 c.rgb = CombineRgb::Dot3Rgba;
                 c.rgbScale = CombineScale::Two;
                 c.alphaScale = CombineScale::Four;
             },
             {0.24F, 0.24F, 0.24F, 0.48F}},
        Case{"ScaleComesBeforeTheClamp",
             [](Combine& c) {
                 c.rgbScale = CombineScale::Two;
                 c.alphaScale = CombineScale::Four;
             },
             {0.24F, 0.16F, 0.96F, 1}},
        // 2 * (Ct + Cf - 0.5) = 2 * (0.3, 0.1, 0.9)
        Case{"ScaleOfASumWithASign",
             [](Combine& c) {
                 c.rgb = CombineRgb::AddSigned;
                 c.rgbScale = CombineScale::Two;
             },
             {0.6F, 0.2F, 1, 0.32F}},
        Case{"OneMinusColor",
             [](Combine& c) { c.operand0Rgb = OperandRgb::OneMinusSrcColor; },
             {0.08F, 0.32F, 0.12F, 0.32F}},
        Case{"AlphaAsColor",
             [](Combine& c) { c.operand0Rgb = OperandRgb::SrcAlpha; },
             {0.08F, 0.16F, 0.24F, 0.32F}},
        Case{"OneMinusAlphaAsColor",
             [](Combine& c) { c.operand0Rgb = OperandRgb::OneMinusSrcAlpha; },
             {0.12F, 0.24F, 0.36F, 0.32F}},
        Case{"OneMinusAlpha",
             [](Combine& c) { c.operand0Alpha = OperandAlpha::OneMinusSrcAlpha; },
             {0.12F, 0.08F, 0.48F, 0.48F}},
        Case{"Constant",
             [](Combine& c) {
                 c.rgb = CombineRgb::Replace;
                 c.source0Rgb = CombineSource::Constant;
                 c.alpha = CombineAlpha::Replace;
                 c.source0Alpha = CombineSource::Constant;
             },
             {0.4F, 0.8F, 0.2F, 0.6F}},
        // Ct * (0.6, 0.2, 0.8) + Cc * (0.4, 0.8, 0.2)
        Case{"InterpolateByTheTexelItself",
             [](Combine& c) {
                 c.rgb = CombineRgb::Interpolate;
                 c.source1Rgb = CombineSource::Constant;
                 c.source2Rgb = CombineSource::Texture;
                 c.operand2Rgb = OperandRgb::SrcColor;
             },
             {0.52F, 0.68F, 0.68F, 0.32F}}),
    [](const auto& test) { return std::string(test.param.name); });

/// Units 0 and 1: unit 0 modulates Cf with Ct to (0.12, 0.08, 0.48, 0.32), unit 1's texel is white.
class CombineUnits : public RenderTest {
protected:
    glm::vec4 replacedBy(CombineSource source) {
        images.put("image", plainImage(1, 1, {153, 51, 204, 102}));
        images.put("white", plainImage(1, 1, {255, 255, 255, 255}));
        Scene scene = combined();
        scene.textures.push_back(scene.textures[0]);
        scene.textures[1].file = "white";
        Unit& second = scene.passes[0].units[1];
        second = scene.passes[0].units[0];
        second.texture = 1;
        second.combine.rgb = CombineRgb::Replace;
        second.combine.source0Rgb = source;
        second.combine.alpha = CombineAlpha::Replace;
        second.combine.source0Alpha = source;
        return onlyColor(scene);
    }
};

TEST_F(CombineUnits, SeeTheUnitBeforeThem) {
    EXPECT_TRUE(isColor(replacedBy(CombineSource::Previous), {0.12F, 0.08F, 0.48F, 0.32F}));
}
TEST_F(CombineUnits, SeeTheColorBeforeAllTexturing) {
    EXPECT_TRUE(isColor(replacedBy(CombineSource::PrimaryColor), {0.2F, 0.4F, 0.6F, 0.8F}));
}
TEST_F(CombineUnits, SeeTheTextureOfAnotherUnit) {
    EXPECT_TRUE(isColor(replacedBy(CombineSource::Texture0), {0.6F, 0.2F, 0.8F, 0.4F}));
    EXPECT_TRUE(isColor(replacedBy(CombineSource::Texture1), {1, 1, 1, 1}));
}

TEST_F(RenderTest, CombineBeginsWithGlsInitialValues) {
    const auto initial = [](GLenum name) {
        GLint value = -1;
        glGetTexEnviv(GL_TEXTURE_ENV, name, &value);
        return static_cast<std::uint32_t>(value);
    };
    const Combine combine;
    EXPECT_EQ(initial(GL_COMBINE_RGB), static_cast<std::uint32_t>(combine.rgb));
    EXPECT_EQ(initial(GL_COMBINE_ALPHA), static_cast<std::uint32_t>(combine.alpha));
    EXPECT_EQ(initial(GL_SRC0_RGB), static_cast<std::uint32_t>(combine.source0Rgb));
    EXPECT_EQ(initial(GL_SRC1_RGB), static_cast<std::uint32_t>(combine.source1Rgb));
    EXPECT_EQ(initial(GL_SRC2_RGB), static_cast<std::uint32_t>(combine.source2Rgb));
    EXPECT_EQ(initial(GL_SRC0_ALPHA), static_cast<std::uint32_t>(combine.source0Alpha));
    EXPECT_EQ(initial(GL_SRC1_ALPHA), static_cast<std::uint32_t>(combine.source1Alpha));
    EXPECT_EQ(initial(GL_SRC2_ALPHA), static_cast<std::uint32_t>(combine.source2Alpha));
    EXPECT_EQ(initial(GL_OPERAND0_RGB), static_cast<std::uint32_t>(combine.operand0Rgb));
    EXPECT_EQ(initial(GL_OPERAND1_RGB), static_cast<std::uint32_t>(combine.operand1Rgb));
    EXPECT_EQ(initial(GL_OPERAND2_RGB), static_cast<std::uint32_t>(combine.operand2Rgb));
    EXPECT_EQ(initial(GL_OPERAND0_ALPHA), static_cast<std::uint32_t>(combine.operand0Alpha));
    EXPECT_EQ(initial(GL_OPERAND1_ALPHA), static_cast<std::uint32_t>(combine.operand1Alpha));
    EXPECT_EQ(initial(GL_OPERAND2_ALPHA), static_cast<std::uint32_t>(combine.operand2Alpha));
    EXPECT_EQ(initial(GL_RGB_SCALE), static_cast<std::uint32_t>(combine.rgbScale));
    EXPECT_EQ(initial(GL_ALPHA_SCALE), static_cast<std::uint32_t>(combine.alphaScale));
}

} // namespace
} // namespace texplorer::combine_test

// What can't be drawn is said in one sentence, and the rest is drawn.

#include "tests/support/flat_scene.h"
#include "tests/support/render_fixture.h"

#include <GL/glew.h>
#include <gmock/gmock.h>

namespace texplorer::problems_test {
namespace {

using namespace test;
using testing::ElementsAre;
using testing::IsEmpty;

constexpr glm::vec4 untextured{0.2F, 0.4F, 0.6F, 0.8F};

struct Case {
    const char* name;
    void (*spoil)(Scene& scene, view::Capabilities& capabilities);
    const char* sentence;
};

class Problem : public RenderTest, public testing::WithParamInterface<Case> {};

TEST_P(Problem, IsSaidWithEveryFrameAndDrawnWithout) {
    images.put("image", plainImage(16, 2, {255, 0, 0, 255}));
    Scene scene = texturedScene();
    scene.material.color = untextured;
    view::Capabilities lesser = capabilities;
    GetParam().spoil(scene, lesser);
    auto made = makeRenderer(lesser);
    ASSERT_TRUE(made);
    renderer = std::move(*made);
    for (int frame = 0; frame < 2; ++frame) {
        EXPECT_TRUE(isColor(onlyColor(scene), untextured)) << "frame " << frame;
        EXPECT_THAT(problems, ElementsAre(GetParam().sentence)) << "frame " << frame;
    }
}

using Caps = view::Capabilities;

INSTANTIATE_TEST_SUITE_P(
    All, Problem,
    testing::Values(
        Case{"NotLoaded", [](Scene& scene, Caps&) { scene.textures[0].file = "earth.bmp"; },
             "textures[0]: earth.bmp is not loaded; drawn without it"},
        Case{"NoFile", [](Scene& scene, Caps&) { scene.textures[0].file.clear(); },
             "textures[0]: no file is chosen; drawn without it"},
        Case{"NoSuchTexture", [](Scene& scene, Caps&) { scene.passes[0].units[0].texture = 3; },
             "passes[0].units[0]: there is no texture 3, the scene has 1; drawn without it"},
        Case{"NegativeTexture", [](Scene& scene, Caps&) { scene.passes[0].units[0].texture = -1; },
             "passes[0].units[0]: there is no texture -1, the scene has 1; drawn without it"},
        Case{"TooFewUnits",
             [](Scene& scene, Caps& caps) {
                 caps.textureUnits = 2;
                 std::swap(scene.passes[0].units[0], scene.passes[0].units[2]);
             },
             "passes[0].units[2]: the driver has 2 texture units; drawn without this one"},
        Case{"TooLarge", [](Scene&, Caps& caps) { caps.maxTextureSize = 8; },
             "textures[0]: 16 × 2 texels exceed the driver's 8 for GL_TEXTURE_2D; drawn without it"},
        Case{"TooLarge1D",
             [](Scene& scene, Caps& caps) {
                 caps.maxTextureSize = 15;
                 scene.passes[0].units[0].target = Target::Texture1D;
             },
             "textures[0]: 16 texels exceed the driver's 15 for GL_TEXTURE_1D; drawn without it"},
        Case{"TooLarge3D",
             [](Scene& scene, Caps& caps) {
                 caps.max3DTextureSize = 15;
                 scene.passes[0].units[0].target = Target::Texture3D;
             },
             "textures[0]: 16 × 2 × 1 texels exceed the driver's 15 for GL_TEXTURE_3D; drawn without it"},
        Case{
            "GlErrorOfTheMaterial",
            [](Scene& scene, Caps&) {
                scene.passes[0].units[0].enabled = false;
                scene.material.shininess = 200;
            },
            "models[0]: glMaterial, glLineWidth, glPointSize: GL_INVALID_VALUE (A number is out of range.)"}),
    [](const auto& test) { return std::string(test.param.name); });

class Problems : public RenderTest {};

// It would visit texels for hours; what it draws is as without anisotropy.
TEST_F(Problems, NameAnisotropyThatLlvmpipeIsNotGiven) {
    images.put("image",
               rgbaImage(2, 2, 1, {{255, 0, 0, 255}, {0, 255, 0, 255}, {0, 0, 255, 255}, {9, 9, 9, 255}}));
    if (anisotropy() != reference::AnisotropyMethod::Ellipse)
        GTEST_SKIP() << capabilities.renderer << " gets through it";
    const auto endless = testing::HasSubstr("visits every texel that a pixel covers");
    for (const float lower : {1.0F, -1.0F}) {
        Scene scene = texturedScene();
        scene.models[0].texCoords[0] = quadCoords({0, 0, 0, 1}, {1, 1, 0, 1});
        scene.models[0].texCoords[0].edit()[0].q = lower;
        const Image plain = picture(scene, 64);
        scene.textures[0].maxAnisotropy = 16;
        const Image found = picture(scene, 64);
        if (lower > 0) {
            EXPECT_THAT(problems, IsEmpty());
            continue;
        }
        EXPECT_THAT(problems, ElementsAre(endless));
        EXPECT_EQ(found.pixels, plain.pixels);
    }
}

TEST_F(Problems, OfTextureParametersNameTheTexture) {
    images.put("image", plainImage(1, 1, {255, 0, 0, 255}));
    Scene scene = texturedScene();
    scene.textures[0].wrapR = static_cast<Wrap>(1);
    for (int frame = 0; frame < 2; ++frame) {
        EXPECT_TRUE(isColor(onlyColor(scene), {1, 0, 0, 1}));
        EXPECT_THAT(
            problems,
            ElementsAre("textures[0]: glTexParameter: GL_INVALID_ENUM (An enumerant is not accepted here.)"))
            << "frame " << frame;
    }
    scene.textures[0].wrapR = Wrap::Repeat;
    EXPECT_TRUE(isColor(onlyColor(scene), {1, 0, 0, 1}));
    EXPECT_THAT(problems, IsEmpty());
}

TEST_F(Problems, OfAnisotropyNameTheDriversLimit) {
    images.put("image", plainImage(1, 1, {255, 0, 0, 255}));
    Scene scene = texturedScene();
    scene.textures[0].maxAnisotropy = 8;
    capabilities.maxAnisotropy = 1; // without GL_EXT_texture_filter_anisotropic
    auto made = makeRenderer(capabilities);
    ASSERT_TRUE(made);
    renderer = std::move(*made);
    for (int frame = 0; frame < 2; ++frame) {
        EXPECT_TRUE(isColor(onlyColor(scene), {1, 0, 0, 1}));
        EXPECT_THAT(problems,
                    ElementsAre("textures[0]: an anisotropy of 8 exceeds the driver's 1; drawn with that"))
            << "frame " << frame;
    }
    scene.textures[0].maxAnisotropy = 1;
    EXPECT_TRUE(isColor(onlyColor(scene), {1, 0, 0, 1}));
    EXPECT_THAT(problems, IsEmpty());
}

TEST_F(Problems, LeftOverByOthersAreNotBlamedOnTheScene) {
    glEnable(0xFFFF);
    EXPECT_TRUE(isColor(onlyColor(flatScene()), {1, 1, 1, 1}));
    EXPECT_THAT(
        problems,
        ElementsAre("before the scene was drawn: GL_INVALID_ENUM (An enumerant is not accepted here.)"));
    (void)onlyColor(flatScene());
    EXPECT_THAT(problems, IsEmpty());
}

TEST_F(Problems, ASceneWithoutModelsOrPassesIsItsBackground) {
    Scene scene = flatScene();
    scene.view.background = untextured;
    scene.passes.clear();
    EXPECT_TRUE(isColor(onlyColor(scene), untextured));
    scene = flatScene();
    scene.view.background = untextured;
    scene.models[0].visible = false;
    EXPECT_TRUE(isColor(onlyColor(scene), untextured));
    scene.models.clear();
    EXPECT_TRUE(isColor(onlyColor(scene), untextured));
    EXPECT_THAT(problems, IsEmpty());
}

TEST_F(Problems, ATexCoordListOfTheWrongLengthIsTheMeshs) {
    images.put("image", rgbaImage(2, 1, 1, {{255, 0, 0, 255}, {0, 255, 0, 255}}));
    Scene scene = texturedScene();
    const Image expected = picture(scene);
    scene.models[0].texCoords[0] = {{0, 0, 0, 1}};
    EXPECT_EQ(picture(scene), expected);
    EXPECT_THAT(problems, IsEmpty());
}

struct SizeCase {
    const char* name;
    view::Size size;
};

class PictureSize : public RenderTest, public testing::WithParamInterface<SizeCase> {};

TEST_P(PictureSize, IsRefusedWithTheLimit) {
    const auto [width, height] = GetParam().size;
    const auto frame = renderer->draw(flatScene(), images, 0, {width, height});
    ASSERT_FALSE(frame);
    EXPECT_EQ(frame.error().code, ErrorCode::OutOfRange);
    EXPECT_EQ(frame.error().message, "a picture has 1 × 1 to 16384 × 16384 pixels, not " +
                                         std::to_string(width) + " × " + std::to_string(height));
    EXPECT_TRUE(isColor(onlyColor(flatScene()), {1, 1, 1, 1})) << "and the next one is drawn";
}

INSTANTIATE_TEST_SUITE_P(All, PictureSize,
                         testing::Values(SizeCase{"NoWidth", {0, 4}}, SizeCase{"NoHeight", {4, 0}},
                                         SizeCase{"Negative", {4, -1}}, SizeCase{"TooWide", {16385, 1}},
                                         SizeCase{"Huge", {100000, 100000}}),
                         [](const auto& test) { return std::string(test.param.name); });

} // namespace
} // namespace texplorer::problems_test

// Fog (OpenGL 2.1, section 3.10) on a square that faces the viewer, worked out by hand.

#include "tests/support/flat_scene.h"
#include "tests/support/render_fixture.h"

#include <glm/common.hpp>
#include <gmock/gmock.h>

namespace texplorer::fog_test {
namespace {

using namespace test;

constexpr glm::vec4 color{0.2F, 0.4F, 0.6F, 0.8F};
constexpr glm::vec4 fogColor{1, 0, 0.5F, 0.3F};

glm::vec4 mixed(float factor) {
    return {glm::mix(glm::vec3(fogColor), glm::vec3(color), factor), color.a};
}

struct Case {
    const char* name;
    Fog fog;
    float z; ///< of the square; the eye is at 1
    float factor;
};
class FogOfASquare : public RenderTest, public testing::WithParamInterface<Case> {};

TEST_P(FogOfASquare, LeavesTheShareOfTheEquation) {
    Scene scene = flatScene();
    scene.material.color = color;
    scene.models[0].position.z = GetParam().z;
    scene.passes[0].fog = GetParam().fog;
    EXPECT_TRUE(isColor(onlyColor(scene), mixed(GetParam().factor)));
    EXPECT_THAT(problems, testing::IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(
    All, FogOfASquare,
    testing::Values(Case{"Off", {false, FogMode::Exp, 1, 0, 1, fogColor}, 0, 1},
                    Case{"Exp", {true, FogMode::Exp, 0.5F, 0, 1, fogColor}, -1, 0.3678794F},
                    Case{"Exp2", {true, FogMode::Exp2, 0.25F, 0, 1, fogColor}, -3, 0.3678794F},
                    Case{"Linear", {true, FogMode::Linear, 1, 2, 6, fogColor}, -3, 0.5F},
                    Case{"LinearBeforeTheStart", {true, FogMode::Linear, 1, 2, 6, fogColor}, 0, 1},
                    Case{"LinearBeyondTheEnd", {true, FogMode::Linear, 1, 2, 6, fogColor}, -9, 0},
                    Case{"LinearBackwards", {true, FogMode::Linear, 1, 6, 2, fogColor}, -2, 0.25F},
                    // A parallel view shows what is behind the eye as well: |z| counts.
                    Case{"BehindTheEye", {true, FogMode::Linear, 1, 2, 6, fogColor}, 4, 0.75F}),
    [](const auto& test) { return std::string(test.param.name); });

class FogAndTheRest : public RenderTest {
protected:
    /// Half of the colour is left.
    static Scene halfHidden() {
        Scene scene = flatScene();
        scene.material.color = color;
        scene.models[0].position.z = -3;
        scene.passes[0].fog = {true, FogMode::Linear, 1, 2, 6, fogColor};
        return scene;
    }
};

TEST_F(FogAndTheRest, ItsColorIsClamped) {
    Scene scene = halfHidden();
    scene.passes[0].fog.color = {3, -2, 0.5F, 0};
    EXPECT_TRUE(isColor(onlyColor(scene), mixed(0.5F)));
}

TEST_F(FogAndTheRest, ComesAfterTexturing) {
    images.put("image", plainImage(1, 1, {51, 102, 153, 204}));
    Scene scene = texturedScene();
    scene.models[0].position.z = -3;
    scene.passes[0].fog = halfHidden().passes[0].fog;
    EXPECT_TRUE(isColor(onlyColor(scene), mixed(0.5F)));
}

// 0.2 * 0.5, and the highlight of 0.25 after it; then half of it.
TEST_F(FogAndTheRest, ComesAfterTheColorSum) {
    images.put("image", plainImage(1, 1, {51, 51, 51, 255}));
    Scene scene = texturedScene();
    scene.models[0].position.z = -3;
    scene.passes[0].units[0].envMode = EnvMode::Modulate;
    scene.passes[0].lighting = true;
    scene.passes[0].fog = {true, FogMode::Linear, 1, 2, 6, {1, 1, 1, 1}};
    scene.light.modelAmbient = {0, 0, 0, 1};
    scene.light.diffuse = {0.5F, 0.5F, 0.5F, 1};
    scene.light.specular = {0.25F, 0.25F, 0.25F, 1};
    scene.light.colorControl = ColorControl::SeparateSpecular;
    scene.material.specular = {1, 1, 1, 1};
    const float expected = (0.2F * 0.5F + 0.25F) / 2 + 0.5F;
    EXPECT_TRUE(isColor(onlyColor(scene), {expected, expected, expected, 1}));
}

TEST_F(FogAndTheRest, ComesBeforeBlending) {
    Scene scene = halfHidden();
    scene.view.background = {0.5F, 0.5F, 0.5F, 0.5F};
    scene.passes[0].blend = true;
    scene.passes[0].blendDst = BlendFactor::One;
    EXPECT_TRUE(isColor(onlyColor(scene), glm::min(mixed(0.5F) + 0.5F, 1.0F)));
}

TEST_F(FogAndTheRest, EachPassHasItsOwn) {
    Scene scene = halfHidden();
    scene.passes.push_back(scene.passes[0]);
    scene.passes[1].fog = {};
    EXPECT_TRUE(isColor(onlyColor(scene), color));
    std::swap(scene.passes[0], scene.passes[1]);
    EXPECT_TRUE(isColor(onlyColor(scene), mixed(0.5F)));
}

// A square that leans away, from 2 in front of the eye to 6: at each pixel its own distance counts, and not
// what the corners have, mixed as the window shows them.
TEST_F(FogAndTheRest, IsThatOfEachFragment) {
    Scene scene;
    scene.view.fieldOfView = 90;
    scene.view.distance = 4;
    scene.models.resize(1);
    scene.models[0].shape = Shape::Quad;
    scene.models[0].rotation = {-90, 0, 0}; // a floor
    scene.models[0].position = {0, -1, 0};
    scene.models[0].size = 2;
    scene.material.color = {0, 0, 0, 1};
    scene.passes[0].fog = {true, FogMode::Linear, 1, 2, 6, {1, 1, 1, 1}};
    const Image image = picture(scene, 64);
    for (const int y : {18, 20, 22, 24}) {
        const float slope = 1 - (static_cast<float>(y) + 0.5F) / 32; // of the ray through the pixel
        const float distance = 1 / slope;
        const float expected = (distance - 2) / 4;
        EXPECT_TRUE(isColor(colorAt(image, 32, y), {expected, expected, expected, 1})) << y;
    }
}

} // namespace
} // namespace texplorer::fog_test

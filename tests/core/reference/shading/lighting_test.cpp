// Section 2.14.1 of the OpenGL 2.1 specification, worked out by hand. Material 0.5, 0.25, 1 with alpha 0.8.
// Ambient: the model's 0.2 and, for red, the light's 0.2. Diffuse light: 0.6.

#include "core/reference/shading/lighting.h"
#include "tests/core/reference/textures.h"

#include <limits>

namespace texplorer::reference::lighting_test {
namespace {

using namespace test;

struct Case {
    const char* name;
    glm::vec4 light;
    bool localViewer;
    float shininess;
    glm::vec4 primary; // separate
    glm::vec3 secondary;
};
class LightingRule : public testing::TestWithParam<Case> {
protected:
    LightingRule() {
        material.color = {0.5F, 0.25F, 1, 0.8F};
        material.specular = {0.3F, 0.2F, 0.1F, 1};
        material.shininess = GetParam().shininess;
        light.position = GetParam().light;
        light.ambient = {0.2F, 0, 0, 1};
        light.diffuse = {0.6F, 0.6F, 0.6F, 1};
        light.localViewer = GetParam().localViewer;
    }
    Material material;
    Light light;
};

TEST_P(LightingRule, GivesTheColorsOfTheEquation) {
    const LightingTerms terms = lightingTerms(light, material, {0, 0, -2}, {0, 0, 1});
    const VertexColors apart = litColors(terms, material, ColorControl::SeparateSpecular);
    EXPECT_TRUE(isNear(apart.primary, GetParam().primary));
    EXPECT_TRUE(isNear(glm::vec4(apart.secondary, 0), glm::vec4(GetParam().secondary, 0)));
    const VertexColors single = litColors(terms, material, ColorControl::Single);
    EXPECT_TRUE(isNear(single.primary, GetParam().primary + glm::vec4(GetParam().secondary, 0)));
    EXPECT_EQ(single.secondary, glm::vec3(0));
}

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
INSTANTIATE_TEST_SUITE_P(
    All, LightingRule,
    testing::Values(
        Case{"Frontal", {0, 0, 1, 0}, false, 8, {0.5F, 0.2F, 0.8F, 0.8F}, {0.3F, 0.2F, 0.1F}},
        // 60 degrees off: n.l = 0.5, n.h = cos 30, squared 0.75
        Case{
            "Slanted", {0, 1.7320508F, 1, 0}, false, 2, {0.35F, 0.125F, 0.5F, 0.8F}, {0.225F, 0.15F, 0.075F}},
        // The same direction, from a place: (0, 2 sqrt 3, 2) away from the vertex
        Case{"FromAPlace",
             {0, 3.4641016F, 0, 1},
             false,
             2,
             {0.35F, 0.125F, 0.5F, 0.8F},
             {0.225F, 0.15F, 0.075F}},
        Case{"LocalViewerStraightAhead",
             {0, 1.7320508F, 1, 0},
             true,
             2,
             {0.35F, 0.125F, 0.5F, 0.8F},
             {0.225F, 0.15F, 0.075F}},
        Case{"FromBehind", {0, 0, -1, 0}, false, 0, {0.2F, 0.05F, 0.2F, 0.8F}, {0, 0, 0}},
        Case{"NoShininess", {0, 1.7320508F, 1, 0}, false, 0, {0.35F, 0.125F, 0.5F, 0.8F}, {0.3F, 0.2F, 0.1F}},
        Case{"NoDirection", {0, 0, 0, 0}, false, 2, {0.2F, 0.05F, 0.2F, 0.8F}, {0, 0, 0}},
        Case{"NotANumber", {nan, 0, 0, 0}, false, 2, {0.2F, 0.05F, 0.2F, 0.8F}, {0, 0, 0}}),
    [](const auto& test) { return std::string(test.param.name); });

} // namespace
} // namespace texplorer::reference::lighting_test

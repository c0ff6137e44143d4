// Section 2.14.1 of the OpenGL 2.1 specification, worked out by hand. Material 0.5, 0.25, 1 with alpha 0.8.
// Ambient: the model's 0.2 and, for red, the light's 0.2. Diffuse light: 0.6.

#include "tests/core/reference/textures.h"
#include "texplorer/reference/shading/lighting.h"

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
    const Reflectance surface(material, material.color);
    const LightingTerms terms = lightingTerms(light, surface, {0, 0, -2}, {0, 0, 1});
    const VertexColors apart = litColors(terms, surface, ColorControl::SeparateSpecular);
    EXPECT_TRUE(isNear(apart.primary, GetParam().primary));
    EXPECT_TRUE(isNear(glm::vec4(apart.secondary, 0), glm::vec4(GetParam().secondary, 0)));
    const VertexColors single = litColors(terms, surface, ColorControl::Single);
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

// Sections 2.14.2 and 2.14.3: which properties follow the current colour.
TEST(AReflectance, IsTheCurrentColorUnderColorMaterial) {
    Material material;
    material.ambient = {0.1F, 0.2F, 0.3F, 0.4F};
    material.diffuse = {0.5F, 0.6F, 0.7F, 0.8F};
    material.specular = {0.9F, 0.8F, 0.7F, 0.6F};
    material.emission = {0.2F, 0.1F, 0, 0.3F};
    material.shininess = 5;
    material.color = {1, 0, 0, 1};
    const glm::vec4 current{0.25F, 0.75F, 0.5F, 0.125F}; // a vertex's own
    const Reflectance tracked(material, current);
    EXPECT_EQ(tracked.ambient, glm::vec3(current));
    EXPECT_EQ(tracked.diffuse, current);
    material.colorMaterial = false;
    const Reflectance own(material, current);
    EXPECT_EQ(own.ambient, glm::vec3(material.ambient));
    EXPECT_EQ(own.diffuse, material.diffuse);
    for (const Reflectance& each : {tracked, own}) {
        EXPECT_EQ(each.specular, glm::vec3(material.specular));
        EXPECT_EQ(each.emission, glm::vec3(material.emission));
        EXPECT_EQ(each.shininess, 5);
    }
}

// OpenGL's default material and light model, a white light straight ahead: 0.2 * 0.2 + 0.8.
TEST(ColorsOfALitVertex, HaveGlsOwnMaterialWithoutColorMaterial) {
    Material material;
    material.colorMaterial = false;
    material.color = {1, 0, 0, 0.5F}; // which has no effect
    const Reflectance surface(material, material.color);
    const VertexColors colors =
        litColors(lightingTerms(Light{}, surface, {0, 0, -2}, {0, 0, 1}), surface, ColorControl::Single);
    EXPECT_TRUE(isNear(colors.primary, {0.84F, 0.84F, 0.84F, 1}));
}

// Ambient 0.25 * (0.2 + 0.1), diffuse 0.5 * 0.6 at 60 degrees, emission on top. The alpha is the diffuse
// one's.
TEST(ColorsOfALitVertex, AddAmbientDiffuseAndEmission) {
    Light light;
    light.position = {0, 1.7320508F, 1, 0};
    light.ambient = {0.1F, 0.1F, 0.1F, 1};
    light.diffuse = {0.6F, 0.6F, 0.6F, 1};
    Material material;
    material.colorMaterial = false;
    material.ambient = {0.25F, 0.25F, 0.25F, 0.9F};
    material.diffuse = {0.5F, 0.5F, 0.5F, 0.7F};
    material.emission = {0.5F, 0.125F, 0, 0.9F};
    const Reflectance surface(material, glm::vec4(1));
    const LightingTerms terms = lightingTerms(light, surface, {0, 0, -2}, {0, 0, 1});
    EXPECT_TRUE(isNear(glm::vec4(terms.emission, 0), {0.5F, 0.125F, 0, 0}));
    EXPECT_TRUE(isNear(glm::vec4(terms.scene, 0), {0.05F, 0.05F, 0.05F, 0}));
    EXPECT_TRUE(isNear(glm::vec4(terms.ambient, 0), {0.025F, 0.025F, 0.025F, 0}));
    EXPECT_TRUE(isNear(glm::vec4(terms.diffuse, 0), {0.15F, 0.15F, 0.15F, 0}));
    const VertexColors colors = litColors(terms, surface, ColorControl::SeparateSpecular);
    EXPECT_TRUE(isNear(colors.primary, {0.725F, 0.35F, 0.225F, 0.7F}));
}

// In the dark, and where the sum is more than 1.
TEST(ColorsOfALitVertex, ShineByThemselves) {
    Light dark;
    dark.diffuse = dark.specular = dark.modelAmbient = {0, 0, 0, 1};
    Material material;
    material.emission = {0.5F, 0.25F, 1, 1};
    const Reflectance surface(material, {1, 1, 1, 0.25F});
    const LightingTerms none = lightingTerms(dark, surface, {0, 0, -2}, {0, 0, 1});
    EXPECT_TRUE(isNear(litColors(none, surface, ColorControl::Single).primary, {0.5F, 0.25F, 1, 0.25F}));
    const LightingTerms much = lightingTerms(Light{}, surface, {0, 0, -2}, {0, 0, 1});
    EXPECT_EQ(litColors(much, surface, ColorControl::Single).primary, glm::vec4(1, 1, 1, 0.25F));
}

TEST(ColorsOfAnUnlitVertex, AreTheCurrentOne) {
    EXPECT_EQ(unlitColors({0.25F, 2, -1, 0.5F}).primary, glm::vec4(0.25F, 1, 0, 0.5F));
    EXPECT_EQ(unlitColors({0.25F, 2, -1, 0.5F}).secondary, glm::vec3(0));
}

} // namespace
} // namespace texplorer::reference::lighting_test

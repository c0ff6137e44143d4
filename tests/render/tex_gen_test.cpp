// Generated coordinates against section 2.11.4 of the OpenGL 2.1 specification: a scene that generates them
// looks like one whose vertices have the results of the formulas.

#include "tests/support/flat_scene.h"
#include "tests/support/render_fixture.h"
#include "texplorer/reference/draw.h"
#include "texplorer/scene/animation.h"
#include "texplorer/scene/model_mesh.h"

#include <GL/glew.h>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat3x3.hpp>
#include <gmock/gmock.h>

#include <cmath>

namespace texplorer::tex_gen_test {
namespace {

using namespace test;

class ZeroNormal : public RenderTest {};

constexpr std::array planes{glm::vec4{0.5F, 0.25F, -0.3F, 0.1F}, glm::vec4{-0.2F, 0.6F, 0.4F, 0.3F},
                            glm::vec4{0.1F, 0.2F, 0.3F, 0.4F}, glm::vec4{0.05F, -0.1F, 0.02F, 1}};

/// A sphere that is rotated, moved and seen in perspective, so that nothing is on an axis.
Scene sphereScene() {
    Scene scene = texturedScene();
    scene.view = View{.azimuth = 25, .elevation = 10, .distance = 5};
    scene.models[0] = Model{.shape = Shape::Sphere,
                            .slices = 9,
                            .stacks = 7,
                            .position = {0.3F, -0.2F, 0.4F},
                            .rotation = {20, 40, 60}};
    scene.passes[0].depthTest = true;
    Unit& unit = scene.passes[0].units[0];
    const std::array coordinates{&unit.texGenS, &unit.texGenT, &unit.texGenR, &unit.texGenQ};
    for (std::size_t i = 0; i < coordinates.size(); ++i)
        coordinates[i]->eyePlane = coordinates[i]->objectPlane = planes[i];
    return scene;
}

/// A vertex with the values of section 2.11.4: its position in model and eye coordinates, and its normal in
/// eye coordinates.
struct Seen {
    glm::vec4 object;
    glm::vec4 eye;
    glm::vec3 normal;
    glm::vec4 given;
};

glm::vec3 reflected(const Seen& seen) {
    const glm::vec3 u = glm::normalize(glm::vec3(seen.eye));
    return u - 2.0F * seen.normal * glm::dot(seen.normal, u);
}

glm::vec2 sphereMapped(const Seen& seen) {
    const glm::vec3 r = reflected(seen);
    const float m = 2 * std::sqrt(r.x * r.x + r.y * r.y + (r.z + 1) * (r.z + 1));
    return {r.x / m + 0.5F, r.y / m + 0.5F};
}

struct Case {
    const char* name;
    void (*generate)(Unit&);
    glm::vec4 (*formula)(const Seen&);
};

void all(Unit& unit, int count, TexGenMode mode) {
    const std::array coordinates{&unit.texGenS, &unit.texGenT, &unit.texGenR, &unit.texGenQ};
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
        coordinates[i]->enabled = true;
        coordinates[i]->mode = mode;
    }
}

glm::vec4 onPlanes(const glm::vec4& v) {
    return {glm::dot(v, planes[0]), glm::dot(v, planes[1]), glm::dot(v, planes[2]), glm::dot(v, planes[3])};
}

class Generated : public RenderTest, public testing::WithParamInterface<Case> {};

TEST_P(Generated, CoordinatesAreThoseOfTheFormula) {
    images.put("image", rgbaImage(4, 4, 1,
                                  {{255, 0, 0, 255},
                                   {0, 255, 0, 255},
                                   {0, 0, 255, 255},
                                   {255, 255, 0, 255},
                                   {0, 255, 255, 255},
                                   {255, 0, 255, 255},
                                   {90, 0, 0, 255},
                                   {0, 90, 0, 255},
                                   {0, 0, 90, 255},
                                   {90, 90, 0, 255},
                                   {0, 90, 90, 255},
                                   {90, 0, 90, 255},
                                   {200, 60, 0, 255},
                                   {0, 200, 60, 255},
                                   {60, 0, 200, 255},
                                   {60, 200, 0, 255}}));
    Scene given = sphereScene();
    Model& model = given.models[0];
    const glm::mat4 toEye = viewMatrix(given.view) * modelMatrix(model, 0);
    for (const Vertex& vertex : meshOf(model).vertices) {
        const glm::vec4 object(vertex.position, 1);
        model.texCoords[0].push_back(GetParam().formula(
            {object, toEye * object, glm::normalize(glm::mat3(toEye) * vertex.normal), vertex.texCoord}));
    }
    Scene generated = sphereScene();
    GetParam().generate(generated.passes[0].units[0]);

    constexpr int extent = 128;
    const Image expected = picture(given, extent);
    const Image found = picture(generated, extent);
    EXPECT_THAT(problems, testing::IsEmpty());
    std::size_t different = 0;
    std::size_t covered = 0;
    for (int y = 0; y < extent; ++y)
        for (int x = 0; x < extent; ++x) {
            covered += colorAt(expected, x, y).a > 0 ? 1U : 0U;
            different += colorAt(expected, x, y) != colorAt(found, x, y) ? 1U : 0U;
        }
    EXPECT_GT(covered, 4000U);
    // The last bits of a coordinate decide at the edges of texels.
    EXPECT_LE(different, covered / 200);
    EXPECT_NE(picture(sphereScene(), extent).pixels, found.pixels) << "nothing was generated";
}

INSTANTIATE_TEST_SUITE_P(
    OpenGL21, Generated,
    testing::Values(Case{"ObjectLinear", [](Unit& unit) { all(unit, 4, TexGenMode::ObjectLinear); },
                         [](const Seen& seen) { return onPlanes(seen.object); }},
                    Case{"EyeLinear", [](Unit& unit) { all(unit, 4, TexGenMode::EyeLinear); },
                         [](const Seen& seen) { return onPlanes(seen.eye); }},
                    Case{"SphereMap", [](Unit& unit) { all(unit, 2, TexGenMode::SphereMap); },
                         [](const Seen& seen) { return glm::vec4(sphereMapped(seen), 0, 1); }},
                    Case{"ReflectionMap", [](Unit& unit) { all(unit, 3, TexGenMode::ReflectionMap); },
                         [](const Seen& seen) { return glm::vec4(reflected(seen), 1); }},
                    Case{"NormalMap", [](Unit& unit) { all(unit, 3, TexGenMode::NormalMap); },
                         [](const Seen& seen) { return glm::vec4(seen.normal, 1); }},
                    Case{"TAlone",
                         [](Unit& unit) {
                             unit.texGenT.enabled = true;
                             unit.texGenT.mode = TexGenMode::ObjectLinear;
                         },
                         [](const Seen& seen) {
                             return glm::vec4(seen.given.s, glm::dot(seen.object, planes[1]), seen.given.p,
                                              seen.given.q);
                         }}),
    [](const auto& test) { return std::string(test.param.name); });

TEST_F(RenderTest, EyePlanesStandStillInEveryPass) {
    images.put("image", rgbaImage(2, 1, 1, {{255, 0, 0, 255}, {0, 255, 0, 255}}));
    Scene scene = sphereScene();
    all(scene.passes[0].units[0], 2, TexGenMode::EyeLinear);
    const Image once = picture(scene, 64);
    scene.passes.push_back(scene.passes[0]);
    scene.passes[1].depthFunc = CompareFunc::LessEqual;
    EXPECT_EQ(picture(scene, 64).pixels, once.pixels);
}

TEST_F(RenderTest, GeneratedCoordinatesBeginWithGlsInitialValues) {
    const Unit unit;
    const std::array rows{std::pair{GL_S, unit.texGenS}, std::pair{GL_T, unit.texGenT},
                          std::pair{GL_R, unit.texGenR}, std::pair{GL_Q, unit.texGenQ}};
    for (const auto& [coordinate, expected] : rows) {
        const auto name = static_cast<GLenum>(coordinate);
        GLint mode = 0;
        glGetTexGeniv(name, GL_TEXTURE_GEN_MODE, &mode);
        glm::vec4 object(-1);
        glGetTexGenfv(name, GL_OBJECT_PLANE, glm::value_ptr(object));
        glm::vec4 eye(-1);
        glGetTexGenfv(name, GL_EYE_PLANE, glm::value_ptr(eye));
        EXPECT_EQ(static_cast<std::uint32_t>(mode), static_cast<std::uint32_t>(expected.mode));
        EXPECT_EQ(object, expected.objectPlane);
        EXPECT_EQ(eye, expected.eyePlane);
    }
}

// OpenGL leaves the result of a normal without a length open; the shaders and the reference keep it 0.
TEST_F(ZeroNormal, IsTheSameInShadersAndReference) {
    if (testedRenderer() != RendererKind::Shader)
        GTEST_SKIP() << "fixed function has its own answer";
    images.put("image",
               rgbaImage(2, 2, 1, {{255, 0, 0, 255}, {0, 255, 0, 255}, {0, 0, 255, 255}, {9, 9, 9, 255}}));
    for (const TexGenMode mode : {TexGenMode::SphereMap, TexGenMode::ReflectionMap, TexGenMode::NormalMap}) {
        Scene scene = sphereScene();
        scene.models[0] = Model{.shape = Shape::Mesh};
        scene.models[0].mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}};
        scene.models[0].mesh.normals.assign(3, glm::vec3(0));
        scene.passes[0].lighting = true;
        Unit& unit = scene.passes[0].units[0];
        unit.envMode = EnvMode::Modulate;
        unit.texGenS.enabled = unit.texGenT.enabled = true;
        unit.texGenS.mode = unit.texGenT.mode = mode;
        const Image found = picture(scene, 64);
        const Result<Frame> expected = reference::drawReference({scene, images, 0, 64, 64});
        ASSERT_TRUE(expected) << describe(expected.error());
        int different = 0;
        for (int y = 0; y < 64; ++y) {
            for (int x = 0; x < 64; ++x)
                different += isColor(colorAt(found, x, y), colorAt(expected->image, x, y), 2) ? 0 : 1;
        }
        EXPECT_LE(different, 20) << rowOf(mode).name; // along edges of texels
    }
}

} // namespace
} // namespace texplorer::tex_gen_test

// GL_LIGHT_MODEL_TWO_SIDE (OpenGL 2.1, section 2.14.1) on a square that faces the viewer or turns its back,
// worked out by hand.

#include "tests/support/flat_scene.h"
#include "tests/support/render_fixture.h"

#include <gmock/gmock.h>

namespace texplorer::two_side_test {
namespace {

using namespace test;

// Ambient 0.1 of white, diffuse 0.5, specular 0.25: the light stands behind the viewer.
constexpr glm::vec4 lit{0.85F, 0.85F, 0.85F, 1};
constexpr glm::vec4 dark{0.1F, 0.1F, 0.1F, 1};

Scene litScene(bool twoSide) {
    Scene scene = flatScene();
    scene.passes[0].lighting = true;
    scene.light.modelAmbient = {0.1F, 0.1F, 0.1F, 1};
    scene.light.diffuse = {0.5F, 0.5F, 0.5F, 1};
    scene.light.specular = {0.25F, 0.25F, 0.25F, 1};
    scene.light.twoSide = twoSide;
    scene.material.specular = {1, 1, 1, 1};
    return scene;
}

struct Case {
    const char* name;
    bool twoSide;
    void (*edit)(Scene& scene);
    glm::vec4 expected;
};
class TwoSides : public RenderTest, public testing::WithParamInterface<Case> {};

TEST_P(TwoSides, AreLitByTheirOwnNormals) {
    for (const ShadeModel shading : {ShadeModel::Smooth, ShadeModel::Flat}) {
        Scene scene = litScene(GetParam().twoSide);
        scene.material.shadeModel = shading;
        GetParam().edit(scene);
        EXPECT_TRUE(isColor(onlyColor(scene), GetParam().expected));
        EXPECT_THAT(problems, testing::IsEmpty());
    }
}

void turn(Scene& scene) {
    scene.models[0].rotation = {0, 180, 0};
}

INSTANTIATE_TEST_SUITE_P(
    All, TwoSides,
    testing::Values(Case{"Front", true, [](Scene&) {}, lit}, Case{"FrontOfOne", false, [](Scene&) {}, lit},
                    Case{"Back", true, turn, lit}, Case{"BackOfOne", false, turn, dark},
                    Case{"LightFromBehind", true, [](Scene& s) { s.light.position.z = -1; }, dark},
                    Case{"LightFromBehindOnTheBack", true,
                         [](Scene& s) {
                             turn(s);
                             s.light.position.z = -1;
                         },
                         dark},
                    // Mirrored, it runs clockwise in the window while its normal still looks at the viewer.
                    Case{"Mirrored", true, [](Scene& s) { s.models[0].scale.x = -1; }, dark},
                    Case{"MirroredOfOne", false, [](Scene& s) { s.models[0].scale.x = -1; }, lit},
                    Case{"MirroredBack", true,
                         [](Scene& s) {
                             turn(s);
                             s.models[0].scale.x = -1;
                         },
                         dark},
                    Case{"Unlit",
                         true,
                         [](Scene& s) {
                             turn(s);
                             s.passes[0].lighting = false;
                             s.material.color = {0.2F, 0.4F, 0.6F, 0.8F};
                         },
                         {0.2F, 0.4F, 0.6F, 0.8F}}),
    [](const auto& test) { return std::string(test.param.name); });

class TwoSidesOfOther : public RenderTest {};

// The highlight is the secondary colour, which has two sides as well: 0.6 * 0.2 + 0.25.
TEST_F(TwoSidesOfOther, ColorsAreTheSecondaryOnesToo) {
    images.put("image", plainImage(1, 1, {51, 51, 51, 255}));
    Scene scene = litScene(true);
    turn(scene);
    scene.passes[0].units[0].enabled = true;
    scene.passes[0].units[0].envMode = EnvMode::Modulate;
    scene.light.colorControl = ColorControl::SeparateSpecular;
    EXPECT_TRUE(isColor(onlyColor(scene), {0.37F, 0.37F, 0.37F, 1}));
    scene.light.twoSide = false;
    EXPECT_TRUE(isColor(onlyColor(scene), {0.02F, 0.02F, 0.02F, 1}));
}

// Lines and points have no sides: they are lit as the front.
TEST_F(TwoSidesOfOther, PrimitivesThanPolygonsAreTheFront) {
    for (const Primitive primitive : {Primitive::Points, Primitive::Lines}) {
        Scene scene = litScene(true);
        Model& model = scene.models[0];
        model.shape = Shape::Mesh;
        model.mesh.primitive = primitive;
        model.mesh.positions = {{-2, 0, 0}, {2, 0, 0}};
        if (primitive == Primitive::Points)
            model.mesh.positions = {{0, 0, 0}};
        model.lineWidth = model.pointSize = 5;
        for (const float z : {1.0F, -1.0F}) {
            model.mesh.normals.assign(model.mesh.positions.size(), {0, 0, z});
            EXPECT_TRUE(isColor(colorAt(picture(scene), 4, 4), z > 0 ? lit : dark));
        }
    }
}

// Under GL_FLAT the back has the back colour of the last vertex.
TEST_F(TwoSidesOfOther, VerticesGiveTheBackOfTheLastOneUnderFlat) {
    Scene scene = litScene(true);
    scene.material.shadeModel = ShadeModel::Flat;
    scene.material.specular = {0, 0, 0, 1};
    Model& model = scene.models[0];
    model.shape = Shape::Mesh;
    model.mesh.primitive = Primitive::Triangles;
    model.mesh.positions = {{-3, -3, 0}, {0, 5, 0}, {3, -3, 0}}; // clockwise
    model.mesh.normals = {{0, 0, 1}, {0, 0, 1}, {0, 0, -1}};
    EXPECT_TRUE(isColor(onlyColor(scene), {0.6F, 0.6F, 0.6F, 1}));
    std::swap(model.mesh.normals.edit()[0], model.mesh.normals.edit()[2]);
    EXPECT_TRUE(isColor(onlyColor(scene), dark));
}

} // namespace
} // namespace texplorer::two_side_test

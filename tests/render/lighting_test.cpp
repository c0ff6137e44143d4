// Lighting (OpenGL 2.1, section 2.14.1) and shading (2.14.7) of a square that faces the viewer, worked out by
// hand.

#include "tests/support/flat_scene.h"
#include "tests/support/render_fixture.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <gmock/gmock.h>

#include <algorithm>

namespace texplorer::lighting_test {
namespace {

using namespace test;

// Material 0.5, 0.25, 1 with alpha 0.8. Ambient: the model's 0.2 and, for red, the light's 0.2. Diffuse
// light: 0.6. The texture is 0.4 everywhere. The viewer is infinitely far in front.
struct Case {
    const char* name;
    glm::vec4 light; // direction towards the light
    float shininess;
    ColorControl control;
    glm::vec4 expected;
};

class Lighting : public RenderTest, public testing::WithParamInterface<Case> {
protected:
    static Scene litScene() {
        Scene scene = texturedScene();
        scene.passes[0].lighting = true;
        scene.passes[0].units[0].envMode = EnvMode::Modulate;
        scene.textures[0].internalFormat = InternalFormat::Rgb;
        scene.material.color = {0.5F, 0.25F, 1, 0.8F};
        scene.material.specular = {0.3F, 0.2F, 0.1F, 1};
        scene.material.shininess = GetParam().shininess;
        scene.light.position = GetParam().light;
        scene.light.ambient = {0.2F, 0, 0, 1};
        scene.light.diffuse = {0.6F, 0.6F, 0.6F, 1};
        scene.light.colorControl = GetParam().control;
        return scene;
    }
    void SetUp() override {
        RenderTest::SetUp();
        images.put("image", plainImage(1, 1, {102, 102, 102, 255}));
    }
};

TEST_P(Lighting, GivesTheColorOfTheEquation) {
    EXPECT_TRUE(isColor(onlyColor(litScene()), GetParam().expected));
    EXPECT_THAT(problems, testing::IsEmpty());
}

TEST_P(Lighting, TravelsWithTheCamera) {
    Scene scene = litScene();
    scene.view.azimuth = 90;
    scene.models[0].rotation = {0, 90, 0}; // turned to the camera again
    EXPECT_TRUE(isColor(onlyColor(scene), GetParam().expected));
}

TEST_P(Lighting, DoesNotDependOnTheSizeOfAModel) {
    Scene scene = litScene();
    scene.models[0].size = 3; // normals are three times too long unless GL_NORMALIZE is on
    EXPECT_TRUE(isColor(onlyColor(scene), GetParam().expected));
}

INSTANTIATE_TEST_SUITE_P(
    All, Lighting,
    testing::Values(
        // n.l = n.h = 1: primary (0.5 (0.2 + 0.2 + 0.6), 0.25 * 0.8, 0.8) = (0.5, 0.2, 0.8), specular (0.3,
        // 0.2, 0.1)
        Case{"FrontalSingle", {0, 0, 1, 0}, 8, ColorControl::Single, {0.32F, 0.16F, 0.36F, 0.8F}},
        Case{"FrontalSeparate", {0, 0, 1, 0}, 8, ColorControl::SeparateSpecular, {0.5F, 0.28F, 0.42F, 0.8F}},
        // 60 degrees off: n.l = 0.5, n.h = cos 30, squared 0.75:
        // primary (0.5 (0.4 + 0.3), 0.25 * 0.5, 0.5) = (0.35, 0.125, 0.5), specular (0.225, 0.15, 0.075)
        Case{"SlantedSingle", {0, 1.7320508F, 1, 0}, 2, ColorControl::Single, {0.23F, 0.11F, 0.23F, 0.8F}},
        Case{"SlantedSeparate",
             {0, 1.7320508F, 1, 0},
             2,
             ColorControl::SeparateSpecular,
             {0.365F, 0.2F, 0.275F, 0.8F}},
        // From behind: neither diffuse nor specular, (0.5 * 0.4, 0.25 * 0.2, 0.2) * 0.4
        Case{
            "BehindSeparate", {0, 0, -1, 0}, 2, ColorControl::SeparateSpecular, {0.08F, 0.02F, 0.08F, 0.8F}}),
    [](const auto& test) { return std::string(test.param.name); });

// A light at eye position (1, 1, 0) before a square at eye z = -1: at the corner (x, y) the cosine is 1 / |(1
// - x, 1 - y, 1)|, that is 1 at the upper right, 1 / sqrt(5) at its neighbours and 1 / 3 at the lower left.
float shadeAt(glm::vec3 corner) {
    return 1 / glm::length(glm::vec3(1 - corner.x, 1 - corner.y, 1));
}

class Shading : public RenderTest {
protected:
    static Scene shadedScene(ShadeModel model) {
        Scene scene = flatScene();
        scene.passes[0].lighting = true;
        scene.material.shadeModel = model;
        scene.light.position = {1, 1, 0, 1};
        scene.light.modelAmbient = {0, 0, 0, 1};
        scene.light.specular = {0, 0, 0, 1};
        return scene;
    }
};

// The pixel over a triangle's centroid, moved to that pixel's own centre.
struct Inside {
    int x;
    int y;
    glm::vec2 position; // -1 to 1
};
Inside pixelIn(const std::array<glm::vec3, 3>& corners, int extent) {
    const glm::vec3 centroid = (corners[0] + corners[1] + corners[2]) / 3.0F;
    const auto pixel = [extent](float at) {
        return static_cast<int>((at + 1) / 2 * static_cast<float>(extent));
    };
    const auto centre = [extent](int at) {
        return (static_cast<float>(at) + 0.5F) / static_cast<float>(extent) * 2 - 1;
    };
    const int x = pixel(centroid.x);
    const int y = pixel(centroid.y);
    return {x, y, {centre(x), centre(y)}};
}

std::vector<std::array<glm::vec3, 3>> quadTriangles() {
    const Mesh mesh = makeMesh({Shape::Quad});
    std::vector<std::array<glm::vec3, 3>> triangles;
    for (std::size_t i = 0; i + 2 < mesh.triangles.size(); i += 3)
        triangles.push_back({mesh.vertices[mesh.triangles[i]].position,
                             mesh.vertices[mesh.triangles[i + 1]].position,
                             mesh.vertices[mesh.triangles[i + 2]].position});
    return triangles;
}

TEST_F(Shading, FlatTakesTheLastVertexOfEachTriangle) {
    const Image image = picture(shadedScene(ShadeModel::Flat), 30);
    for (const auto& corners : quadTriangles()) {
        const Inside inside = pixelIn(corners, 30);
        const float shade = shadeAt(corners[2]);
        EXPECT_TRUE(isColor(colorAt(image, inside.x, inside.y), {shade, shade, shade, 1}));
    }
}

TEST_F(Shading, SmoothInterpolatesBetweenTheVertices) {
    const Image image = picture(shadedScene(ShadeModel::Smooth), 30);
    for (const auto& [a, b, c] : quadTriangles()) {
        const Inside inside = pixelIn({a, b, c}, 30);
        const auto area = [](glm::vec2 p, glm::vec2 q, glm::vec2 r) {
            return (q.x - p.x) * (r.y - p.y) - (r.x - p.x) * (q.y - p.y);
        };
        const glm::vec2 p = inside.position;
        const float shade =
            (area(p, b, c) * shadeAt(a) + area(a, p, c) * shadeAt(b) + area(a, b, p) * shadeAt(c)) /
            area(a, b, c);
        EXPECT_TRUE(isColor(colorAt(image, inside.x, inside.y), {shade, shade, shade, 1}));
    }
}

// A local viewer sits at the eye: at the square's middle, straight before it, both are the same; towards the
// rim the highlight of a light behind the viewer falls off.
TEST_F(Shading, ALocalViewerMovesTheHighlight) {
    Scene scene = shadedScene(ShadeModel::Smooth);
    scene.light.position = {0, 0, 1, 0};
    scene.light.diffuse = {0, 0, 0, 1};
    scene.light.specular = {1, 1, 1, 1};
    scene.material.specular = {1, 1, 1, 1};
    scene.material.shininess = 4;
    EXPECT_TRUE(isColor(onlyColor(scene), {1, 1, 1, 1}));
    scene.light.localViewer = true;
    // At a corner (1, 1, -1) the viewer is towards (-1, -1, 1) / sqrt(3); h = (-1, -1, 1 + sqrt 3) has
    // (n.h)^2 = (1 + sqrt 3)^2 / (2 + (1 + sqrt 3)^2) = 0.7887, to the fourth power in all 0.6220.
    const Image image = picture(scene, 256);
    EXPECT_TRUE(isColor(colorAt(image, 255, 255), {0.622F, 0.622F, 0.622F, 1}, 2));
    EXPECT_TRUE(isColor(colorAt(image, 0, 0), {0.622F, 0.622F, 0.622F, 1}, 2));
}

} // namespace
} // namespace texplorer::lighting_test

#include "app/ui/state/camera.h"
#include "app/ui/view/framing.h"
#include "texplorer/mesh/mesh.h"
#include "texplorer/scene/animation.h"
#include "texplorer/scene/drawn_models.h"
#include "texplorer/scene/model_mesh.h"
#include "texplorer/scene/params/json.h"

#include <glm/glm.hpp>
#include <gmock/gmock.h>

#include <algorithm>

namespace texplorer::ui::camera_test {
namespace {

/// The largest |x| or |y| of any vertex of the visible models, in a view of -1 to 1.
float reach(const Scene& scene, float aspect) {
    float largest = 0;
    const glm::mat4 camera = projectionMatrix(scene.view, aspect) * viewMatrix(scene.view);
    for (const Model& model : scene.models) {
        if (!model.visible)
            continue;
        for (const Vertex& vertex : meshOf(model).vertices) {
            const glm::vec4 clip = camera * modelMatrix(model, 0) * glm::vec4(vertex.position, 1);
            largest = std::max({largest, std::abs(clip.x / clip.w), std::abs(clip.y / clip.w)});
        }
    }
    return largest;
}

struct Case {
    const char* name;
    float aspect;
    Projection projection;
};

class Fit : public testing::TestWithParam<Case> {};

TEST_P(Fit, ShowsEveryModelWholeAndNoSmallerThanItMust) {
    Scene scene = defaultScene();
    scene.view.projection = GetParam().projection;
    fitDistance(scene, 0, GetParam().aspect);
    EXPECT_LE(reach(scene, GetParam().aspect), 1);
    EXPECT_GE(reach(scene, GetParam().aspect), 0.85F);
}

TEST_P(Fit, FramingAimsAtTheMiddle) {
    Scene scene = defaultScene();
    scene.view.projection = GetParam().projection;
    scene.view.target = {30, -20, 10};
    for (Model& model : scene.models)
        model.position.x += 5;
    frameModels(scene, 0, GetParam().aspect);
    // The cube reaches from -2.45 to -0.45, the sphere from 0.2 to 2.7, both moved by 5.
    EXPECT_NEAR(scene.view.target.x, 5 + (2.7F - 2.45F) / 2, 0.02F);
    EXPECT_NEAR(scene.view.target.y, 0, 0.02F);
    EXPECT_LE(reach(scene, GetParam().aspect), 1);
}

INSTANTIATE_TEST_SUITE_P(Shapes, Fit,
                         testing::Values(Case{"Wide", 2.5F, Projection::Perspective},
                                         Case{"Square", 1, Projection::Perspective},
                                         Case{"Narrow", 0.4F, Projection::Perspective},
                                         Case{"Orthographic", 1.3F, Projection::Orthographic},
                                         Case{"NarrowOrthographic", 0.5F, Projection::Orthographic}),
                         [](const auto& test) { return test.param.name; });

TEST(Show, MakesRoomAmongAsManyModelsAsThereMayBe) {
    Scene scene = defaultScene();
    scene.models.assign(maxModels, Model{.shape = Shape::Quad});
    scene.passes[0].models = {0, static_cast<int>(maxModels) - 1};
    showOnly(scene, Show::CubeAndSphere, 0, 1);
    EXPECT_EQ(scene.models.size(), maxModels);
    EXPECT_EQ(shownNow(scene), Show::CubeAndSphere);
}

/// Whatever the passes named before.
TEST(Show, WhatIsShownIsDrawn) {
    Scene scene = defaultScene();
    scene.passes[0].models = {0};
    showOnly(scene, Show::Sphere, 0, 1);
    EXPECT_TRUE(isDrawn(scene, 1));
    EXPECT_EQ(shownNow(scene), Show::Sphere);
}

TEST(Camera, AimsNoFurtherThanAFileMaySay) {
    Scene scene = defaultScene();
    scene.models.assign(1, Model{.shape = Shape::Mesh});
    scene.models[0].mesh.positions = {{0, 0, 0}, {1e5F, 0, 0}, {3e38F, 3e38F, 0}};
    frameModels(scene, 0, 1);
    EXPECT_TRUE(parseScene(writeScene(scene)));
}

TEST(Camera, GoesOverThePolesAndKeepsItsAnglesInRange) {
    View view;
    orbit(view, 0, 250); // 0.4 degrees a pixel
    EXPECT_FLOAT_EQ(view.elevation, 100);
    const glm::mat4 before = viewMatrix(view);
    EXPECT_LT(before[1].y, 0) << "upside down";
    orbit(view, 0, 225);
    EXPECT_FLOAT_EQ(view.elevation, -170);
    orbit(view, -5000, 5000);
    EXPECT_LE(std::abs(view.azimuth), 180);
    EXPECT_LE(std::abs(view.elevation), 180);
}

/// A drag to the right moves what is in front to the right, on either side of a pole.
TEST(Camera, FollowsTheMouseUpsideDown) {
    for (const float elevation : {20.0F, 160.0F}) {
        View view;
        view.elevation = elevation;
        const glm::vec4 nearest = glm::inverse(viewMatrix(view)) * glm::vec4(0, 0, 1 - view.distance, 1);
        orbit(view, 10, 0);
        EXPECT_GT((viewMatrix(view) * nearest).x, 0) << elevation;
    }
}

TEST(Camera, ZoomEndsSomewhere) {
    View view;
    zoom(view, 10000);
    EXPECT_GT(view.distance, 0);
    zoom(view, -10000);
    EXPECT_LE(view.distance, 1000);
}

TEST(Camera, PanKeepsThePointUnderTheMouse) {
    Scene scene = defaultScene();
    const float height = 600;
    const auto project = [&](glm::vec3 point) {
        const glm::vec4 clip = projectionMatrix(scene.view, 1) * viewMatrix(scene.view) * glm::vec4(point, 1);
        return glm::vec2(clip.x, -clip.y) / clip.w * height / 2.0F; // pixels from the middle, y downwards
    };
    const glm::vec3 target = scene.view.target;
    pan(scene.view, 40, -25, height);
    EXPECT_NEAR(project(target).x, 40, 0.5F);
    EXPECT_NEAR(project(target).y, -25, 0.5F);
}

TEST(Show, EveryChoiceShowsItsShapesAndIsRecognised) {
    for (const ShowRow& row : showRows) {
        Scene scene = defaultScene();
        showOnly(scene, row.show, 0, 1);
        EXPECT_EQ(shownNow(scene), row.show) << row.label;
        EXPECT_TRUE(row.show == Show::Floor || reach(scene, 1) <= 1) << row.label;
    }
}

TEST(Show, ComesBackToBothWithoutPilingUpModels) {
    Scene scene = defaultScene();
    for (int i = 0; i < 50; ++i) {
        for (const ShowRow& row : showRows)
            showOnly(scene, row.show, 0, 1);
    }
    EXPECT_EQ(scene.models.size(), 4U);
}

} // namespace
} // namespace texplorer::ui::camera_test

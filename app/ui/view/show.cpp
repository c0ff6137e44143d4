#include "app/ui/view/show.h"

#include "app/ui/model/camera.h"
#include "core/scene/drawn_models.h"

#include <algorithm>

namespace texplorer::ui {
namespace {

constexpr float beside = 1.45F; // how far the cube and the sphere of the default scene are from the middle

Model* firstOf(Scene& scene, Shape shape) {
    const auto found = std::ranges::find(scene.models, shape, &Model::shape);
    return found == scene.models.end() ? nullptr : &*found;
}

void reveal(Scene& scene, Shape shape) {
    if (!firstOf(scene, shape)) {
        if (scene.models.size() >= maxModels) {
            scene.models.pop_back();
            modelRemoved(scene, scene.models.size());
        }
        Model model;
        model.shape = shape;
        if (shape == Shape::Sphere)
            model.size = 1.25F;
        scene.models.push_back(model);
        drawEverywhere(scene, scene.models.size() - 1);
    }
    firstOf(scene, shape)->visible = true;
}

Shape shapeOf(Show show) {
    switch (show) {
    case Show::Sphere:
        return Shape::Sphere;
    case Show::Quad:
        return Shape::Quad;
    case Show::Floor:
        return Shape::Floor;
    default:
        return Shape::Cube;
    }
}

} // namespace

void showOnly(Scene& scene, Show show, double time, float aspect) {
    for (Model& model : scene.models)
        model.visible = false;
    reveal(scene, shapeOf(show));
    if (show == Show::CubeAndSphere) {
        reveal(scene, Shape::Sphere);
        Model& cube = *firstOf(scene, Shape::Cube);
        Model& sphere = *firstOf(scene, Shape::Sphere);
        if (cube.position == sphere.position) {
            cube.position.x -= beside;
            sphere.position.x += beside;
        }
    }
    View& view = scene.view;
    if (show == Show::Floor) { // from low above its near end, along it
        view.azimuth = 0;
        view.elevation = 12;
        view.target = {0, -0.6F, 0};
        view.distance = 4;
        return;
    }
    if (show == Show::Quad)
        view.azimuth = view.elevation = 0;
    else if (view.azimuth == 0) { // a solid that is seen from straight ahead looks flat
        view.azimuth = defaultScene().view.azimuth;
        view.elevation = defaultScene().view.elevation;
    }
    frameModels(scene, time, aspect);
}

std::optional<Show> shownNow(const Scene& scene) {
    std::vector<Shape> shapes;
    for (const Model& model : scene.models) {
        if (model.visible)
            shapes.push_back(model.shape);
    }
    std::ranges::sort(shapes);
    if (shapes == std::vector{Shape::Cube, Shape::Sphere})
        return Show::CubeAndSphere;
    for (const ShowRow& row : showRows) {
        if (row.show != Show::CubeAndSphere && shapes == std::vector{shapeOf(row.show)})
            return row.show;
    }
    return std::nullopt;
}

} // namespace texplorer::ui

#include "app/ui/view/show.h"

#include "app/ui/model/camera.h"
#include "core/scene/drawn_models.h"

#include <algorithm>
#include <span>
#include <vector>

namespace texplorer::ui {
namespace {

constexpr float beside = 1.45F; // how far the cube and the sphere of the default scene are from the middle

Model* firstOf(Scene& scene, Shape shape) {
    const auto found = std::ranges::find(scene.models, shape, &Model::shape);
    return found == scene.models.end() ? nullptr : &*found;
}

/// Takes models away, from the last one on, until there is room for one of each shape.
void makeRoom(Scene& scene, std::span<const Shape> shapes) {
    const auto isWanted = [&](const Model& model) {
        return std::ranges::find(shapes, model.shape) != shapes.end();
    };
    const auto missing = static_cast<std::size_t>(
        std::ranges::count_if(shapes, [&](Shape shape) { return firstOf(scene, shape) == nullptr; }));
    for (std::size_t i = scene.models.size(); i-- > 0 && scene.models.size() + missing > maxModels;) {
        if (isWanted(scene.models[i]))
            continue;
        scene.models.erase(scene.models.begin() + static_cast<std::ptrdiff_t>(i));
        modelRemoved(scene, i);
    }
}

void reveal(Scene& scene, Shape shape) {
    if (!firstOf(scene, shape)) {
        Model model;
        model.shape = shape;
        if (shape == Shape::Sphere)
            model.size = 1.25F;
        scene.models.push_back(model);
    }
    Model* model = firstOf(scene, shape);
    model->visible = true;
    if (const auto index = static_cast<std::size_t>(model - scene.models.data()); !isDrawn(scene, index))
        drawEverywhere(scene, index);
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
    const std::vector<Shape> shapes =
        show == Show::CubeAndSphere ? std::vector{Shape::Cube, Shape::Sphere} : std::vector{shapeOf(show)};
    makeRoom(scene, shapes);
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
    for (std::size_t i = 0; i < scene.models.size(); ++i) {
        if (isDrawn(scene, i))
            shapes.push_back(scene.models[i].shape);
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

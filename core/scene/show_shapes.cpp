#include "texplorer/scene/show_shapes.h"

#include "texplorer/scene/drawn_models.h"
#include "texplorer/scene/references.h"

#include <algorithm>

namespace texplorer {
namespace {

Model* firstShape(Scene& scene, Shape shape) {
    const auto found = std::ranges::find(scene.models, shape, &Model::shape);
    return found == scene.models.end() ? nullptr : &*found;
}

/// Takes models away, from the last one on, until there is room for one of each shape.
void makeShapeRoom(Scene& scene, std::span<const Shape> shapes) {
    const auto isWanted = [&](const Model& model) {
        return std::ranges::find(shapes, model.shape) != shapes.end();
    };
    const auto missing = static_cast<std::size_t>(
        std::ranges::count_if(shapes, [&](Shape shape) { return firstShape(scene, shape) == nullptr; }));
    for (std::size_t i = scene.models.size(); i-- > 0 && scene.models.size() + missing > maxModels;) {
        if (isWanted(scene.models[i]))
            continue;
        scene.models.erase(scene.models.begin() + static_cast<std::ptrdiff_t>(i));
        renumber(scene, "models", afterRemove(i));
    }
}

void revealShape(Scene& scene, Shape shape) {
    if (!firstShape(scene, shape)) {
        Model model;
        model.shape = shape;
        if (shape == Shape::Sphere)
            model.size = 1.25F;
        scene.models.push_back(model);
    }
    Model* model = firstShape(scene, shape);
    model->visible = true;
    if (const auto index = static_cast<std::size_t>(model - scene.models.data()); !isDrawn(scene, index))
        drawEverywhere(scene, index);
}

} // namespace

void showShape(Scene& scene, Shape shape) {
    makeShapeRoom(scene, std::span(&shape, 1));
    revealShape(scene, shape);
}

void showOnlyShapes(Scene& scene, std::span<const Shape> shapes) {
    for (Model& model : scene.models)
        model.visible = false;
    makeShapeRoom(scene, shapes);
    for (const Shape shape : shapes)
        revealShape(scene, shape);
}

void lookAlongFloor(View& view) {
    view.azimuth = 0;
    view.elevation = 12;
    view.target = {0, -0.6F, 0};
    view.distance = 4;
}

} // namespace texplorer

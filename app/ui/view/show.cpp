#include "app/ui/view/show.h"

#include "app/ui/model/camera.h"
#include "core/scene/drawn_models.h"
#include "core/scene/show_shapes.h"

#include <algorithm>
#include <vector>

namespace texplorer::ui {
namespace {

constexpr float beside =
    1.45F; // the distance of the cube and the sphere of the default scene from the middle

Model* firstOf(Scene& scene, Shape shape) {
    const auto found = std::ranges::find(scene.models, shape, &Model::shape);
    return found == scene.models.end() ? nullptr : &*found;
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
    showOnlyShapes(scene, show == Show::CubeAndSphere ? std::vector{Shape::Cube, Shape::Sphere}
                                                      : std::vector{shapeOf(show)});
    if (show == Show::CubeAndSphere) {
        Model& cube = *firstOf(scene, Shape::Cube);
        Model& sphere = *firstOf(scene, Shape::Sphere);
        if (cube.position == sphere.position) {
            cube.position.x -= beside;
            sphere.position.x += beside;
        }
    }
    View& view = scene.view;
    if (show == Show::Floor)
        return lookAlongFloor(view);
    if (show == Show::Quad)
        view.azimuth = view.elevation = 0;
    else if (view.azimuth == 0) { // a solid seen from straight ahead looks flat
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

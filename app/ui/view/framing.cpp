#include "app/ui/view/framing.h"

#include "app/ui/state/camera.h"
#include "texplorer/scene/drawn_models.h"
#include "texplorer/scene/show_shapes.h"

#include <algorithm>
#include <vector>

namespace texplorer::ui {
namespace {

constexpr float beside =
    1.45F; // the distance of the cube and the sphere of the default scene from the middle

Model& firstOf(Scene& scene, Shape shape) {
    return *std::ranges::find(scene.models, shape, &Model::shape);
}

std::vector<Shape> shapesOf(const ShowRow& row) {
    return row.show == Show::CubeAndSphere ? std::vector{Shape::Cube, Shape::Sphere} : std::vector{row.shape};
}

void rememberFit(const Session& session, const View& view, const Layout& layout) {
    act(session, [fit = Fit{view, aspectOf(layout)}](Session& s) { s.document.fit = fit; });
}

template<class Move>
void moveCamera(const Session& session, const Layout& layout, const char* name, const Move& move) {
    View fitted;
    submitDrag(session, name, [&](Scene& scene) {
        move(scene, session.look.playback.time, aspectOf(layout));
        fitted = scene.view;
    });
    rememberFit(session, fitted, layout);
}

} // namespace

void showOnly(Scene& scene, Show show, double time, float aspect) {
    showOnlyShapes(scene, shapesOf(*std::ranges::find(showRows, show, &ShowRow::show)));
    if (show == Show::CubeAndSphere) {
        Model& cube = firstOf(scene, Shape::Cube);
        Model& sphere = firstOf(scene, Shape::Sphere);
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
    const auto* row = std::ranges::find(showRows, shapes, shapesOf);
    return row == showRows.end() ? std::nullopt : std::optional(row->show);
}

void resetCamera(const Session& session, const Layout& layout) {
    moveCamera(session, layout, N_("Reset camera"), [](Scene& scene, double time, float aspect) {
        scene.view = defaultScene().view;
        fitDistance(scene, time, aspect);
    });
}

void frameAll(const Session& session, const Layout& layout) {
    moveCamera(session, layout, N_("Frame the models"), frameModels);
}

void show(const Session& session, const ShowRow& row, const Layout& layout) {
    Selection selection = session.look.selection;
    selection.vertex.reset();
    View fitted;
    Step step = stepThat(session, Sentence("Show {0}", row.label), [&](Scene& scene) {
        showOnly(scene, row.show, session.look.playback.time, aspectOf(layout));
        fitted = scene.view;
        const auto shown = std::ranges::find(scene.models, true, &Model::visible);
        selection.model = static_cast<int>(shown - scene.models.begin());
    });
    step.select = std::move(selection);
    submit(session, std::move(step));
    rememberFit(session, fitted, layout);
}

} // namespace texplorer::ui

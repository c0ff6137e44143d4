// What the panels add to a frame of the window: the whole frame against the renderer alone, at the size of
// the picture in the window; and a frame while coordinates are dragged.

#include "app/offscreen/osmesa_context.h"
#include "app/opengl/opengl_graphics.h"
#include "app/stage/stage.h"
#include "core/scene/tex_coords.h"

#include <GL/glew.h>
#include <benchmark/benchmark.h>

namespace texplorer::bench {
namespace {

constexpr view::Size window{1280, 800};

void windowFrame(benchmark::State& state) {
    const auto context = offscreen::OsmesaContext::create(window);
    const auto graphics = opengl::OpenGlGraphics::create();
    if (!graphics)
        return state.SkipWithError(describe(graphics.error()).c_str());
    stage::Stage stage(**graphics, 1);
    ui::ServicesAtOnce services;
    ui::Session session(services.lend());
    for (auto _ : state) {
        stage.draw(session, {window, window, 1}, 1.0F / 60);
        glFinish();
    }
}

/// The default window with a sphere of 128 x 64 alone, of which a vertex is dragged: each frame has other
/// coordinates, an edit in the history, a diagnosis and a texture space.
void windowDrag(benchmark::State& state) {
    const auto context = offscreen::OsmesaContext::create(window);
    const auto graphics = opengl::OpenGlGraphics::create();
    if (!graphics)
        return state.SkipWithError(describe(graphics.error()).c_str());
    stage::Stage stage(**graphics, 1);
    ui::ServicesAtOnce services;
    ui::Session session(services.lend());
    Scene& scene = session.document.scene;
    scene.models.erase(scene.models.begin());
    Model& sphere = scene.models.front();
    sphere.slices = 128;
    sphere.stacks = 64;
    constexpr std::size_t vertex = 4000;
    session.window.selection.vertex = vertex;
    float s = 0;
    for (auto _ : state) {
        s = s < 1 ? s + 0.001F : 0;
        setTexCoord(sphere, ui::selectedMesh(session), 0, vertex, {s, 0.5F, 0, 1});
        ui::recordEdit(session, "Move vertex", "models[0].texCoords0");
        stage.draw(session, {window, window, 1}, 1.0F / 60);
        glFinish();
    }
}

/// A display's time for a picture.
void windowLimit(benchmark::State& state) {
    for (auto _ : state)
        state.SetIterationTime(1.0 / 60);
}

BENCHMARK(windowFrame)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(windowDrag)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(windowLimit)->UseManualTime()->Unit(benchmark::kMillisecond);

} // namespace
} // namespace texplorer::bench

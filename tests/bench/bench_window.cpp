// What the panels add to a frame of the window: the whole frame against the renderer alone, at the size of
// the picture in the window.

#include "app/offscreen/osmesa_context.h"
#include "app/opengl/opengl_graphics.h"
#include "app/stage/stage.h"

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

BENCHMARK(windowFrame)->Unit(benchmark::kMillisecond)->UseRealTime();

} // namespace
} // namespace texplorer::bench

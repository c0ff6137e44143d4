// A frame of the default scene against a bare loop, BareScene. Both draw the same picture, or the benchmark
// fails.

#include "app/offscreen/context.h"
#include "app/render/fixed_renderer.h"
#include "app/render/shader_renderer.h"
#include "tests/bench/bare_scene.h"
#include "texplorer/texture/image_source.h"

#include <GL/glew.h>
#include <benchmark/benchmark.h>

namespace texplorer::bench {
namespace {

view::Size sizeOf(const benchmark::State& state) {
    return {static_cast<int>(state.range(0)), static_cast<int>(state.range(1))};
}

/// What the two benchmarks share: a context, and the renderer whose picture is the right one.
struct Stage {
    Result<offscreen::Context> context = offscreen::Context::create({1, 1});
    Result<render::FixedRenderer> renderer =
        render::loadCapabilities().and_then(&render::FixedRenderer::create);
    ImageSource images;
};

void drawFrames(benchmark::State& state, const ImageSource& images, auto& renderer) {
    if (!renderer)
        return state.SkipWithError(describe(renderer.error()).english().c_str());
    const Scene scene = defaultScene();
    const view::Size size = sizeOf(state);
    for (auto _ : state) {
        const auto drawn = renderer->draw(scene, images, 0, size);
        if (!drawn || !drawn->problems.empty())
            return state.SkipWithError("the default scene can't be drawn");
        glFinish();
    }
}

void frame(benchmark::State& state) {
    Stage stage;
    drawFrames(state, stage.images, stage.renderer);
}

/// The same with GLSL.
void frameShader(benchmark::State& state) {
    const Stage stage;
    Result<render::ShaderRenderer> renderer = render::loadCapabilities().and_then(
        [](const view::Capabilities& capabilities) { return render::ShaderRenderer::create(capabilities); });
    drawFrames(state, stage.images, renderer);
}

void frameBare(benchmark::State& state) {
    Stage stage;
    if (!stage.renderer)
        return state.SkipWithError(describe(stage.renderer.error()).english().c_str());
    const view::Size size = sizeOf(state);
    const BareScene bare(size.width, size.height);
    bare.draw();
    const auto drawn = stage.renderer->draw(defaultScene(), stage.images, 0, size);
    const auto expected = stage.renderer->read();
    if (!drawn || !expected || bare.read() != *expected)
        return state.SkipWithError("the bare loop draws another picture");
    for (auto _ : state) {
        bare.draw();
        glFinish();
    }
}

BENCHMARK(frame)->Args({640, 480})->Args({1280, 800})->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(frameShader)->Args({640, 480})->Args({1280, 800})->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(frameBare)->Args({640, 480})->Args({1280, 800})->Unit(benchmark::kMillisecond)->UseRealTime();

} // namespace
} // namespace texplorer::bench

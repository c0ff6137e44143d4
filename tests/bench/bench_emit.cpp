// A scene as a program: the start scene and one with the bricks, whose texels are packed; and once more, as
// the Commands tab writes it while one drags a value.

#include "texplorer/emit/program.h"

#include <benchmark/benchmark.h>

namespace texplorer {
namespace {

Scene sceneWith(Pattern pattern) {
    Scene scene = defaultScene();
    scene.textures[0].pattern = pattern;
    return scene;
}

void emitOnce(benchmark::State& state, Pattern pattern) {
    const Scene scene = sceneWith(pattern);
    const ImageSource images;
    for (auto _ : state) {
        emit::TextureCodes codes;
        const auto lines = emit::program(emit::Flavour::Fixed, scene, images, {}, codes);
        benchmark::DoNotOptimize(textOf(lines.value(), false));
    }
}

void emitAgain(benchmark::State& state, Pattern pattern) {
    Scene scene = sceneWith(pattern);
    const ImageSource images;
    emit::TextureCodes codes;
    for (auto _ : state) {
        scene.view.azimuth += 1;
        benchmark::DoNotOptimize(emit::program(emit::Flavour::Fixed, scene, images, {}, codes).value());
    }
}

BENCHMARK_CAPTURE(emitOnce, checker, Pattern::Checker)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(emitOnce, brick, Pattern::Brick)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(emitAgain, brick, Pattern::Brick)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace texplorer

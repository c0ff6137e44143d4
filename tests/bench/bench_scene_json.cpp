// A scene file of a moved cube and a sphere whose 561 coordinates were all edited, read and written, against
// nlohmann-json's own parse and dump of the same text into its document (which checks nothing of a scene).

#include "texplorer/scene/model_mesh.h"
#include "texplorer/scene/params/json.h"
#include "texplorer/scene/tex_coords.h"

#include <benchmark/benchmark.h>
#include <nlohmann/json.hpp>

namespace texplorer {
namespace {

Scene editedScene() {
    Scene scene = defaultScene();
    Model& sphere = scene.models[1];
    const Mesh mesh = meshOf(sphere);
    for (std::size_t vertex = 0; vertex < mesh.vertices.size(); ++vertex)
        setTexCoord(sphere, mesh, 0, vertex, mesh.vertices[vertex].texCoord * 1.37F);
    return scene;
}

void sceneParse(benchmark::State& state) {
    const std::string text = writeScene(editedScene());
    for (auto _ : state) {
        auto scene = parseScene(text);
        if (!scene)
            return state.SkipWithError("the scene can't be read back");
        benchmark::DoNotOptimize(scene);
    }
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(text.size()));
}

void sceneParseNlohmann(benchmark::State& state) {
    const std::string text = writeScene(editedScene());
    for (auto _ : state)
        benchmark::DoNotOptimize(nlohmann::json::parse(text));
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(text.size()));
}

void sceneWrite(benchmark::State& state) {
    const Scene scene = editedScene();
    for (auto _ : state)
        benchmark::DoNotOptimize(writeScene(scene));
}

void sceneWriteNlohmann(benchmark::State& state) {
    const nlohmann::json document = nlohmann::json::parse(writeScene(editedScene()));
    for (auto _ : state)
        benchmark::DoNotOptimize(document.dump(2));
}

BENCHMARK(sceneParse);
BENCHMARK(sceneParseNlohmann);
BENCHMARK(sceneWrite);
BENCHMARK(sceneWriteNlohmann);

} // namespace
} // namespace texplorer

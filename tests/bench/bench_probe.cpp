// Why a pixel has its colour, for a mouse that moves over the picture: the textures are ready, every probe is
// at another place.

#include "texplorer/reference/probe.h"

#include <benchmark/benchmark.h>

namespace texplorer::reference {
namespace {

void probePixel(benchmark::State& state) {
    ReferenceRenderer renderer;
    constexpr int width = 640;
    constexpr int height = 480;
    const DrawRequest request{defaultScene(), {}, 0, width, height};
    int place = 0;
    std::size_t fragments = 0;
    benchmark::DoNotOptimize(renderer.probe(request, {0, 0}));
    for (auto _ : state) {
        place = (place + 7919) % (width * height); // all over the picture
        const auto found = renderer.probe(request, {place % width, place / width});
        if (!found)
            return state.SkipWithError("the pixel can't be probed");
        fragments += found->fragments.size();
    }
    if (fragments == 0 && state.iterations() > 1000)
        state.SkipWithError("nothing was hit");
}

BENCHMARK(probePixel)->Unit(benchmark::kMicrosecond);

} // namespace
} // namespace texplorer::reference

// Whole processes, as a script that takes many screenshots pays for them.

#include "tests/bench/child.h"

#include <benchmark/benchmark.h>

#include <fcntl.h>

namespace texplorer::bench {
namespace {

void runRepeatedly(benchmark::State& state, const Words& words) {
    static const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    for (auto _ : state) {
        if (!hasSucceeded(startChild(words, {}, {.output = nowhere}))) {
            state.SkipWithError("the program failed");
            break;
        }
    }
}

#ifdef MINIMAL_OSMESA
void processMinimalOsmesa(benchmark::State& state) {
    runRepeatedly(state, {MINIMAL_OSMESA, "1280", "800"});
}
BENCHMARK(processMinimalOsmesa)->UseRealTime()->Unit(benchmark::kMillisecond);
#endif

void processTexshotShot(benchmark::State& state) {
    runRepeatedly(state, {TEXSHOT, "shot", "--size", "1280x800", "-o", "-"});
}
void processTexshotParams(benchmark::State& state) {
    runRepeatedly(state, {TEXSHOT, "params"});
}

BENCHMARK(processTexshotShot)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(processTexshotParams)->UseRealTime()->Unit(benchmark::kMillisecond);

} // namespace
} // namespace texplorer::bench

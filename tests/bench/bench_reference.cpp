// A frame of the reference renderer, of every scene and way of filtering in frame_scenes.h, against Mesa's
// drivers. Each driver runs in a process of its own, because it is chosen once for a whole process, and draws
// its frames between ours.

#include "tests/bench/child.h"
#include "tests/bench/comparisons.h"
#include "tests/bench/frame_scenes.h"
#include "texplorer/reference/draw.h"

#include <benchmark/benchmark.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <deque>
#include <fcntl.h>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <unistd.h>
#include <vector>

namespace texplorer::bench {
namespace {

/// A process that draws frames with one of Mesa's drivers.
class Driver {
public:
    explicit Driver(const char* gallium) {
        std::signal(SIGPIPE, SIG_IGN); // a driver that ends gives no answers
        int toChild[2];
        int fromChild[2];
        // Another driver's process that held an end of these would keep this one from ever reaching the end.
        if (pipe2(toChild, O_CLOEXEC) != 0 || pipe2(fromChild, O_CLOEXEC) != 0)
            return;
        child_ = startChild({DRIVER_FRAMES}, "GALLIUM_DRIVER=" + std::string(gallium),
                            {.input = toChild[0], .output = fromChild[1]});
        close(toChild[0]);
        close(fromChild[1]);
        ask_ = fdopen(toChild[1], "w");
        answers_ = fdopen(fromChild[0], "r");
        renderer_ = line();
    }
    Driver(const Driver&) = delete;
    Driver& operator=(const Driver&) = delete;
    Driver(Driver&&) = delete;
    Driver& operator=(Driver&&) = delete;
    ~Driver() {
        if (ask_)
            std::fclose(ask_); // its end
        if (answers_)
            std::fclose(answers_);
        if (child_ != 0)
            waitpid(child_, nullptr, 0);
    }

    /// GL_RENDERER; empty where there is no such driver.
    [[nodiscard]] const std::string& renderer() const { return renderer_; }

    /// The processor's time for one frame, of all threads together; 0 where it can't be drawn.
    double frameSeconds(const char* scene, const char* filter) {
        std::fprintf(ask_, "%s %s\n", scene, filter);
        std::fflush(ask_);
        return std::atof(line().c_str());
    }

private:
    std::string line() {
        char text[256] = "";
        if (!answers_ || !std::fgets(text, sizeof text, answers_))
            return "";
        std::string found(text);
        found.erase(found.find_last_not_of("\r\n") + 1);
        return found;
    }

    pid_t child_ = 0;
    FILE* ask_ = nullptr;
    FILE* answers_ = nullptr;
    std::string renderer_;
};

void driverFrame(benchmark::State& state, const char* gallium, const char* scene, const char* filter) {
    static std::map<std::string, std::unique_ptr<Driver>> drivers;
    std::unique_ptr<Driver>& driver = drivers[gallium];
    if (!driver)
        driver = std::make_unique<Driver>(gallium);
    // Mesa takes another driver without a word where it does not know this one.
    if (!driver->renderer().starts_with(gallium))
        return state.SkipWithError(("OpenGL is drawn by \"" + driver->renderer() + "\"").c_str());
    for (auto _ : state) {
        const double seconds = driver->frameSeconds(scene, filter);
        if (!(seconds > 0))
            return state.SkipWithError("the driver can't draw the scene");
        state.SetIterationTime(seconds);
    }
}

void frameReference(benchmark::State& state, const Scene& scene, unsigned threads) {
    reference::ReferenceRenderer renderer;
    const reference::DrawRequest request{scene, {}, 0, frameWidth, frameHeight};
    static_cast<void>(
        renderer.draw(request, {.threads = threads})); // a first time: textures, as the drivers have
    for (auto _ : state) {
        const auto drawn = renderer.draw(request, {.threads = threads});
        if (!drawn || !drawn->problems.empty())
            return state.SkipWithError("the scene can't be drawn");
        benchmark::DoNotOptimize(drawn->image.pixels.data());
    }
}

benchmark::internal::Benchmark* add(const std::string& name, const auto& work) {
    return benchmark::RegisterBenchmark(name.c_str(), work)->Unit(benchmark::kMillisecond);
}

std::string tailOf(const FrameScene& scene, const FrameFilter& filter) {
    return std::string("/") + scene.name + "/" + filter.name;
}

const bool registered = [] {
    for (const FrameScene& scene : frameScenes) {
        for (const FrameFilter& filter : filtersOf(scene)) {
            const std::string tail = tailOf(scene, filter);
            const Scene made = frameScene(scene, filter);
            add("frameReference" + tail, [made](benchmark::State& state) { frameReference(state, made, 1); });
            add("frameReference2" + tail, [made](benchmark::State& state) {
                frameReference(state, made, 2);
            })->MeasureProcessCPUTime();
            for (const char* gallium : {"softpipe", "llvmpipe"})
                add(gallium + tail, [gallium, &scene, &filter](benchmark::State& state) {
                    driverFrame(state, gallium, scene.name, filter.name);
                })->UseManualTime();
        }
        if (scene.oneFilter)
            continue;
        const Scene made = frameScene(scene, frameFilters.back());
        for (const unsigned threads : {1U, 2U})
            add("frameThreads/" + std::string(scene.name) + "/" + std::to_string(threads),
                [made, threads](benchmark::State& state) { frameReference(state, made, threads); })
                ->UseRealTime();
    }
    return true;
}();

} // namespace

std::vector<Comparison> frameComparisons() {
    static std::deque<std::string> words; // what the rows point to
    const auto keep = [](std::string word) { return words.emplace_back(std::move(word)).c_str(); };
    std::vector<Comparison> rows;
    for (const FrameScene& scene : frameScenes) {
        for (const FrameFilter& filter : filtersOf(scene)) {
            const std::string tail = tailOf(scene, filter);
            const char* name = keep("reference" + tail);
            rows.push_back({name, keep("frameReference" + tail), keep("softpipe" + tail + "/manual_time"),
                            "softpipe", Goal::FasterBy, scene.oneFilter ? 3.0 : 5.0});
            const std::string_view filterName = filter.name;
            const std::string_view sceneName = scene.name;
            if (sceneName != "lines" &&
                (filterName == "nearest" || filterName == "linear" || filterName == "anisotropic"))
                rows.push_back({name, keep("frameReference2" + tail + "/process_time"),
                                keep("llvmpipe" + tail + "/manual_time"), "llvmpipe, two threads each",
                                Goal::FasterBy, 1});
        }
        if (scene.oneFilter)
            continue;
        // By the clock: this means something on a machine with two cores to spare. Vertices and triangles
        // are set up on one thread, and the other one starts when that is done.
        const std::string threads = "frameThreads/" + std::string(scene.name);
        rows.push_back({keep("reference/" + std::string(scene.name) + ", two threads"),
                        keep(threads + "/2/real_time"), keep(threads + "/1/real_time"), "one", Goal::FasterBy,
                        1.5});
    }
    return rows;
}

} // namespace texplorer::bench

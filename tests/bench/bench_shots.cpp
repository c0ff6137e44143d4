// Many shots in one call against one process for each, and against the bare drawing: whole programs, with
// nothing in Mesa's cache and with everything. A cold cache is a folder of its own for each process. The same
// of a sheet of many pictures.

#include "tests/bench/caller.h"
#include "tests/bench/once.h"
#include "tests/bench/shot_states.h"
#include "texplorer/codec/png/png.h"
#include "texplorer/files/file_io.h"
#include "texplorer/image/convert.h"

#include <benchmark/benchmark.h>
#include <fmt/core.h>

#include <array>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

namespace texplorer::bench {
namespace {

std::string sizeText() {
    return fmt::format("{0}x{0}", statesExtent);
}

std::string assignment(std::string_view path, const EnumRow& row) {
    return fmt::format("{}={}", path, row.name);
}

constexpr std::string_view filterPath = "textures[0].minFilter";
constexpr std::string_view modePath = "passes[0].units[0].envMode";

std::optional<double> inOneCall(Caller& caller) {
    return caller.run({TEXSHOT, "shot", "--size", sizeText(), "--axis", fmt::format("{}=*", filterPath),
                       "--axis", fmt::format("{}=*", modePath), "-o",
                       (caller.pictures() / "{number}.png").string()});
}

constexpr int shotsOnce = 4; ///< of a process each, where nothing is measured

std::optional<double> oneByOne(Caller& caller) {
    std::optional<double> sum = 0;
    int number = 0;
    eachState([&](const EnumRow& filter, const EnumRow& mode) {
        if (onlyOnce && number == shotsOnce)
            return;
        const std::optional<double> seconds =
            caller.run({TEXSHOT, "shot", "--size", sizeText(), "--set", assignment(filterPath, filter),
                        "--set", assignment(modePath, mode), "-o",
                        (caller.pictures() / fmt::format("{:02}.png", ++number)).string()});
        sum = sum && seconds ? std::optional(*sum + *seconds) : std::nullopt;
    });
    return sum;
}

std::optional<double> bare(Caller& caller) {
    return caller.run({BARE_STATES});
}

/// Whether texshot and the bare program draw the same 36 pictures.
bool drawTheSame(Caller& caller) {
    if (!inOneCall(caller) || !caller.run({BARE_STATES, caller.pictures().string()}))
        return false;
    bool same = true;
    int number = 0;
    eachState([&](const EnumRow&, const EnumRow&) {
        ++number;
        const auto png = readFile(caller.pictures() / fmt::format("{:02}.png", number));
        const auto raw = readFile(caller.pictures() / fmt::format("{}.rgba", number));
        const auto picture = png ? decodePng(*png) : fail(png.error());
        Image expected = Image::uninitialised(PixelFormat::Rgba8, statesExtent, statesExtent);
        if (!raw || !picture || raw->size() != expected.pixels.size()) {
            same = false;
            return;
        }
        expected.pixels.assign(raw->begin(), raw->end());
        same = same && std::get<Image>(picture->surfaces.front()) == withoutAlpha(std::move(expected));
    });
    return same;
}

using Call = std::optional<double> (*)(Caller&);

/// Whose cache has all that Mesa keeps of what a call draws: what it hasn't written when a program ends comes
/// with a later call. nullptr: the program failed.
Caller* warmCaller(Call call) {
    static Caller caller(false);
    static std::set<Call> warmed;
    constexpr int calls = 4;
    for (int i = 0; i < calls && !warmed.contains(call); ++i) {
        if (!call(caller))
            return nullptr;
    }
    warmed.insert(call);
    return &caller;
}

/// `warming` draws the same as `call`.
void timed(benchmark::State& state, Call call, Call warming, bool cold, int pictures) {
    Caller own(cold);
    Caller* caller = cold ? &own : warmCaller(warming);
    if (caller == nullptr)
        return state.SkipWithError("the program failed");
    for (auto _ : state) {
        const std::optional<double> seconds = call(*caller);
        if (!seconds)
            return state.SkipWithError("the program failed");
        state.SetIterationTime(*seconds);
    }
    state.counters["shots/s"] = benchmark::Counter(pictures, benchmark::Counter::kIsIterationInvariantRate);
}

void shots(benchmark::State& state, Call call, Call warming, bool cold) {
    static const bool same = [] {
        Caller first(false);
        return drawTheSame(first);
    }();
    if (!same)
        return state.SkipWithError("the bare program draws other pictures");
    timed(state, call, warming, cold, 36);
}

constexpr std::string_view sheetSize = "128x128";
constexpr int sheetPictures = 64;

/// "view.azimuth=0,40,80,…": eight values.
std::string eight(std::string_view path, int step) {
    std::string axis = fmt::format("{}=0", path);
    for (int i = 1; i < 8; ++i)
        axis += fmt::format(",{}", i * step);
    return axis;
}

constexpr std::string_view azimuthPath = "view.azimuth";
constexpr std::string_view elevationPath = "view.elevation";
constexpr int azimuthStep = 40;
constexpr int elevationStep = 5;

std::optional<double> sheetInOneCall(Caller& caller) {
    return caller.run({TEXSHOT, "sweep", "--size", std::string(sheetSize), "--axis",
                       eight(azimuthPath, azimuthStep), "--axis", eight(elevationPath, elevationStep), "-o",
                       (caller.pictures() / "sheet.png").string()});
}

std::optional<double> sheetOneByOne(Caller& caller) {
    std::optional<double> sum = 0;
    for (int i = 0; i < (onlyOnce ? shotsOnce : sheetPictures) && sum; ++i) {
        const std::optional<double> seconds =
            caller.run({TEXSHOT, "shot", "--size", std::string(sheetSize), "--set",
                        fmt::format("{}={}", azimuthPath, i / 8 * azimuthStep), "--set",
                        fmt::format("{}={}", elevationPath, i % 8 * elevationStep), "-o",
                        (caller.pictures() / fmt::format("{:02}.png", i)).string()});
        sum = seconds ? std::optional(*sum + *seconds) : std::nullopt;
    }
    return sum;
}

void sheet(benchmark::State& state, Call call, Call warming, bool cold) {
    timed(state, call, warming, cold, sheetPictures);
}

struct Row {
    const char* name;
    void (*work)(benchmark::State&, Call, Call warming, bool cold);
    Call call;
    Call warming;
};

constexpr std::array rows{
    Row{"shots/inOneCall", shots, inOneCall, inOneCall},
    Row{"shots/oneByOne", shots, oneByOne, inOneCall},
    Row{"shots/bare", shots, bare, bare},
    Row{"sheet/inOneCall", sheet, sheetInOneCall, sheetInOneCall},
    Row{"sheet/oneByOne", sheet, sheetOneByOne, sheetInOneCall},
};

const bool shotsRegistered = [] {
    for (const Row& row : rows) {
        for (const bool cold : {true, false})
            benchmark::RegisterBenchmark(
                fmt::format("{}/{}", row.name, cold ? "cold" : "warm").c_str(),
                [&row, cold](benchmark::State& state) { row.work(state, row.call, row.warming, cold); })
                ->UseManualTime()
                ->Iterations(1)
                ->Unit(benchmark::kMillisecond);
    }
    return true;
}();

} // namespace
} // namespace texplorer::bench

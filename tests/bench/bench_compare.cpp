// Comparing two pictures of 1920 x 1080 pixels that differ everywhere, which is as slow as it gets. SSIM
// against scikit-image, the same formula by numpy and scipy; its process and its reading of the files don't
// count.

#include "texplorer/compare/comparison.h"
#include "texplorer/files/file_io.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <random>
#include <string>

namespace texplorer {
namespace {

constexpr int width = 1920;
constexpr int height = 1080;

struct Pair {
    Image expected = Image::uninitialised(PixelFormat::Rgb8, width, height);
    Image actual = expected;
};

const Pair& pictures() {
    static const Pair pair = [] {
        Pair made;
        std::minstd_rand dice(1);
        for (std::size_t i = 0; i < made.expected.pixels.size(); ++i) {
            const auto value = static_cast<unsigned>(dice() >> 9U);
            made.expected.pixels[i] = static_cast<std::byte>(value & 255U);
            made.actual.pixels[i] = static_cast<std::byte>((value + (dice() >> 9U & 7U)) & 255U);
        }
        return made;
    }();
    return pair;
}

void compareBy(benchmark::State& state, Metric metric) {
    const Pair& pair = pictures();
    ComparisonWork work;
    work.map = false;
    for (auto _ : state)
        benchmark::DoNotOptimize(
            comparePictures(pair.expected, pair.actual, criterionOf(metric), nullptr, work));
}

void pictureSsim(benchmark::State& state) {
    compareBy(state, Metric::Ssim);
}
BENCHMARK(pictureSsim)->UseRealTime()->Unit(benchmark::kMillisecond);

void pictureFlip(benchmark::State& state) {
    compareBy(state, Metric::Flip);
}
BENCHMARK(pictureFlip)->UseRealTime()->Unit(benchmark::kMillisecond);

/// Seconds and score, or what went wrong.
Result<std::pair<double, double>> askScikit(const std::string& command) {
    FILE* output = popen(command.c_str(), "r");
    double seconds = 0;
    double score = 0;
    const int found = output != nullptr ? std::fscanf(output, "%lf %lf", &seconds, &score) : 0;
    if (output != nullptr)
        pclose(output);
    if (found != 2)
        return fail(ErrorCode::Unreadable, "expected python3-skimage's seconds and score");
    return std::pair(seconds, score);
}

void pictureSsimScikit(benchmark::State& state) {
    const std::filesystem::path folder = std::filesystem::temp_directory_path();
    const std::string expected = (folder / "texplorer-bench-expected.rgb").string();
    const std::string actual = (folder / "texplorer-bench-actual.rgb").string();
    const bool written = writeFileAtomically(expected, pictures().expected.pixels) &&
                         writeFileAtomically(actual, pictures().actual.pixels);
    const Result<Comparison> ours =
        comparePictures(pictures().expected, pictures().actual, criterionOf(Metric::Ssim));
    const std::string command = std::string(TEXPLORER_PYTHON " " TEXPLORER_SSIM_PEER " '") + expected +
                                "' '" + actual + "' " + std::to_string(width) + " " + std::to_string(height);
    for (auto _ : state) {
        const auto theirs = askScikit(command);
        // They leave out what is within 5 pixels of an edge.
        if (!written || !theirs || !ours || std::abs(theirs->second - ours->score) > 1e-3) {
            state.SkipWithError("scikit-image is not there or says something else");
            break;
        }
        state.SetIterationTime(theirs->first);
    }
    std::filesystem::remove(expected);
    std::filesystem::remove(actual);
}
BENCHMARK(pictureSsimScikit)->UseManualTime()->Unit(benchmark::kMillisecond);

} // namespace
} // namespace texplorer

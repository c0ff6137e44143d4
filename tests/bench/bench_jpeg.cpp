// Decoding JPEG files from memory, against libjpeg-turbo called by hand and against stb_image.

#include "texplorer/codec/jpeg/jpeg.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>
#include <stb/stb_image.h>
#include <turbojpeg.h>

namespace texplorer {
namespace {

constexpr int width = 1024;

int rowsFor(std::int64_t megabytes) {
    return static_cast<int>(megabytes * 1024 * 1024 / (3 * width));
}

/// Slopes, waves and a little noise, as a camera writes them: 4:2:0, quality 90.
Bytes makeFile(std::int64_t megabytes) {
    const int height = rowsFor(megabytes);
    Image picture = Image::uninitialised(PixelFormat::Rgb8, width, height);
    std::mt19937 random(3);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const double wave = 60 * std::sin(0.013 * x) * std::cos(0.017 * y);
            const std::array values{120 + wave, 100 - wave / 2 + y % 64, 140.0 + x % 64};
            for (std::size_t i = 0; i < values.size(); ++i)
                picture.at(x, y)[i] = static_cast<std::byte>(
                    std::clamp(values[i] + static_cast<double>(random() % 5), 0.0, 255.0));
        }
    tjhandle handle = tjInitCompress();
    unsigned char* file = nullptr;
    unsigned long size = 0;
    if (tjCompress2(handle, reinterpret_cast<const unsigned char*>(picture.pixels.data()), width, 0, height,
                    TJPF_RGB, &file, &size, TJSAMP_420, 90, 0) != 0)
        std::abort();
    const auto* bytes = reinterpret_cast<const std::byte*>(file);
    Bytes copy(bytes, bytes + size);
    tjFree(file);
    tjDestroy(handle);
    return copy;
}

void count(benchmark::State& state, const Bytes& file) {
    state.counters["fileBytes"] = static_cast<double>(file.size());
    state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations()) * width * 3 *
                            rowsFor(state.range(0)));
}

void jpegDecode(benchmark::State& state) {
    const Bytes file = makeFile(state.range(0));
    for (auto _ : state) {
        const Result<TextureImage> texture = decodeJpeg(file);
        benchmark::DoNotOptimize(texture->surfaces.data());
        benchmark::ClobberMemory();
    }
    count(state, file);
}

void jpegTurbo(benchmark::State& state) {
    const Bytes file = makeFile(state.range(0));
    const auto* bytes = reinterpret_cast<const unsigned char*>(file.data());
    for (auto _ : state) {
        tjhandle handle = tjInitDecompress();
        int columns = 0;
        int rows = 0;
        int subsampling = 0;
        int colors = 0;
        tjDecompressHeader3(handle, bytes, file.size(), &columns, &rows, &subsampling, &colors);
        Image image = Image::uninitialised(PixelFormat::Rgb8, columns, rows);
        if (tjDecompress2(handle, bytes, file.size(), reinterpret_cast<unsigned char*>(image.pixels.data()),
                          columns, 0, rows, TJPF_RGB, 0) != 0)
            state.SkipWithError(tjGetErrorStr2(handle));
        tjDestroy(handle);
        benchmark::DoNotOptimize(image.pixels.data());
        benchmark::ClobberMemory();
    }
    count(state, file);
}

void jpegStb(benchmark::State& state) {
    const Bytes file = makeFile(state.range(0));
    for (auto _ : state) {
        int x = 0;
        int y = 0;
        int components = 0;
        stbi_uc* pixels = stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(file.data()),
                                                static_cast<int>(file.size()), &x, &y, &components, 3);
        if (pixels == nullptr)
            state.SkipWithError(stbi_failure_reason());
        benchmark::ClobberMemory();
        stbi_image_free(pixels);
    }
    count(state, file);
}

BENCHMARK(jpegDecode)->Arg(1)->Arg(16)->Unit(benchmark::kMillisecond);
BENCHMARK(jpegTurbo)->Arg(1)->Arg(16)->Unit(benchmark::kMillisecond);
BENCHMARK(jpegStb)->Arg(1)->Arg(16)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace texplorer

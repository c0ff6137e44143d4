// Decoding 24-bit BMP files from memory, against stb_image and against copying the decoded pixels.

#include "texplorer/codec/bmp/bmp.h"

#include <benchmark/benchmark.h>

#include <cstring>
#include <stb/stb_image.h>

namespace texplorer {
namespace {

constexpr int width = 1024;

int rowsFor(std::int64_t megabytes) {
    return static_cast<int>(megabytes * 1024 * 1024 / (3 * width));
}

Bytes makeFile(std::int64_t megabytes) {
    const int height = rowsFor(megabytes);
    Bytes file(54 + static_cast<std::size_t>(width) * 3 * static_cast<std::size_t>(height));
    for (std::size_t i = 0; i < file.size(); ++i)
        file[i] = i < 54 ? std::byte{0} : static_cast<std::byte>(i * 7 + i / 4099);
    const auto put = [&](std::size_t offset, std::uint32_t value) {
        for (std::size_t i = 0; i < 4; ++i)
            file[offset + i] = static_cast<std::byte>(value >> (8 * i));
    };
    put(0, 'B' | 'M' << 8);
    put(10, 54);
    put(14, 40);
    put(18, width);
    put(22, static_cast<std::uint32_t>(height));
    put(26, 1 | 24 << 16);
    return file;
}

void countBytes(benchmark::State& state) {
    state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations()) * width * 3 *
                            rowsFor(state.range(0)));
}

void bmpDecode(benchmark::State& state) {
    const Bytes file = makeFile(state.range(0));
    for (auto _ : state) {
        const Result<TextureImage> image = decodeBmp(file);
        benchmark::DoNotOptimize(image->surfaces.data());
        benchmark::ClobberMemory();
    }
    countBytes(state);
}

void bmpStb(benchmark::State& state) {
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
    countBytes(state);
}

void bmpMemcpy(benchmark::State& state) {
    const Bytes file = makeFile(state.range(0));
    for (auto _ : state) {
        Image image = Image::uninitialised(PixelFormat::Rgb8, width, rowsFor(state.range(0)));
        std::memcpy(image.pixels.data(), file.data() + 54, image.pixels.size());
        benchmark::DoNotOptimize(image.pixels.data());
        benchmark::ClobberMemory();
    }
    countBytes(state);
}

BENCHMARK(bmpDecode)->Arg(1)->Arg(4)->Arg(16)->Unit(benchmark::kMicrosecond);
BENCHMARK(bmpStb)->Arg(1)->Arg(4)->Arg(16)->Unit(benchmark::kMicrosecond);
BENCHMARK(bmpMemcpy)->Arg(1)->Arg(4)->Arg(16)->Unit(benchmark::kMicrosecond);

} // namespace
} // namespace texplorer

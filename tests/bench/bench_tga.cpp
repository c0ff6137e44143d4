// Decoding TGA files from memory against stb_image: raw, and run-length coded pictures of two kinds. A
// drawing has runs of 1 to 60 pixels, a third of them single ones; a photograph is all raw packets.

#include "texplorer/codec/tga/tga.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <random>
#include <stb/stb_image.h>

namespace texplorer {
namespace {

constexpr int width = 1024;

enum class Kind { Drawing, Photograph };

Image makePicture(Kind kind, PixelFormat format, std::int64_t megabytes) {
    const int bytes = bytesPerPixel(format);
    Image image =
        Image::uninitialised(format, width, static_cast<int>(megabytes * 1024 * 1024 / (bytes * width)));
    std::mt19937 random(7); // NOLINT: the same picture each time
    std::array<std::byte, 4> color{};
    std::size_t run = 0;
    for (auto at = image.pixels.begin(); at != image.pixels.end(); at += bytes) {
        if (run == 0) {
            std::ranges::generate(color, [&] { return static_cast<std::byte>(random()); });
            run = kind == Kind::Photograph || random() % 3 == 0 ? 1 : 1 + random() % 60;
        }
        --run;
        std::copy_n(color.begin(), bytes, at);
    }
    return image;
}

Bytes makeFile(Kind kind, PixelFormat format, std::int64_t megabytes, bool runLengthCoded) {
    return *encodeTga(textureOf(makePicture(kind, format, megabytes), "picture"),
                      {.runLengthCoded = runLengthCoded});
}

void decodeOurs(benchmark::State& state, const Bytes& file) {
    for (auto _ : state) {
        const Result<TextureImage> image = decodeTga(file);
        benchmark::DoNotOptimize(image->surfaces.data());
        benchmark::ClobberMemory();
    }
    state.SetBytesProcessed(state.iterations() * state.range(0) * 1024 * 1024);
}

// Bottom row first, as ours.
void decodeStb(benchmark::State& state, const Bytes& file) {
    stbi_set_flip_vertically_on_load(0);
    for (auto _ : state) {
        int x = 0;
        int y = 0;
        int components = 0;
        stbi_uc* pixels = stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(file.data()),
                                                static_cast<int>(file.size()), &x, &y, &components, 0);
        if (pixels == nullptr)
            return state.SkipWithError(stbi_failure_reason());
        benchmark::ClobberMemory();
        stbi_image_free(pixels);
    }
    state.SetBytesProcessed(state.iterations() * state.range(0) * 1024 * 1024);
}

template<void (*Decode)(benchmark::State&, const Bytes&), Kind Of, PixelFormat Format, bool RunLengthCoded>
void decode(benchmark::State& state) {
    Decode(state, makeFile(Of, Format, state.range(0), RunLengthCoded));
}

void tgaRaw24(benchmark::State& state) {
    decode<decodeOurs, Kind::Photograph, PixelFormat::Rgb8, false>(state);
}
void tgaRaw24Stb(benchmark::State& state) {
    decode<decodeStb, Kind::Photograph, PixelFormat::Rgb8, false>(state);
}
void tgaRaw32(benchmark::State& state) {
    decode<decodeOurs, Kind::Photograph, PixelFormat::Rgba8, false>(state);
}
void tgaRaw32Stb(benchmark::State& state) {
    decode<decodeStb, Kind::Photograph, PixelFormat::Rgba8, false>(state);
}
void tgaRle24(benchmark::State& state) {
    decode<decodeOurs, Kind::Drawing, PixelFormat::Rgb8, true>(state);
}
void tgaRle24Stb(benchmark::State& state) {
    decode<decodeStb, Kind::Drawing, PixelFormat::Rgb8, true>(state);
}
void tgaRle32(benchmark::State& state) {
    decode<decodeOurs, Kind::Drawing, PixelFormat::Rgba8, true>(state);
}
void tgaRle32Stb(benchmark::State& state) {
    decode<decodeStb, Kind::Drawing, PixelFormat::Rgba8, true>(state);
}
void tgaRlePhoto(benchmark::State& state) {
    decode<decodeOurs, Kind::Photograph, PixelFormat::Rgb8, true>(state);
}
void tgaRlePhotoStb(benchmark::State& state) {
    decode<decodeStb, Kind::Photograph, PixelFormat::Rgb8, true>(state);
}

BENCHMARK(tgaRaw24)->Arg(1)->Arg(4)->Arg(16)->Unit(benchmark::kMicrosecond);
BENCHMARK(tgaRaw24Stb)->Arg(1)->Arg(4)->Arg(16)->Unit(benchmark::kMicrosecond);
BENCHMARK(tgaRaw32)->Arg(4)->Unit(benchmark::kMicrosecond);
BENCHMARK(tgaRaw32Stb)->Arg(4)->Unit(benchmark::kMicrosecond);
BENCHMARK(tgaRle24)->Arg(1)->Arg(4)->Arg(16)->Unit(benchmark::kMicrosecond);
BENCHMARK(tgaRle24Stb)->Arg(1)->Arg(4)->Arg(16)->Unit(benchmark::kMicrosecond);
BENCHMARK(tgaRle32)->Arg(4)->Unit(benchmark::kMicrosecond);
BENCHMARK(tgaRle32Stb)->Arg(4)->Unit(benchmark::kMicrosecond);
BENCHMARK(tgaRlePhoto)->Arg(4)->Unit(benchmark::kMicrosecond);
BENCHMARK(tgaRlePhotoStb)->Arg(4)->Unit(benchmark::kMicrosecond);

} // namespace
} // namespace texplorer

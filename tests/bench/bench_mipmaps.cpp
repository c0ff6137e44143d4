// The whole mip chain of a 2048 x 2048 RGBA image, against stb_image_resize's box filter.

#include "texplorer/image/mipmaps.h"

#include <benchmark/benchmark.h>

#include <stb/stb_image_resize.h>

namespace texplorer {
namespace {

constexpr int extent = 2048;

Image makeBase() {
    Image image = Image::uninitialised(PixelFormat::Rgba8, extent, extent);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        image.pixels[i] = static_cast<std::byte>(i * 7 + i / 4099);
    return image;
}

void mipChain(benchmark::State& state) {
    Image base = makeBase();
    for (auto _ : state) {
        MipChain chain = buildMipChain(std::move(base));
        benchmark::DoNotOptimize(chain.back().pixels.data());
        benchmark::ClobberMemory();
        base = std::move(chain.front());
    }
}

void mipChainStb(benchmark::State& state) {
    const Image base = makeBase();
    for (auto _ : state) {
        MipChain levels(12);
        const Image* from = &base;
        for (int level = 1; level < 12; ++level) {
            Image to = Image::uninitialised(PixelFormat::Rgba8, extent >> level, extent >> level);
            stbir_resize_uint8_generic(reinterpret_cast<const unsigned char*>(from->pixels.data()),
                                       from->width, from->height, 0,
                                       reinterpret_cast<unsigned char*>(to.pixels.data()), to.width,
                                       to.height, 0, 4, STBIR_ALPHA_CHANNEL_NONE, 0, STBIR_EDGE_CLAMP,
                                       STBIR_FILTER_BOX, STBIR_COLORSPACE_LINEAR, nullptr);
            levels[static_cast<std::size_t>(level)] = std::move(to);
            from = &levels[static_cast<std::size_t>(level)];
        }
        benchmark::DoNotOptimize(levels.back().pixels.data());
        benchmark::ClobberMemory();
    }
}

void mipChainOdd(benchmark::State& state) {
    Image base = Image::uninitialised(PixelFormat::Rgba8, extent - 1, extent - 1);
    std::fill(base.pixels.begin(), base.pixels.end(), std::byte{100});
    for (auto _ : state) {
        MipChain chain = buildMipChain(std::move(base));
        benchmark::DoNotOptimize(chain.back().pixels.data());
        benchmark::ClobberMemory();
        base = std::move(chain.front());
    }
}

BENCHMARK(mipChain)->Unit(benchmark::kMillisecond);
BENCHMARK(mipChainStb)->Unit(benchmark::kMillisecond);
BENCHMARK(mipChainOdd)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace texplorer

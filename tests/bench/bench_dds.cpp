// Reading DDS files from memory, against copying the same bytes: nothing needs to be computed.

#include "texplorer/codec/dds/dds.h"

#include <benchmark/benchmark.h>

#include <cstring>

namespace texplorer {
namespace {

/// DXT5 of 2048 texels a row with its mip chain, or Rgba8 without one.
TextureImage makeTexture(bool compressed, std::int64_t megabytes) {
    const int rows = static_cast<int>(megabytes * 1024 * 1024 / 2048 / (compressed ? 1 : 4));
    TextureImage texture;
    texture.topFirst = true;
    texture.alpha = AlphaMeaning::Straight;
    const auto fill = [](Bytes& bytes) {
        for (std::size_t i = 0; i < bytes.size(); ++i)
            bytes[i] = static_cast<std::byte>(i * 7 + i / 4099);
    };
    texture.levels = compressed ? 11 : 1;
    for (int level = 0; level < texture.levels; ++level) {
        if (compressed) {
            auto image =
                BlockImage::uninitialised(BlockFormat::Dxt5, 2048 >> level, std::max(1, rows >> level));
            fill(image.blocks);
            texture.surfaces.emplace_back(std::move(image));
        } else {
            Image image = Image::uninitialised(PixelFormat::Rgba8, 2048, rows);
            fill(image.pixels);
            texture.surfaces.emplace_back(std::move(image));
        }
    }
    return texture;
}

void count(benchmark::State& state, const Bytes& file) {
    state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations()) *
                            static_cast<std::int64_t>(file.size()));
}

void ddsDecode(benchmark::State& state, bool compressed) {
    const Bytes file = encodeDds(makeTexture(compressed, state.range(0))).value();
    for (auto _ : state) {
        const Result<TextureImage> texture = decodeDds(file);
        benchmark::DoNotOptimize(texture->surfaces.data());
        benchmark::ClobberMemory();
    }
    count(state, file);
}

void ddsMemcpy(benchmark::State& state, bool compressed) {
    const TextureImage texture = makeTexture(compressed, state.range(0));
    const Bytes file = encodeDds(texture).value();
    for (auto _ : state) {
        std::vector<Bytes> levels(texture.surfaces.size());
        const std::byte* from = file.data() + 128;
        for (std::size_t i = 0; i < levels.size(); ++i) {
            levels[i].resize(byteCount(texture.surfaces[i]));
            std::memcpy(levels[i].data(), from, levels[i].size());
            from += levels[i].size();
        }
        benchmark::DoNotOptimize(levels.data());
        benchmark::ClobberMemory();
    }
    count(state, file);
}

BENCHMARK_CAPTURE(ddsDecode, dxt5, true)->Arg(1)->Arg(16)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(ddsMemcpy, dxt5, true)->Arg(1)->Arg(16)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(ddsDecode, rgba, false)->Arg(16)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(ddsMemcpy, rgba, false)->Arg(16)->Unit(benchmark::kMicrosecond);

} // namespace
} // namespace texplorer

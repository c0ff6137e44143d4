// S3TC on one thread: decoding against libsquish, flipping against copying the same bytes, encoding against
// stb_dxt and libsquish.

#include "texplorer/s3tc/decode.h"
#include "texplorer/s3tc/encode.h"
#include "texplorer/s3tc/flip.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>
#include <squish.h>
#include <stb/stb_dxt.h>

namespace texplorer {
namespace {

constexpr int width = 2048;

/// `megabytes` of random blocks.
BlockImage makeBlocks(BlockFormat format, std::int64_t megabytes) {
    const auto blocks = static_cast<std::size_t>(megabytes) * 1024 * 1024 / bytesPerBlock(format);
    BlockImage image = BlockImage::uninitialised(format, width, static_cast<int>(blocks / (width / 4) * 4));
    std::mt19937 random(1);
    for (std::byte& each : image.blocks)
        each = static_cast<std::byte>(random());
    return image;
}

/// Slopes, waves and noise, as hard to compress as a photo.
Image makePicture(int extent) {
    Image image = Image::uninitialised(PixelFormat::Rgba8, extent, extent);
    std::mt19937 random(5);
    for (int y = 0; y < extent; ++y)
        for (int x = 0; x < extent; ++x) {
            const double wave = 60 * std::sin(0.13 * x) * std::cos(0.07 * y);
            const auto channel = [&](double value) {
                return static_cast<std::byte>(
                    std::clamp(value + static_cast<double>(random() % 13), 0.0, 255.0));
            };
            const auto pixel = image.at(x, y);
            pixel[0] = channel(120 + wave);
            pixel[1] = channel(90 - wave / 2 + y % 64);
            pixel[2] = channel(140 + x % 64);
            pixel[3] = std::byte{255};
        }
    return image;
}

double psnr(const Image& a, const Image& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const double difference = std::to_integer<int>(a.pixels[i]) - std::to_integer<int>(b.pixels[i]);
        sum += difference * difference;
    }
    const double count = static_cast<double>(a.pixels.size()) * 3 / 4; // alpha is 255 in both
    return 10 * std::log10(255.0 * 255.0 * count / sum);
}

void countTexels(benchmark::State& state, const BlockImage& image) {
    state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()) * image.width * image.height);
}

void s3tcDecode(benchmark::State& state, BlockFormat format) {
    const BlockImage image = makeBlocks(format, state.range(0));
    Image pixels = decodeBlocks(image);
    for (auto _ : state) {
        decodeBlocks(image, pixels.pixels);
        benchmark::ClobberMemory();
    }
    countTexels(state, image);
}

void s3tcDecodeSquish(benchmark::State& state, BlockFormat format, int flag) {
    const BlockImage image = makeBlocks(format, state.range(0));
    Image pixels = decodeBlocks(image);
    for (auto _ : state) {
        squish::DecompressImage(reinterpret_cast<squish::u8*>(pixels.pixels.data()), image.width,
                                image.height, image.blocks.data(), flag);
        benchmark::ClobberMemory();
    }
    countTexels(state, image);
}

void s3tcFlip(benchmark::State& state, BlockFormat format) {
    BlockImage image = makeBlocks(format, state.range(0));
    for (auto _ : state) {
        benchmark::DoNotOptimize(flipVertically(image).has_value());
        benchmark::ClobberMemory();
    }
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(image.blocks.size()));
}

void s3tcMemcpy(benchmark::State& state, BlockFormat format) {
    const BlockImage image = makeBlocks(format, state.range(0));
    Bytes copy = image.blocks;
    for (auto _ : state) {
        std::memcpy(copy.data(), image.blocks.data(), copy.size());
        benchmark::DoNotOptimize(copy.data());
        benchmark::ClobberMemory();
    }
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(copy.size()));
}

int encodeExtent(EncodeQuality quality) {
    return quality == EncodeQuality::Best ? 128 : 1024;
}

void bc1Encode(benchmark::State& state, EncodeQuality quality) {
    const Image picture = makePicture(encodeExtent(quality));
    BlockImage compressed;
    for (auto _ : state)
        compressed = encodeBlocks(picture, BlockFormat::Dxt1, quality, {}, {}, 1).value();
    countTexels(state, compressed);
    state.counters["dB"] = psnr(picture, decodeBlocks(compressed));
}

void bc1EncodeStb(benchmark::State& state) {
    const Image picture = makePicture(encodeExtent(EncodeQuality::Fast));
    BlockImage compressed;
    for (auto _ : state) {
        compressed = BlockImage::uninitialised(BlockFormat::Dxt1, picture.width, picture.height);
        auto* block = reinterpret_cast<unsigned char*>(compressed.blocks.data());
        for (int top = 0; top < picture.height; top += 4)
            for (int left = 0; left < picture.width; left += 4, block += 8) {
                unsigned char texels[64];
                for (int y = 0; y < 4; ++y)
                    std::memcpy(texels + 16 * y, picture.at(left, top + y).data(), 16);
                stb_compress_dxt_block(block, texels, 0, STB_DXT_NORMAL);
            }
    }
    countTexels(state, compressed);
    state.counters["dB"] = psnr(picture, decodeBlocks(compressed));
}

// For its dB: its time is that of all cores, ours that of one.
void bc1EncodeSquish(benchmark::State& state) {
    const Image picture = makePicture(encodeExtent(EncodeQuality::Best));
    BlockImage compressed = BlockImage::uninitialised(BlockFormat::Dxt1, picture.width, picture.height);
    for (auto _ : state)
        squish::CompressImage(reinterpret_cast<const squish::u8*>(picture.pixels.data()), picture.width,
                              picture.height, compressed.blocks.data(),
                              squish::kDxt1 | squish::kColourClusterFit);
    countTexels(state, compressed);
    state.counters["dB"] = psnr(picture, decodeBlocks(compressed));
}

BENCHMARK_CAPTURE(s3tcDecode, dxt1, BlockFormat::Dxt1Alpha)->Arg(1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(s3tcDecode, dxt3, BlockFormat::Dxt3)->Arg(2)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(s3tcDecode, dxt5, BlockFormat::Dxt5)->Arg(2)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(s3tcDecodeSquish, dxt1, BlockFormat::Dxt1Alpha, squish::kDxt1)
    ->Arg(1)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(s3tcDecodeSquish, dxt3, BlockFormat::Dxt3, squish::kDxt3)
    ->Arg(2)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(s3tcDecodeSquish, dxt5, BlockFormat::Dxt5, squish::kDxt5)
    ->Arg(2)
    ->Unit(benchmark::kMillisecond);

BENCHMARK_CAPTURE(s3tcFlip, dxt1, BlockFormat::Dxt1)->Arg(1)->Arg(16)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(s3tcFlip, dxt3, BlockFormat::Dxt3)->Arg(1)->Arg(16)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(s3tcFlip, dxt5, BlockFormat::Dxt5)->Arg(1)->Arg(16)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(s3tcMemcpy, dxt1, BlockFormat::Dxt1)->Arg(1)->Arg(16)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(s3tcMemcpy, dxt3, BlockFormat::Dxt3)->Arg(1)->Arg(16)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(s3tcMemcpy, dxt5, BlockFormat::Dxt5)->Arg(1)->Arg(16)->Unit(benchmark::kMicrosecond);

BENCHMARK_CAPTURE(bc1Encode, fast, EncodeQuality::Fast)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(bc1Encode, best, EncodeQuality::Best)->Unit(benchmark::kMillisecond);
BENCHMARK(bc1EncodeStb)->Unit(benchmark::kMillisecond);
BENCHMARK(bc1EncodeSquish)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace texplorer

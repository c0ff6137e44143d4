#include "texplorer/s3tc/encode.h"

#include "texplorer/base/parallel.h"
#include "texplorer/s3tc/block_encoders.h"

#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <cstring>
#include <thread>

namespace texplorer {
namespace {

using Texels = std::array<std::uint8_t, 64>;

/// A pixel as Rgba8, as OpenGL converts it to RGBA.
void expand(PixelFormat format, const std::byte* pixel, std::uint8_t* rgba) {
    const auto component = [pixel](std::size_t i) { return std::to_integer<std::uint8_t>(pixel[i]); };
    switch (format) {
    case PixelFormat::Alpha8:
        std::fill_n(rgba, 3, std::uint8_t{0});
        rgba[3] = component(0);
        return;
    case PixelFormat::Luminance8:
    case PixelFormat::LuminanceAlpha8:
        std::fill_n(rgba, 3, component(0));
        rgba[3] = format == PixelFormat::Luminance8 ? 255 : component(1);
        return;
    case PixelFormat::Rgb8:
        std::memcpy(rgba, pixel, 3);
        rgba[3] = 255;
        return;
    case PixelFormat::Rgba8:
    case PixelFormat::Depth32:
    case PixelFormat::RgbaFloat:
        std::memcpy(rgba, pixel, 4);
        return;
    }
}

/// 4 x 4 texels from (left, top) on; beyond the edge the last column and row repeat.
void gather(const Image& image, int left, int top, Texels& texels) {
    const bool inside = left + 4 <= image.width && top + 4 <= image.height;
    if (inside && image.format == PixelFormat::Rgba8) {
        const std::byte* from = image.pixels.data() + image.offset(left, top, 0);
        for (std::size_t row = 0; row < 4; ++row)
            std::memcpy(texels.data() + 16 * row, from + row * image.rowBytes(), 16);
        return;
    }
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 4; ++x)
            expand(image.format,
                   image.at(std::min(left + x, image.width - 1), std::min(top + y, image.height - 1)).data(),
                   texels.data() + static_cast<std::size_t>(16 * y + 4 * x));
}

Result<void> check(const Image& image, BlockFormat format) {
    const std::string extents = fmt::format("{} × {} × {}", image.width, image.height, image.depth);
    if (image.width <= 0 || image.height <= 0 || image.depth <= 0)
        return fail(
            ErrorCode::OutOfRange,
            Sentence("a picture to compress needs at least 1 × 1 × 1 pixels, this one has {0}", extents));
    const std::size_t needed =
        image.rowBytes() * static_cast<std::size_t>(image.height) * static_cast<std::size_t>(image.depth);
    if (image.pixels.size() != needed)
        return fail(ErrorCode::Malformed, Sentence("a picture of {0} pixels needs {1} bytes, but has {2}",
                                                   extents, needed, image.pixels.size()));
    if (image.depth > 1)
        return fail(ErrorCode::Unsupported,
                    Sentence("volumes are not compressed: expected a depth of 1, found {0}", image.depth));
    if (!isEncoded(format))
        return fail(
            ErrorCode::Unsupported,
            Sentence("pictures are not compressed to {0}: their values are not signed", rowOf(format).name));
    return {};
}

} // namespace

bool isEncoded(BlockFormat format) {
    return blockEncoder(format, EncodeQuality::Fast) != nullptr;
}

Result<BlockImage> encodeBlocks(const Image& image, BlockFormat format, EncodeQuality quality,
                                const Progress& progress, std::stop_token stop, unsigned threads) {
    if (Result<void> sound = check(image, format); !sound)
        return fail(sound.error());
    BlockImage compressed = BlockImage::uninitialised(format, image.width, image.height);
    const BlockEncoder encode = blockEncoder(format, quality);
    const std::size_t rows = compressed.blockRows();
    const std::thread::id caller = std::this_thread::get_id();
    std::atomic<std::size_t> done = 0;
    const auto encodeRow = [&](std::size_t row) {
        if (stop.stop_requested())
            return;
        std::byte* block = compressed.blocks.data() + row * compressed.blockRowBytes();
        Texels texels;
        for (int left = 0; left < image.width; left += 4, block += bytesPerBlock(format)) {
            gather(image, left, static_cast<int>(4 * row), texels);
            encode(texels.data(), block);
        }
        const std::size_t doneNow = ++done;
        if (progress && doneNow < rows && std::this_thread::get_id() == caller)
            progress(static_cast<float>(doneNow) / static_cast<float>(rows));
    };
    // A thread costs as much as a few hundred blocks.
    constexpr std::size_t bytesPerThread = 8192;
    const auto worthwhile = static_cast<unsigned>(compressed.blocks.size() / bytesPerThread + 1);
    parallelFor(rows, std::min(threads == 0 ? processorThreads() : threads, worthwhile), encodeRow);
    if (done < rows)
        return fail(ErrorCode::Cancelled,
                    Sentence("compressing was stopped after {0} of {1} rows of blocks", done.load(), rows));
    if (progress)
        progress(1);
    return compressed;
}

Result<std::vector<BlockImage>> encodeLevels(const MipChain& chain, BlockFormat format, EncodeQuality quality,
                                             const Progress& progress, const std::stop_token& stop) {
    const auto texelsOf = [](const Image& level) {
        return static_cast<float>(level.width) * static_cast<float>(level.height);
    };
    float all = 0;
    for (const Image& level : chain)
        all += texelsOf(level);

    std::vector<BlockImage> levels;
    float before = 0;
    for (const Image& level : chain) {
        const auto share = [&](float done) {
            progress(std::min(1.0F, (before + done * texelsOf(level)) / all));
        };
        Result<BlockImage> blocks =
            encodeBlocks(level, format, quality, progress ? Progress(share) : Progress(), stop);
        if (!blocks)
            return fail(blocks.error());
        levels.push_back(*std::move(blocks));
        before += texelsOf(level);
    }
    return levels;
}

} // namespace texplorer

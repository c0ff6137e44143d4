// Animations against their parts: what it costs to draw the pictures into files that aren't packed, and what
// the library's own way costs to encode those, one after the other.

#include "tests/bench/caller.h"
#include "texplorer/animation/opaque_frame.h"
#include "texplorer/codec/bmp/bmp.h"
#include "texplorer/files/file_io.h"

#include <benchmark/benchmark.h>
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <gif_lib.h>
#include <variant>
#include <webp/encode.h>
#include <webp/mux.h>

namespace texplorer::bench {
namespace {

using animation::OpaqueFrame;

constexpr int pictureCount = 60;
constexpr int extent = 512;

std::optional<double> animate(Caller& caller, const std::string& out) {
    return caller.run({TEXSHOT, "animate", "--example", "earth", "--set", "view.azimuth=0..60", "--seconds",
                       "2.4", "--fps", "25", "--size", "512x512", "-o", (caller.pictures() / out).string()});
}

std::optional<std::vector<OpaqueFrame>> drawnFrames(const Caller& caller) {
    std::vector<OpaqueFrame> frames;
    for (int i = 1; i <= pictureCount; ++i) {
        const auto file = readFile(caller.pictures() / fmt::format("{:02}.bmp", i));
        const auto picture = file ? decodeBmp(*file) : fail(file.error());
        if (!picture)
            return std::nullopt;
        frames.push_back(animation::opaqueFrame(std::get<Image>(picture->surfaces.front())));
    }
    return frames;
}

/// As app/animation has it, and no other thread.
bool encodeWebp(const std::vector<OpaqueFrame>& frames) {
    WebPAnimEncoderOptions options;
    WebPConfig config;
    if (WebPAnimEncoderOptionsInit(&options) == 0 || WebPConfigInit(&config) == 0)
        return false;
    config.lossless = 1;
    config.method = 1;
    config.quality = 0;
    WebPAnimEncoder* encoder = WebPAnimEncoderNew(extent, extent, &options);
    bool good = encoder != nullptr;
    int time = 0;
    for (const OpaqueFrame& frame : frames) {
        WebPPicture picture;
        good = good && WebPPictureInit(&picture) != 0;
        picture.use_argb = 1;
        picture.width = picture.height = extent;
        good = good && WebPPictureAlloc(&picture) != 0;
        if (!good)
            break;
        for (int y = 0; y < extent; ++y)
            std::copy_n(frame.row(y), extent,
                        picture.argb + static_cast<std::ptrdiff_t>(y) * picture.argb_stride);
        good = WebPAnimEncoderAdd(encoder, &picture, time, &config) != 0;
        WebPPictureFree(&picture);
        time += 40;
    }
    WebPData data;
    WebPDataInit(&data);
    good = good && WebPAnimEncoderAdd(encoder, nullptr, time, nullptr) != 0 &&
           WebPAnimEncoderAssemble(encoder, &data) != 0 && data.size > 0;
    WebPDataClear(&data);
    WebPAnimEncoderDelete(encoder);
    return good;
}

int countBytes(GifFileType* gif, const GifByteType* /*bytes*/, int count) {
    *static_cast<std::size_t*>(gif->UserData) += static_cast<std::size_t>(count);
    return count;
}

/// With a palette of giflib's for each picture, as its gif2rgb does it backwards.
bool encodeGif(const std::vector<OpaqueFrame>& frames) {
    std::size_t bytes = 0;
    int error = 0;
    GifFileType* gif = EGifOpen(&bytes, countBytes, &error);
    if (gif == nullptr)
        return false;
    bool good = EGifPutScreenDesc(gif, extent, extent, 8, 0, nullptr) == GIF_OK;
    constexpr std::size_t area = std::size_t{extent} * extent;
    std::array<std::vector<GifByteType>, 3> colors;
    std::vector<GifByteType> indices(area);
    for (const OpaqueFrame& frame : frames) {
        for (std::size_t c = 0; c < 3; ++c) {
            colors[c].resize(area);
            std::ranges::transform(frame.pixels, colors[c].begin(), [c](std::uint32_t pixel) {
                return static_cast<GifByteType>(pixel >> (16U - 8U * c));
            });
        }
        int count = 256;
        ColorMapObject* map = GifMakeMapObject(count, nullptr);
        good = good && map != nullptr &&
               GifQuantizeBuffer(extent, extent, &count, colors[0].data(), colors[1].data(), colors[2].data(),
                                 indices.data(), map->Colors) == GIF_OK &&
               EGifPutImageDesc(gif, 0, 0, extent, extent, false, map) == GIF_OK;
        for (std::size_t y = 0; good && y < extent; ++y)
            good = EGifPutLine(gif, indices.data() + y * extent, extent) == GIF_OK;
        GifFreeMapObject(map);
    }
    return EGifCloseFile(gif, nullptr) == GIF_OK && good && bytes > 0;
}

/// The driver's cache is warm: what it costs to compile shaders isn't what is compared.
Caller* warm() {
    static Caller caller(false);
    static const bool drawn = animate(caller, "%02d.bmp") && animate(caller, "%02d.bmp");
    return drawn ? &caller : nullptr;
}

void animated(benchmark::State& state, const char* out) {
    Caller* caller = warm();
    for (auto _ : state) {
        const std::optional<double> seconds = caller ? animate(*caller, out) : std::nullopt;
        if (!seconds)
            return state.SkipWithError("the program failed");
        state.SetIterationTime(*seconds);
    }
}

void animatedPeer(benchmark::State& state, bool (*encode)(const std::vector<OpaqueFrame>&)) {
    Caller* caller = warm();
    for (auto _ : state) {
        const std::optional<double> drawing = caller ? animate(*caller, "%02d.bmp") : std::nullopt;
        const std::optional<std::vector<OpaqueFrame>> frames = drawing ? drawnFrames(*caller) : std::nullopt;
        if (!frames)
            return state.SkipWithError("the program failed");
        const auto begin = std::chrono::steady_clock::now();
        if (!encode(*frames))
            return state.SkipWithError("the library failed");
        state.SetIterationTime(
            *drawing + std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    }
}

void declare(benchmark::internal::Benchmark* declared) {
    declared->UseManualTime()->Iterations(1)->Unit(benchmark::kMillisecond);
}

BENCHMARK_CAPTURE(animated, webp, "x.webp")->Apply(declare);
BENCHMARK_CAPTURE(animated, gif, "x.gif")->Apply(declare);
BENCHMARK_CAPTURE(animatedPeer, webp, encodeWebp)->Apply(declare);
BENCHMARK_CAPTURE(animatedPeer, gif, encodeGif)->Apply(declare);

} // namespace
} // namespace texplorer::bench

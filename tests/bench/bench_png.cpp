// Writing a rendered picture of 1280 x 720 pixels as PNG and reading it again, against libpng in a bare loop
// with its own defaults.

#include "texplorer/codec/png/png.h"
#include "texplorer/image/patterns/pattern.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <csetjmp>
#include <cstdlib>
#include <png.h>
#include <span>

namespace texplorer {
namespace {

constexpr int width = 1280;
constexpr int height = 720;

// What a rendered picture has: flat background, panels with fine text, textured and shaded surfaces.
Image screenshot() {
    const Image patterns[] = {drawPattern(Pattern::UvTemplate), drawPattern(Pattern::Brick),
                              drawPattern(Pattern::Checker), drawPattern(Pattern::Tree)};
    Image image = Image::uninitialised(PixelFormat::Rgb8, width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const std::span<std::byte> to = image.at(x, y);
            const int cell = x / 320 + 4 * (y / 240);
            const Image& from = patterns[static_cast<std::size_t>(cell % 4)];
            const ByteView texel = from.at(x % from.width, y % from.height);
            const int shade = cell >= 8 ? 160 + y % 240 / 4 : 256;
            for (std::size_t i = 0; i < 3; ++i)
                to[i] = cell % 2 == 0 ? std::byte{46}
                                      : static_cast<std::byte>(std::to_integer<int>(texel[i]) * shade / 256);
        }
    return image;
}

void append(png_structp png, png_bytep data, png_size_t count) {
    Bytes& out = *static_cast<Bytes*>(png_get_io_ptr(png));
    const std::span bytes = std::as_bytes(std::span(data, count));
    out.insert(out.end(), bytes.begin(), bytes.end());
}

Bytes writeWithLibpng(const Image& image) {
    Bytes out;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    if (setjmp(png_jmpbuf(png)) != 0)
        std::abort();
    png_set_write_fn(png, &out, append, nullptr);
    png_set_IHDR(png, info, width, height, 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_write_info(png, info);
    for (int y = height; y-- > 0;)
        png_write_row(png, reinterpret_cast<png_const_bytep>(image.at(0, y).data()));
    png_write_end(png, nullptr);
    png_destroy_write_struct(&png, &info);
    return out;
}

void readWithLibpng(const Bytes& file, Bytes& pixels) {
    png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    if (setjmp(png_jmpbuf(png)) != 0)
        std::abort();
    const std::byte* at = file.data();
    png_set_read_fn(png, &at, [](png_structp from, png_bytep to, png_size_t count) {
        const std::byte*& place = *static_cast<const std::byte**>(png_get_io_ptr(from));
        std::copy_n(place, count, reinterpret_cast<std::byte*>(to));
        place += count;
    });
    png_read_info(png, info);
    const std::size_t row = png_get_rowbytes(png, info);
    pixels.resize(row * height);
    for (std::size_t y = 0; y < height; ++y)
        png_read_row(png, reinterpret_cast<png_bytep>(pixels.data() + y * row), nullptr);
    png_read_end(png, nullptr);
    png_destroy_read_struct(&png, &info, nullptr);
}

void report(benchmark::State& state, std::size_t fileBytes) {
    state.counters["fileBytes"] = static_cast<double>(fileBytes);
    state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations()) * width * height * 3);
}

void pngWrite(benchmark::State& state) {
    const Image image = screenshot();
    std::size_t size = 0;
    for (auto _ : state) {
        const Result<Bytes> file = encodePng(image);
        size = file->size();
    }
    if (4 * size > 5 * writeWithLibpng(image).size())
        state.SkipWithError("more than 1.25 times the size of libpng's file");
    report(state, size);
}

void pngWriteLibpng(benchmark::State& state) {
    const Image image = screenshot();
    std::size_t size = 0;
    for (auto _ : state)
        size = writeWithLibpng(image).size();
    report(state, size);
}

void pngRead(benchmark::State& state) {
    const Bytes file = writeWithLibpng(screenshot());
    for (auto _ : state) {
        const Result<TextureImage> texture = decodePng(file);
        benchmark::DoNotOptimize(texture->surfaces.data());
    }
    report(state, file.size());
}

void pngReadLibpng(benchmark::State& state) {
    const Bytes file = writeWithLibpng(screenshot());
    for (auto _ : state) {
        Bytes pixels;
        readWithLibpng(file, pixels);
        benchmark::DoNotOptimize(pixels.data());
    }
    report(state, file.size());
}

BENCHMARK(pngWrite)->Unit(benchmark::kMillisecond);
BENCHMARK(pngWriteLibpng)->Unit(benchmark::kMillisecond);
BENCHMARK(pngRead)->Unit(benchmark::kMillisecond);
BENCHMARK(pngReadLibpng)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace texplorer

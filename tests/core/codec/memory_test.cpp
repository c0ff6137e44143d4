// What decoding holds at once: the decoded pixels and the file, and hardly anything else.

#include "tests/support/watched_heap.h"
#include "texplorer/codec/registry.h"
#include "texplorer/image/mipmaps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <turbojpeg.h>

namespace texplorer::memory_test {
namespace {

constexpr int extent = 1024;

Image picture(PixelFormat format) {
    Image image = Image::uninitialised(format, extent, extent);
    std::mt19937 random(1); // NOLINT: the same picture each time
    std::byte value{};
    for (std::byte& each : image.pixels) {
        if (random() % 3 == 0) // runs as well as noise
            value = static_cast<std::byte>(random());
        each = value;
    }
    return image;
}

TextureImage onePicture(PixelFormat format) {
    return textureOf(picture(format), "");
}

TextureImage compressedLevels() {
    TextureImage texture;
    texture.topFirst = true;
    texture.alpha = AlphaMeaning::Straight;
    texture.levels = mipLevelCount(extent, extent, 1);
    for (int level = 0; level < texture.levels; ++level) {
        BlockImage image = BlockImage::uninitialised(BlockFormat::Dxt5, extent >> level, extent >> level);
        std::ranges::fill(image.blocks, static_cast<std::byte>(level));
        texture.surfaces.emplace_back(std::move(image));
    }
    return texture;
}

template<PixelFormat format>
Bytes written(const char* extension, const WriteOptions& options) {
    return codecForExtension(extension)->encode(onePicture(format), options).value();
}

Bytes jpegFile() {
    const Image image = picture(PixelFormat::Rgb8);
    tjhandle handle = tjInitCompress();
    unsigned char* file = nullptr;
    unsigned long size = 0;
    EXPECT_EQ(tjCompress2(handle, reinterpret_cast<const unsigned char*>(image.pixels.data()), extent, 0,
                          extent, TJPF_RGB, &file, &size, TJSAMP_420, 85, 0),
              0);
    const auto* bytes = reinterpret_cast<const std::byte*>(file);
    Bytes copy(bytes, bytes + size);
    tjFree(file);
    tjDestroy(handle);
    return copy;
}

struct Case {
    const char* name;
    Bytes (*makeFile)();
};

class DecodingHolds : public testing::TestWithParam<Case> {};

TEST_P(DecodingHolds, TheFileAndThePixelsAndATenthMoreAtMost) {
    const Bytes file = GetParam().makeFile();
    std::size_t peak = 0;
    Result<TextureImage> texture = [&] {
        const test::HeapWatch heap;
        Result<TextureImage> decoded = decodeTexture(file);
        peak = heap.peak();
        return decoded;
    }();
    ASSERT_TRUE(texture) << texture.error().message;
    std::size_t pixels = 0;
    for (const Surface& surface : texture->surfaces)
        pixels += byteCount(surface);
    EXPECT_GE(peak, pixels);
    EXPECT_LE(10 * (file.size() + peak), 11 * (file.size() + pixels))
        << "a file of " << file.size() << " bytes and " << pixels << " of pixels, held: " << peak;
}

INSTANTIATE_TEST_SUITE_P(
    Files, DecodingHolds,
    testing::Values(
        Case{"Bmp24", [] { return written<PixelFormat::Rgb8>(".bmp", {}); }},
        Case{"Bmp32", [] { return written<PixelFormat::Rgba8>(".bmp", {}); }},
        Case{"Tga24", [] { return written<PixelFormat::Rgb8>(".tga", {}); }},
        Case{"TgaRle24", [] { return written<PixelFormat::Rgb8>(".tga", {.runLengthCoded = true}); }},
        Case{"TgaRle32", [] { return written<PixelFormat::Rgba8>(".tga", {.runLengthCoded = true}); }},
        Case{"Png24", [] { return written<PixelFormat::Rgb8>(".png", {}); }},
        Case{"Png32", [] { return written<PixelFormat::Rgba8>(".png", {}); }}, Case{"Jpeg", jpegFile},
        Case{"DdsRgba", [] { return written<PixelFormat::Rgba8>(".dds", {}); }},
        Case{"DdsDxt5", [] { return codecForExtension(".dds")->encode(compressedLevels(), {}).value(); }}),
    [](const auto& test) { return std::string(test.param.name); });

} // namespace
} // namespace texplorer::memory_test

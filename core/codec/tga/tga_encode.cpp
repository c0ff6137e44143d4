#include "texplorer/base/sentence.h"
#include "texplorer/codec/common/swizzle.h"
#include "texplorer/codec/tga/tga.h"
#include "texplorer/codec/tga/tga_format.h"
#include "texplorer/image/convert.h"
#include "texplorer/s3tc/surface_pixels.h"

#include <algorithm>
#include <cstring>
#include <new>
#include <optional>

namespace texplorer {

namespace {

using namespace tga;

constexpr std::size_t maxPacket = 128;

bool hasAlpha(PixelFormat format) {
    return format == PixelFormat::Rgba8 || format == PixelFormat::LuminanceAlpha8;
}

bool isGray(PixelFormat format) {
    return format != PixelFormat::Rgb8 && format != PixelFormat::Rgba8;
}

// Of LuminanceAlpha8 and of pixels that mean nothing by their alpha.
Image withoutMeaninglessAlpha(const Image& image) {
    if (image.format == PixelFormat::Rgba8)
        return withoutAlpha(image);
    Image gray = Image::uninitialised(PixelFormat::Luminance8, image.width, image.height, image.depth);
    for (std::size_t i = 0; i < gray.pixels.size(); ++i)
        gray.pixels[i] = image.pixels[2 * i];
    return gray;
}

void putNumber(std::byte* to, std::size_t value, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i)
        to[i] = static_cast<std::byte>(value >> (8 * i) & 255);
}

void writeHeader(const Image& image, bool topFirst, bool runLengthCoded, std::byte* to) {
    std::fill_n(to, Header::headerBytes, std::byte{0});
    putNumber(to + 2, (isGray(image.format) ? 3U : 2U) + (runLengthCoded ? 8U : 0U), 1);
    putNumber(to + 12, static_cast<std::size_t>(image.width), 2);
    putNumber(to + 14, static_cast<std::size_t>(image.height), 2);
    putNumber(to + 16, static_cast<std::size_t>(8 * bytesPerPixel(image.format)), 1);
    putNumber(to + 17, (hasAlpha(image.format) ? 8U : 0U) | (topFirst ? 0x20U : 0U), 1);
}

// What the extension area's attributes type says of alpha.
std::size_t attributesType(const Image& image, AlphaMeaning alpha) {
    if (!hasAlpha(image.format))
        return 0;
    return alpha == AlphaMeaning::Premultiplied ? 4 : alpha == AlphaMeaning::Unknown ? 2 : 3;
}

// No date and no author: the same picture gives the same bytes.
void writeTail(std::size_t pixelEnd, std::size_t attributes, std::byte* to) {
    std::fill_n(to, extensionBytes + Footer::bytes, std::byte{0});
    putNumber(to, extensionBytes, 2);
    constexpr std::string_view software = N_("Texplorer");
    constexpr std::size_t softwareIdOffset = 426;
    std::memcpy(to + softwareIdOffset, software.data(), software.size());
    putNumber(to + attributesTypeOffset, attributes, 1);
    to += extensionBytes;
    putNumber(to, pixelEnd, 4);
    std::memcpy(to + 8, Footer::signature.data(), Footer::signature.size());
}

// Pixels as the file has them: blue first.
void convertRow(PixelFormat format, const std::byte* from, std::byte* to, std::size_t count) {
    if (format == PixelFormat::Rgb8)
        swapRedBlue(from, to, count);
    else if (format == PixelFormat::Rgba8)
        swapRedBlueAlpha(from, to, count);
    else
        std::memcpy(to, from, count * static_cast<std::size_t>(bytesPerPixel(format)));
}

template<std::size_t Size>
std::size_t runAt(const std::byte* pixels, std::size_t count) {
    std::size_t run = 1;
    while (run < count && std::memcmp(pixels, pixels + run * Size, Size) == 0)
        ++run;
    return run;
}

// A run shorter than this costs as much within a raw packet as on its own.
template<std::size_t Size>
constexpr std::size_t worthwhileRun = Size == 1 ? 3 : 2;

template<std::size_t Size>
std::byte* packRow(const std::byte* row, std::size_t width, std::byte* to) {
    std::size_t rawBegin = 0;
    const auto flushRaw = [&](std::size_t end) {
        while (rawBegin < end) {
            const std::size_t count = std::min(maxPacket, end - rawBegin);
            *to++ = static_cast<std::byte>(count - 1);
            std::memcpy(to, row + rawBegin * Size, count * Size);
            to += count * Size;
            rawBegin += count;
        }
    };
    for (std::size_t x = 0; x < width;) {
        const std::size_t run = runAt<Size>(row + x * Size, std::min(maxPacket, width - x));
        if (run >= worthwhileRun<Size>) {
            flushRaw(x);
            *to++ = static_cast<std::byte>(128 + run - 1);
            std::memcpy(to, row + x * Size, Size);
            to += Size;
            rawBegin = x + run;
        }
        x += run;
    }
    flushRaw(width);
    return to;
}

std::byte* packRow(std::size_t pixelBytes, const std::byte* row, std::size_t width, std::byte* to) {
    switch (pixelBytes) {
    case 1:
        return packRow<1>(row, width, to);
    case 2:
        return packRow<2>(row, width, to);
    case 3:
        return packRow<3>(row, width, to);
    default:
        return packRow<4>(row, width, to);
    }
}

std::byte* writePacked(const Image& image, std::byte* to) {
    const auto width = static_cast<std::size_t>(image.width);
    Bytes row(image.rowBytes());
    for (int y = 0; y < image.height; ++y) {
        convertRow(image.format, image.at(0, y).data(), row.data(), width);
        to = packRow(static_cast<std::size_t>(bytesPerPixel(image.format)), row.data(), width, to);
    }
    return to;
}

Bytes write(const Image& image, AlphaMeaning alpha, bool topFirst, bool runLengthCoded) {
    const auto width = static_cast<std::size_t>(image.width);
    const auto height = static_cast<std::size_t>(image.height);
    const std::size_t maxRowBytes =
        image.rowBytes() + (runLengthCoded ? (width + maxPacket - 1) / maxPacket : 0);
    Bytes file(Header::headerBytes + maxRowBytes * height + extensionBytes + Footer::bytes);
    writeHeader(image, topFirst, runLengthCoded, file.data());
    std::byte* end = file.data() + Header::headerBytes;
    if (runLengthCoded) {
        end = writePacked(image, end);
    } else {
        convertRow(image.format, image.pixels.data(), end, width * height);
        end += maxRowBytes * height;
    }
    const auto pixelEnd = static_cast<std::size_t>(end - file.data());
    writeTail(pixelEnd, attributesType(image, alpha), end);
    file.resize(pixelEnd + extensionBytes + Footer::bytes);
    return file;
}

} // namespace

Result<Bytes> encodeTga(const TextureImage& texture, const WriteOptions& options) {
    if (texture.surfaces.empty())
        return fail(ErrorCode::OutOfRange, "TGA: there is no picture to write");
    const Surface& surface = texture.surfaces.front();
    constexpr int maxExtent = 65535;
    if (widthOf(surface) < 1 || heightOf(surface) < 1 || widthOf(surface) > maxExtent ||
        heightOf(surface) > maxExtent)
        return fail(ErrorCode::OutOfRange,
                    Sentence("TGA: a picture has 1 to 65535 pixels along each axis, this one has {0} × {1}",
                             widthOf(surface), heightOf(surface)));
    try {
        std::optional<Image> converted; // most pictures are written from where they are
        const Image* image = std::get_if<Image>(&surface);
        if (!image)
            image = &converted.emplace(toImage(surface));
        if (image->pixels.size() < image->rowBytes() * static_cast<std::size_t>(image->height))
            return fail(
                ErrorCode::Malformed,
                Sentence("TGA: the picture needs {0}, it has {1}",
                         Sentence::plural("{0} byte", "{0} bytes",
                                          image->rowBytes() * static_cast<std::size_t>(image->height)),
                         image->pixels.size()));
        if (texture.alpha == AlphaMeaning::None && hasAlpha(image->format))
            image = &converted.emplace(withoutMeaninglessAlpha(*image));
        return write(*image, texture.alpha, texture.topFirst, options.runLengthCoded);
    } catch (const std::bad_alloc&) {
        return fail(ErrorCode::TooLarge, "TGA: not enough memory for the file");
    }
}

} // namespace texplorer

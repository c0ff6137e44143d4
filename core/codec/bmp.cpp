#include "core/codec/bmp.h"

#include "core/base/byte_reader.h"
#include "core/codec/swizzle.h"

#include <algorithm>
#include <array>
#include <new>
#include <string>

namespace texplorer {

namespace {

// Offsets as in the file, little-endian. Headers longer than 40 bytes begin with the same fields.
//
//   0  "BM"        10  dataPos      18  width     28  bits a pixel   34  imageSize
//   2  file size   14  header size  22  height    30  compression
struct Header {
    std::size_t dataPos;
    std::uint32_t headerSize;
    std::int32_t width;
    std::int32_t height; // negative: the top row comes first
    std::uint16_t bitsPerPixel;
    std::uint32_t compression;

    [[nodiscard]] bool topDown() const { return height < 0; }
    [[nodiscard]] std::int64_t rows() const {
        return height < 0 ? -std::int64_t{height} : std::int64_t{height};
    }
    [[nodiscard]] std::size_t end() const { return 14 + std::size_t{headerSize}; }
};

constexpr std::uint32_t shortestHeader = 40;
constexpr std::array headerSizes{shortestHeader, 52U, 56U, 64U, 108U, 124U};

tl::unexpected<Error> malformed(const std::string& message) {
    return fail(ErrorCode::Malformed, "BMP: " + message);
}

tl::unexpected<Error> unsupported(const std::string& message) {
    return fail(ErrorCode::Unsupported, "BMP: " + message);
}

std::string bytesOf(std::size_t size) {
    return std::to_string(size) + (size == 1 ? " byte" : " bytes");
}

std::string knownHeaderSizes() {
    std::string text;
    for (const std::uint32_t size : headerSizes)
        text.append(text.empty() ? "" : ", ").append(std::to_string(size));
    return text;
}

std::string compressionName(std::uint32_t compression) {
    constexpr std::array names{"none", "RLE8", "RLE4", "bit fields", "JPEG", "PNG", "bit fields with alpha"};
    return compression < names.size() ? names[compression] : "number " + std::to_string(compression);
}

// Nothing that `imageSize` says is needed: where it is 0 the extents fill it in, where it isn't they are
// still what the picture has.
Result<Header> readHeader(ByteView file) {
    ByteReader reader(file);
    const ByteView magic = reader.take(2);
    if (magic.empty() || magic[0] != std::byte{'B'} || magic[1] != std::byte{'M'})
        return malformed(file.empty() ? "the file is empty" : "the file does not begin with \"BM\"");

    Header header{};
    reader.skip(8);
    header.dataPos = reader.u32();
    header.headerSize = reader.u32();
    header.width = reader.i32();
    header.height = reader.i32();
    reader.skip(2);
    header.bitsPerPixel = reader.u16();
    header.compression = reader.u32();
    if (file.size() < 14 + shortestHeader)
        return malformed("the headers need 54 bytes, the file has " + std::to_string(file.size()));
    if (std::ranges::find(headerSizes, header.headerSize) == headerSizes.end())
        return unsupported("headers of " + knownHeaderSizes() + " bytes are read, the file has one of " +
                           std::to_string(header.headerSize));
    if (header.dataPos == 0)
        header.dataPos = header.end();
    return header;
}

Result<void> checkHeader(const Header& header, ByteView file, const DecodeLimits& limits) {
    if (header.bitsPerPixel != 24)
        return unsupported("24 bits a pixel are read, the file has " + std::to_string(header.bitsPerPixel));
    if (header.compression != 0)
        return unsupported("uncompressed files are read, this one's compression is " +
                           compressionName(header.compression));
    const std::string extents =
        std::to_string(header.width) + " x " + std::to_string(header.rows()) + " pixels";
    if (header.width < 1 || header.rows() < 1)
        return malformed("a picture has at least 1 x 1 pixels, this one says " + extents);
    if (header.width > limits.maxExtent || header.rows() > limits.maxExtent)
        return fail(ErrorCode::TooLarge, "BMP: at most " + std::to_string(limits.maxExtent) + " x " +
                                             std::to_string(limits.maxExtent) +
                                             " pixels are read, the file has " + extents);
    if (header.dataPos < header.end())
        return malformed("pixel data begins at offset " + std::to_string(header.dataPos) +
                         ", within the headers, which end at " + std::to_string(header.end()));
    if (header.dataPos > file.size())
        return malformed("pixel data begins at offset " + std::to_string(header.dataPos) + ", the file has " +
                         bytesOf(file.size()));
    return {};
}

std::size_t paddedRow(std::size_t rowBytes) {
    return (rowBytes + 3) / 4 * 4;
}

void copyRows(ByteView data, bool topDown, Image& image) {
    const std::size_t rowBytes = image.rowBytes();
    const std::size_t stride = paddedRow(rowBytes);
    const auto width = static_cast<std::size_t>(image.width);
    const auto height = static_cast<std::size_t>(image.height);
    if (!topDown && stride == rowBytes)
        return swapRedBlue(data.data(), image.pixels.data(), width * height);
    for (std::size_t y = 0; y < height; ++y) {
        const std::size_t row = topDown ? height - 1 - y : y;
        swapRedBlue(data.data() + y * stride, image.pixels.data() + row * rowBytes, width);
    }
}

} // namespace

Result<TextureImage> decodeBmp(ByteView file, const DecodeLimits& limits) {
    const Result<Header> header = readHeader(file);
    if (!header)
        return fail(header.error());
    if (const Result<void> checked = checkHeader(*header, file, limits); !checked)
        return fail(checked.error());

    const std::size_t needed =
        paddedRow(3 * static_cast<std::size_t>(header->width)) * static_cast<std::size_t>(header->rows());
    const ByteView data = file.subspan(header->dataPos);
    if (data.size() < needed)
        return malformed("pixel data needs " + bytesOf(needed) + " from offset " +
                         std::to_string(header->dataPos) + ", the file has " + std::to_string(file.size()));
    try {
        Image image =
            Image::uninitialised(PixelFormat::Rgb8, header->width, static_cast<int>(header->rows()));
        copyRows(data, header->topDown(), image);
        TextureImage texture = textureOf(std::move(image), "BMP");
        texture.fileTopFirst = header->topDown();
        return texture;
    } catch (const std::bad_alloc&) {
        return fail(ErrorCode::TooLarge, "BMP: there is no memory for " + bytesOf(needed));
    }
}

} // namespace texplorer

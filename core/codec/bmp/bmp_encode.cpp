#include "texplorer/codec/bmp/bmp.h"
#include "texplorer/codec/bmp/bmp_header.h"
#include "texplorer/codec/common/reorder.h"
#include "texplorer/codec/common/swizzle.h"
#include "texplorer/codec/common/write_options.h"
#include "texplorer/s3tc/surface_pixels.h"

#include <cstring>
#include <limits>
#include <new>
#include <string_view>

namespace texplorer {

namespace {

// What a pixel format becomes.
struct Layout {
    unsigned bitsPerPixel;
    std::uint32_t headerSize;
    std::uint32_t paletteEntries;
};

Layout layoutOf(PixelFormat format) {
    switch (format) {
    case PixelFormat::Rgb8:
        return {24, 40, 0};
    case PixelFormat::Luminance8:
        return {8, 40, 256};
    case PixelFormat::Rgba8:
    case PixelFormat::LuminanceAlpha8:
    case PixelFormat::Alpha8:
    case PixelFormat::Depth32:
    case PixelFormat::RgbaFloat:
        break;
    }
    return {32, 108, 0};
}

class Writer {
public:
    explicit Writer(std::byte* place)
        : place_(place) {}

    void u16(unsigned value) { number(value, 2); }
    void u32(std::uint32_t value) { number(value, 4); }
    void text(std::string_view letters) {
        for (const char letter : letters)
            number(static_cast<unsigned char>(letter), 1);
    }

private:
    void number(std::uint32_t value, unsigned bytes) {
        for (unsigned i = 0; i < bytes; ++i)
            *place_++ = static_cast<std::byte>(value >> (8 * i));
    }
    std::byte* place_;
};

void writeHeaders(Bytes& file, const Image& image, const Layout& layout, std::uint32_t dataPos) {
    const auto size = static_cast<std::uint32_t>(file.size());
    std::memset(file.data(), 0, dataPos);
    Writer writer(file.data());
    writer.text("BM");
    writer.u32(size);
    writer.u32(0);
    writer.u32(dataPos);

    const bool masks = layout.bitsPerPixel == 32;
    constexpr std::uint32_t pixelsPerMetre = 2835; // 72 per inch
    writer.u32(layout.headerSize);
    writer.u32(static_cast<std::uint32_t>(image.width));
    writer.u32(static_cast<std::uint32_t>(image.height));
    writer.u16(1);
    writer.u16(layout.bitsPerPixel);
    writer.u32(static_cast<std::uint32_t>(masks ? bmp::Compression::BitFields : bmp::Compression::None));
    writer.u32(size - dataPos);
    writer.u32(pixelsPerMetre);
    writer.u32(pixelsPerMetre);
    writer.u32(layout.paletteEntries);
    writer.u32(0);
    if (masks) {
        for (const std::uint32_t mask : {0x00FF0000U, 0x0000FF00U, 0x000000FFU, 0xFF000000U})
            writer.u32(mask);
        writer.text("BGRs"); // LCS_sRGB: the letters of a number, last one first
    }
    for (std::uint32_t grey = 0; grey < layout.paletteEntries; ++grey)
        writer.u32(grey * 0x010101);
}

void writeRow(PixelFormat format, const std::byte* from, std::byte* to, std::size_t width) {
    constexpr ByteOrder blueGreenRedAlpha{2, 1, 0, 3};
    switch (format) {
    case PixelFormat::Rgb8:
        return swapRedBlue(from, to, width);
    case PixelFormat::Rgba8:
    case PixelFormat::Depth32:
    case PixelFormat::RgbaFloat:
        return reorderFourToFour(from, to, width, blueGreenRedAlpha);
    case PixelFormat::Luminance8:
        std::memcpy(to, from, width);
        return;
    case PixelFormat::LuminanceAlpha8:
        for (std::size_t x = 0; x < width; ++x, from += 2, to += 4) {
            std::memset(to, std::to_integer<int>(from[0]), 3);
            to[3] = from[1];
        }
        return;
    case PixelFormat::Alpha8:
        for (std::size_t x = 0; x < width; ++x, to += 4) {
            std::memset(to, 0, 3);
            to[3] = from[x];
        }
        return;
    }
}

Result<Bytes> encode(const Image& image, bool topFirst) {
    if (image.width < 1 || image.height < 1)
        return bmp::malformed(Sentence("a picture has at least 1 × 1 pixels, this one has {0} × {1}",
                                       image.width, image.height));
    const Layout layout = layoutOf(image.format);
    const auto width = static_cast<std::size_t>(image.width);
    const auto height = static_cast<std::size_t>(image.height);
    const std::size_t dataPos =
        bmp::fileHeaderSize + layout.headerSize + std::size_t{4} * layout.paletteEntries;
    const std::size_t rowBytes = width * layout.bitsPerPixel / 8;
    const std::size_t stride = (rowBytes + 3) / 4 * 4;
    const std::size_t size = dataPos + stride * height;
    if (size > std::numeric_limits<std::uint32_t>::max())
        return bmp::tooLarge(Sentence("a file has at most 4294967295 bytes, this picture needs {0}", size));
    Bytes file(size);
    writeHeaders(file, image, layout, static_cast<std::uint32_t>(dataPos));
    for (std::size_t y = 0; y < height; ++y) {
        std::byte* to = file.data() + dataPos + y * stride;
        const std::size_t row = topFirst ? height - 1 - y : y;
        writeRow(image.format, image.pixels.data() + row * image.rowBytes(), to, width);
        std::memset(to + rowBytes, 0, stride - rowBytes);
    }
    return file;
}

} // namespace

Result<Bytes> encodeBmp(const TextureImage& texture, const WriteOptions& /*options*/) {
    if (texture.surfaces.empty())
        return bmp::malformed("there is no picture to write");
    try {
        const Surface& surface = texture.surface(0, 0);
        if (const Image* image = std::get_if<Image>(&surface))
            return encode(*image, texture.topFirst);
        return encode(toImage(surface), texture.topFirst);
    } catch (const std::bad_alloc&) {
        return bmp::tooLarge(N_("not enough memory for the file"));
    }
}

} // namespace texplorer

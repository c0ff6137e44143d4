#include "texplorer/codec/bmp/bmp.h"

#include "texplorer/base/sentence.h"
#include "texplorer/codec/bmp/bmp_bitfields.h"
#include "texplorer/codec/bmp/bmp_header.h"
#include "texplorer/codec/bmp/bmp_palette.h"
#include "texplorer/codec/bmp/bmp_rle.h"
#include "texplorer/codec/common/swizzle.h"

#include <algorithm>
#include <bit>
#include <new>

namespace texplorer {

namespace {

using bmp::Header;

// Where row `y` of the file belongs.
std::byte* placeOf(Image& image, const Header& header, std::size_t y) {
    const auto height = static_cast<std::size_t>(image.height);
    return image.pixels.data() + (header.topDown ? height - 1 - y : y) * image.rowBytes();
}

Result<Image> imageFor(const Header& header, PixelFormat format, const DecodeLimits& limits) {
    const std::uint64_t bytes = static_cast<std::uint64_t>(header.width) *
                                static_cast<std::uint64_t>(header.height) *
                                static_cast<std::uint64_t>(bytesPerPixel(format));
    if (bytes > limits.maxBytes)
        return bmp::tooLarge(Sentence("at most {0} of pixels are read, the picture has {1}",
                                      Sentence::plural("{0} byte", "{0} bytes", limits.maxBytes), bytes));
    Image image{format, static_cast<int>(header.width), static_cast<int>(header.height), 1, {}};
    if (limits.pixels)
        image.pixels.resize(image.byteCount());
    return image;
}

void copyTrueColor(ByteView data, const Header& header, Image& image) {
    const std::size_t rowBytes = image.rowBytes();
    const auto stride = static_cast<std::size_t>(header.rowStride());
    const auto width = static_cast<std::size_t>(image.width);
    const auto height = static_cast<std::size_t>(image.height);
    if (!header.topDown && stride == rowBytes)
        return swapRedBlue(data.data(), image.pixels.data(), width * height);
    for (std::size_t y = 0; y < height; ++y)
        swapRedBlue(data.data() + y * stride, placeOf(image, header, y), width);
}

void copyBitFields(ByteView data, const Header& header, const bmp::BitFields& fields, Image& image) {
    const auto stride = static_cast<std::size_t>(header.rowStride());
    for (std::size_t y = 0; y < static_cast<std::size_t>(image.height); ++y)
        fields.paint(data.data() + y * stride, placeOf(image, header, y),
                     static_cast<std::size_t>(image.width));
}

// One, two or four bits an index, the leftmost pixel in the highest bits.
void unpackIndices(ByteView packed, unsigned bits, std::span<std::byte> to) {
    const unsigned perByte = 8 / bits;
    const auto mask = static_cast<std::byte>((1U << bits) - 1);
    for (std::size_t x = 0; x < to.size(); ++x) {
        const auto place = static_cast<unsigned>(x % perByte);
        to[x] = packed[x / perByte] >> (8 - bits * (place + 1)) & mask;
    }
}

void paintIndexed(ByteView data, const Header& header, bmp::Palette& palette, Image& image) {
    Bytes indices(header.bitsPerPixel == 8 ? 0 : static_cast<std::size_t>(image.width));
    for (std::size_t y = 0; y < static_cast<std::size_t>(image.height); ++y) {
        const ByteView row = partOf(data, y * header.rowStride(), header.rowBytes());
        if (header.bitsPerPixel != 8)
            unpackIndices(row, header.bitsPerPixel, indices);
        palette.paint(header.bitsPerPixel == 8 ? row : ByteView(indices), placeOf(image, header, y));
    }
}

// Rows that the codes left out are painted when the next one arrives, so that every row is written once.
class RowPainter : public bmp::RleRows {
public:
    RowPainter(const Header& header, bmp::Palette& palette, Image& image)
        : header_(header)
        , palette_(palette)
        , image_(image)
        , blank_(static_cast<std::size_t>(image.width), std::byte{0}) {}

    void row(int y, ByteView indices) override {
        fillTo(y);
        palette_.paint(indices, placeOf(image_, header_, static_cast<std::size_t>(y)));
        next_ = y + 1;
    }
    void fillTo(int end) {
        for (; next_ < end; ++next_)
            palette_.paint(blank_, placeOf(image_, header_, static_cast<std::size_t>(next_)));
    }

private:
    const Header& header_;
    bmp::Palette& palette_;
    Image& image_;
    Bytes blank_;
    int next_ = 0;
};

// Codes can skip and end early, so that any two bytes are a whole picture. Of those that paint, two bytes are
// 255 pixels at most: a header that claims more wants memory rather than a picture.
Result<void> checkRleClaim(ByteView codes, const Header& header) {
    constexpr std::uint64_t alwaysAdmitted = std::uint64_t{1024} * 1024;
    const std::uint64_t pixels =
        static_cast<std::uint64_t>(header.width) * static_cast<std::uint64_t>(header.height);
    const std::uint64_t maxPixels = std::max(alwaysAdmitted, std::uint64_t{codes.size()} * 255);
    if (pixels <= maxPixels)
        return {};
    return bmp::malformed(Sentence("{0} of run-length codes make at most {1} pixels, the file has {2}",
                                   Sentence::plural("{0} byte", "{0} bytes", codes.size()), maxPixels,
                                   pixels));
}

Result<void> paintRle(ByteView codes, Header& header, bmp::Palette& palette, Image& image) {
    RowPainter painter(header, palette, image);
    const bmp::RleReport report =
        bmp::decodeRle(codes, static_cast<int>(header.bitsPerPixel), image.width, image.height, painter);
    painter.fillTo(image.height);
    if (!report.ended)
        return bmp::malformed(Sentence(
            "the run-length codes end at offset {0} within row {1} of {2}, without an end-of-picture code",
            header.dataPos + report.consumed, report.row + 1, image.height));
    if (report.clipped > 0)
        header.notes.push_back(
            Sentence("{0} continued beyond the end of a row and ended there",
                     Sentence::plural("{0} run-length code", "{0} run-length codes", report.clipped)));
    const std::size_t pixels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    if (report.painted < pixels)
        header.remarks.push_back(
            Sentence("the run-length codes skip {0}; these have the palette's first colour",
                     Sentence::plural("{0} pixel", "{0} pixels", pixels - report.painted)));
    if (header.topDown)
        header.notes.emplace_back(N_("run-length coded pictures should not be top-down"));
    return {};
}

/// Pixels without bit fields: what is made of their fourth bytes. An alpha mask counts where they are not all
/// 0; without one they are not used, but some writers keep alpha there.
void readFourthBytes(ByteView data, Header& header) {
    if (header.bitsPerPixel != 32 || header.masksPos != 0)
        return;
    std::byte all{0xFF};
    std::byte any{0};
    const auto size = static_cast<std::size_t>(header.pixelBytes());
    for (std::size_t i = 3; i < size; i += 4) {
        all &= data[i];
        any |= data[i];
    }
    if (header.loneAlphaMask) {
        const bool used = any != std::byte{0};
        header.opaque = !used;
        header.remarks.emplace_back(
            used
                ? N_("the pixels are not bit fields, but the header has an alpha mask: the fourth bytes are "
                     "used as alpha")
                : N_("the header has an alpha mask, but the fourth bytes of all pixels are 0: they are ignored"));
    } else if (all != any)
        header.remarks.emplace_back(N_(
            "the fourth bytes of the pixels differ and may be alpha; without an alpha mask they are ignored"));
}

void noteOddMasks(Header& header) {
    const bmp::Masks& masks = header.masks;
    if (!std::ranges::all_of(masks, bmp::contiguous))
        header.notes.emplace_back(N_("the bits of a colour mask are not contiguous"));
    std::uint32_t seen = 0;
    bool overlap = false;
    for (const std::uint32_t mask : masks) {
        overlap = overlap || (seen & mask) != 0;
        seen |= mask;
    }
    if (overlap)
        header.notes.emplace_back(N_("colour masks overlap"));
    if (header.bitsPerPixel == 16 && seen > 0xFFFF)
        header.notes.emplace_back(N_("a colour mask has bits that a 16-bit pixel lacks; they are ignored"));
}

Result<Image> decodeIndexed(ByteView file, Header& header, const DecodeLimits& limits) {
    const ByteView data = partOf(file, header.dataPos, file.size());
    if (header.runLengthCoded())
        if (const Result<void> claim = checkRleClaim(data, header); !claim)
            return fail(claim.error());
    bmp::Palette palette(file, header);
    Result<Image> image = imageFor(header, palette.format(), limits);
    if (!image || !limits.pixels)
        return image;
    if (header.runLengthCoded()) {
        if (const Result<void> painted = paintRle(data, header, palette, *image); !painted)
            return fail(painted.error());
    } else {
        paintIndexed(data, header, palette, *image);
    }
    if (palette.exceeded())
        header.notes.push_back(Sentence("a pixel has colour {0}, the palette has {1}; it is black",
                                        palette.highest(), header.paletteEntries));
    return image;
}

Result<Image> decodeDirect(ByteView file, Header& header, const DecodeLimits& limits) {
    const ByteView data = partOf(file, header.dataPos, file.size());
    if (header.bitsPerPixel == 24) {
        Result<Image> image = imageFor(header, PixelFormat::Rgb8, limits);
        if (image && limits.pixels)
            copyTrueColor(data, header, *image);
        return image;
    }
    noteOddMasks(header);
    if (limits.pixels)
        readFourthBytes(data, header);
    if (header.bitsPerPixel == 16)
        for (std::uint32_t& mask : header.masks)
            mask &= 0xFFFF;
    const bmp::BitFields fields(header.masks, header.bitsPerPixel);
    Result<Image> image =
        imageFor(header, fields.hasAlpha() ? PixelFormat::Rgba8 : PixelFormat::Rgb8, limits);
    if (image && limits.pixels)
        copyBitFields(data, header, fields, *image);
    if (image && header.opaque)
        for (std::size_t i = 3; i < image->pixels.size(); i += 4)
            image->pixels[i] = std::byte{255};
    return image;
}

} // namespace

Result<TextureImage> decodeBmp(ByteView file, const DecodeLimits& limits) {
    Result<Header> header = bmp::readHeader(file, limits);
    if (!header)
        return fail(header.error());
    try {
        Result<Image> image = header->bitsPerPixel <= 8 ? decodeIndexed(file, *header, limits)
                                                        : decodeDirect(file, *header, limits);
        if (!image)
            return fail(image.error());
        TextureImage texture = textureOf(std::move(*image), "BMP");
        texture.fileTopFirst = header->topDown;
        texture.notes = std::move(header->notes);
        texture.remarks = std::move(header->remarks);
        for (const std::uint32_t mask : header->masks)
            texture.componentBits = std::max(texture.componentBits, std::popcount(mask));
        if (bmp::hasColorSpace(file, *header))
            texture.losses.push_back({"colorProfile", N_("the colour space of its header"), false});
        return texture;
    } catch (const std::bad_alloc&) {
        return bmp::tooLarge(
            Sentence("not enough memory for {0} × {1} pixels", header->width, header->height));
    }
}

} // namespace texplorer

#include "texplorer/codec/bmp/bmp_header.h"

#include "texplorer/base/byte_reader.h"
#include "texplorer/base/sentence.h"

#include <algorithm>

namespace texplorer::bmp {

namespace {

constexpr std::uint32_t numberOf(Compression compression) {
    return static_cast<std::uint32_t>(compression);
}

bool hasBitFields(const Header& header) {
    return header.compression == numberOf(Compression::BitFields) ||
           header.compression == numberOf(Compression::AlphaBitFields);
}

// Windows' 16-bit pixels have five bits a component and 32-bit ones a byte; the rest is not used.
//
//   16  x rrrrr ggggg bbbbb        32  xxxxxxxx rrrrrrrr gggggggg bbbbbbbb
Masks usualMasks(unsigned bitsPerPixel) {
    if (bitsPerPixel == 16)
        return {0x7C00, 0x03E0, 0x001F, 0};
    return {0x00FF0000, 0x0000FF00, 0x000000FF, 0};
}

/// Without bit fields the masks of a longer header need not be filled in. Writers that fill in alpha's mean
/// it: the byte that colours leave free.
void parseLoneAlphaMask(ByteView file, Header& header) {
    constexpr std::size_t alphaMaskPos = fileHeaderSize + 52;
    const HeaderKind kind = headerKind(header.headerSize);
    const bool hasMask = (kind == HeaderKind::Windows3Masks && header.headerSize == 56) ||
                         kind == HeaderKind::V4 || kind == HeaderKind::V5;
    if (!hasMask || header.bitsPerPixel != 32 || header.compression != numberOf(Compression::None))
        return;
    ByteReader reader(file);
    reader.skip(alphaMaskPos);
    if (reader.u32() != 0xFF000000)
        return;
    header.masks[3] = 0xFF000000;
    header.loneAlphaMask = true;
}

// The masks stand behind a header of 40 bytes and within the longer ones, both times at offset 54.
void parseMasks(ByteView file, Header& header) {
    if (header.bitsPerPixel != 16 && header.bitsPerPixel != 32)
        return;
    const HeaderKind kind = headerKind(header.headerSize);
    if (!hasBitFields(header) || kind == HeaderKind::Os22 || kind == HeaderKind::Os21) {
        header.masks = usualMasks(header.bitsPerPixel);
        parseLoneAlphaMask(file, header);
        return;
    }
    header.masksPos = fileHeaderSize + 40;
    const bool alphaFollows =
        header.headerSize >= 56 || header.compression == numberOf(Compression::AlphaBitFields);
    ByteReader reader(file);
    reader.skip(header.masksPos);
    for (std::size_t i = 0; i < (alphaFollows ? 4U : 3U); ++i)
        header.masks[i] = reader.u32();
    if (header.headerSize == 40)
        header.palettePos += alphaFollows ? 16 : 12;

    if ((header.masks[0] | header.masks[1] | header.masks[2]) == 0) {
        header.notes.emplace_back(N_("the colour masks are all 0; the usual ones were used"));
        header.masks = usualMasks(header.bitsPerPixel);
    }
}

// How many entries there should be and how many there is room for are two numbers; the smaller one counts.
void placePalette(ByteView file, Header& header) {
    const std::size_t maxEntries = header.bitsPerPixel <= 8 ? std::size_t{1} << header.bitsPerPixel : 256;
    const bool needed = header.bitsPerPixel >= 1 && header.bitsPerPixel <= 8;
    std::size_t claimed = header.colorsUsed;
    if (claimed == 0 && needed)
        claimed = maxEntries;
    if (claimed > maxEntries) {
        header.notes.push_back(
            Sentence("the header has {0} palette entries, but only {1} can be used", claimed, maxEntries));
        claimed = needed ? maxEntries : 0;
    }
    if (header.dataPos == 0) {
        header.dataPos = header.palettePos + claimed * header.paletteEntryBytes;
        header.notes.emplace_back(Sentence(
            "the header does not give the offset of the pixels; offset {0}, after the preceding data, is "
            "used",
            header.dataPos));
    }
    const std::uint64_t end = std::min<std::uint64_t>(header.dataPos, file.size());
    const std::uint64_t room = end > header.palettePos ? end - header.palettePos : 0;
    header.paletteEntries =
        static_cast<std::size_t>(std::min<std::uint64_t>(claimed, room / header.paletteEntryBytes));
}

Result<void> checkCompression(const Header& header) {
    const unsigned bits = header.bitsPerPixel;
    const auto needs = [&](const std::string& which) {
        return malformed(Sentence("{0} needs {1} bits a pixel, the file has {2}",
                                  compressionName(header.compression, header.headerSize), which, bits));
    };
    const Sentence name = compressionName(header.compression, header.headerSize);
    if (headerKind(header.headerSize) == HeaderKind::Os22 && header.compression > 2)
        return unsupported(Sentence(
            "only uncompressed and RLE pixels of OS/2 files are read, this file's compression is {0}", name));
    switch (static_cast<Compression>(header.compression)) {
    case Compression::None:
        if (bits != 1 && bits != 2 && bits != 4 && bits != 8 && bits != 16 && bits != 24 && bits != 32)
            return unsupported(
                Sentence("1, 2, 4, 8, 16, 24 or 32 bits a pixel are read, the file has {0}", bits));
        return {};
    case Compression::Rle8:
        return bits == 8 ? Result<void>() : needs("8");
    case Compression::Rle4:
        return bits == 4 ? Result<void>() : needs("4");
    case Compression::BitFields:
    case Compression::AlphaBitFields:
        return bits == 16 || bits == 32 ? Result<void>() : needs(N_("16 or 32"));
    case Compression::Jpeg:
    case Compression::Png:
        return unsupported(
            Sentence("the file contains a whole {0} file for printers, at offset {1}; extract it first", name,
                     header.dataPos));
    default:
        return unsupported(Sentence(
            "only uncompressed, RLE and bit-field pixels are read, this file's compression is {0}", name));
    }
}

Result<void> checkExtents(const Header& header, const DecodeLimits& limits) {
    const Sentence extents(N_("{0} × {1} pixels"), header.width, header.height);
    if (header.width < 1 || header.height < 1)
        return malformed(Sentence("a picture has at least 1 × 1 pixels, this one has {0}", extents));
    if (header.width > limits.maxExtent || header.height > limits.maxExtent)
        return tooLarge(
            Sentence("at most {0} × {0} pixels are read, the file has {1}", limits.maxExtent, extents));
    const auto pixels = static_cast<std::uint64_t>(header.width) * static_cast<std::uint64_t>(header.height);
    if (pixels > limits.maxPixels)
        return tooLarge(Sentence("at most {0} are read, the file has {1}",
                                 Sentence::plural("{0} pixel", "{0} pixels", limits.maxPixels), extents));
    return {};
}

Result<void> checkPlaces(const Header& header, ByteView file) {
    if (header.dataPos < header.palettePos)
        return malformed(Sentence("pixel data begins at offset {0}, within the headers, which end at {1}",
                                  header.dataPos, header.palettePos));
    if (header.dataPos > file.size())
        return malformed(Sentence("pixel data begins at offset {0}, the file has {1}", header.dataPos,
                                  Sentence::plural("{0} byte", "{0} bytes", file.size())));
    if (!header.runLengthCoded() && header.pixelBytes() > file.size() - header.dataPos)
        return malformed(Sentence("pixel data needs {0} from offset {1}, the file has {2}",
                                  Sentence::plural("{0} byte", "{0} bytes", header.pixelBytes()),
                                  header.dataPos, file.size()));
    if (header.bitsPerPixel <= 8 && header.paletteEntries == 0)
        return malformed(Sentence(
            "{0} a pixel need a palette, but there is none between offset {1} and the pixels at "
            "{2}",
            Sentence::plural("{0} bit", "{0} bits", header.bitsPerPixel), header.palettePos, header.dataPos));
    return {};
}

} // namespace

tl::unexpected<Error> malformed(const Sentence& message) {
    return fail(ErrorCode::Malformed, Sentence("BMP: {0}", message));
}

tl::unexpected<Error> unsupported(const Sentence& message) {
    return fail(ErrorCode::Unsupported, Sentence("BMP: {0}", message));
}

tl::unexpected<Error> tooLarge(const Sentence& message) {
    return fail(ErrorCode::TooLarge, Sentence("BMP: {0}", message));
}

HeaderKind headerKind(std::uint32_t headerSize) {
    switch (headerSize) {
    case 12:
        return HeaderKind::Os21;
    case 40:
        return HeaderKind::Windows3;
    case 52:
    case 56:
        return HeaderKind::Windows3Masks;
    case 108:
        return HeaderKind::V4;
    case 124:
        return HeaderKind::V5;
    default:
        return headerSize >= 16 && headerSize <= 64 ? HeaderKind::Os22 : HeaderKind::Unknown;
    }
}

std::string_view headerName(std::uint32_t headerSize) {
    switch (headerKind(headerSize)) {
    case HeaderKind::Os21:
        return "BITMAPCOREHEADER (OS/2 1.x)";
    case HeaderKind::Os22:
        return "BITMAPINFOHEADER2 (OS/2 2.x)";
    case HeaderKind::Windows3:
        return N_("BITMAPINFOHEADER (Windows 3)");
    case HeaderKind::Windows3Masks:
        return headerSize == 52 ? "BITMAPV2INFOHEADER" : "BITMAPV3INFOHEADER";
    case HeaderKind::V4:
        return "BITMAPV4HEADER";
    case HeaderKind::V5:
        return "BITMAPV5HEADER";
    case HeaderKind::Unknown:
        break;
    }
    return N_("unknown header");
}

Sentence compressionName(std::uint32_t compression, std::uint32_t headerSize) {
    if (headerKind(headerSize) == HeaderKind::Os22 && (compression == 3 || compression == 4))
        return compression == 3 ? N_("Huffman 1D") : "RLE24";
    switch (static_cast<Compression>(compression)) {
    case Compression::None:
        return "none";
    case Compression::Rle8:
        return "RLE8";
    case Compression::Rle4:
        return "RLE4";
    case Compression::BitFields:
        return N_("bit fields");
    case Compression::Jpeg:
        return "JPEG";
    case Compression::Png:
        return "PNG";
    case Compression::AlphaBitFields:
        return N_("bit fields with alpha");
    case Compression::Cmyk:
        return "CMYK";
    case Compression::CmykRle8:
        return N_("CMYK with RLE8");
    case Compression::CmykRle4:
        return N_("CMYK with RLE4");
    }
    return Sentence("number {0}", compression);
}

Header parseHeader(ByteView file) {
    Header header;
    ByteReader start(file);
    start.skip(10);
    header.dataPos = start.u32();
    header.headerSize = start.u32();

    // What lies behind the header's own end belongs to something else.
    ByteReader reader(partOf(file, 0, fileHeaderSize + std::uint64_t{header.headerSize}));
    reader.skip(18);
    if (headerKind(header.headerSize) == HeaderKind::Os21) {
        header.width = reader.u16();
        header.height = reader.u16();
        reader.skip(2);
        header.bitsPerPixel = reader.u16();
        header.paletteEntryBytes = 3;
    } else {
        header.width = reader.i32();
        header.height = reader.i32();
        reader.skip(2);
        header.bitsPerPixel = reader.u16();
        header.compression = reader.u32();
        header.imageSize = reader.u32();
        reader.skip(8);
        header.colorsUsed = reader.u32();
        header.topDown = header.height < 0;
        header.height = header.topDown ? -header.height : header.height;
    }
    header.palettePos = fileHeaderSize + std::uint64_t{header.headerSize};
    parseMasks(file, header);
    placePalette(file, header);
    return header;
}

bool hasColorSpace(ByteView file, const Header& header) {
    const HeaderKind kind = headerKind(header.headerSize);
    if (kind != HeaderKind::V4 && kind != HeaderKind::V5)
        return false;
    constexpr std::uint32_t linked = 0x4C494E4B;   // 'LINK'
    constexpr std::uint32_t embedded = 0x4D424544; // 'MBED'
    constexpr std::uint32_t calibrated = 0;        // by primaries and gammas; writers leave them 0 as well
    ByteReader reader(file);
    reader.skip(fileHeaderSize + 56);
    const std::uint32_t type = reader.u32();
    std::uint32_t any = 0;
    for (int i = 0; i < 12; ++i)
        any |= reader.u32();
    return type == linked || type == embedded || (type == calibrated && any != 0);
}

Result<Header> readHeader(ByteView file, const DecodeLimits& limits) {
    if (file.size() < 2 || file[0] != std::byte{'B'} || file[1] != std::byte{'M'})
        return malformed(file.empty() ? "the file is empty" : N_("the file does not begin with \"BM\""));
    constexpr std::size_t minBytes = fileHeaderSize + 12;
    const auto headersNeed = [&](std::uint64_t size) {
        return malformed(Sentence("the headers need {0} bytes, the file has {1}", size, file.size()));
    };
    if (file.size() < minBytes)
        return headersNeed(minBytes);
    Header header = parseHeader(file);
    if (headerKind(header.headerSize) == HeaderKind::Unknown)
        return unsupported(
            Sentence("headers of 12, 16 to 64, 108 and 124 bytes are read, the file has one of {0}",
                     header.headerSize));
    if (file.size() < header.palettePos)
        return headersNeed(header.palettePos);
    if (const Result<void> checked = checkCompression(header); !checked)
        return fail(checked.error());
    if (const Result<void> checked = checkExtents(header, limits); !checked)
        return fail(checked.error());
    if (const Result<void> checked = checkPlaces(header, file); !checked)
        return fail(checked.error());
    return header;
}

} // namespace texplorer::bmp

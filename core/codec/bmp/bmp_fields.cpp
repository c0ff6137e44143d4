#include "texplorer/codec/bmp/bmp_fields.h"

#include "texplorer/base/byte_reader.h"
#include "texplorer/base/sentence.h"
#include "texplorer/base/translatable.h"
#include "texplorer/codec/bmp/bmp_bitfields.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <bit>

namespace texplorer::bmp {

namespace {

Sentence checkMagic(std::int64_t value, const FieldContext& /*context*/) {
    return value == ('B' | 'M' << 8) ? "" : N_("expected \"BM\"");
}

Sentence checkFileSize(std::int64_t value, const FieldContext& context) {
    const auto size = static_cast<std::int64_t>(context.file.size());
    return value == size
               ? ""
               : Sentence("the file has {0}", Sentence::plural("{0} byte", "{0} bytes", context.file.size()));
}

Sentence checkZero(std::int64_t value, const FieldContext& /*context*/) {
    return value == 0 ? "" : N_("expected 0");
}

Sentence checkDataPos(std::int64_t value, const FieldContext& context) {
    if (value == 0)
        return Sentence("expected {0}, which is used instead", context.header.dataPos);
    if (value < static_cast<std::int64_t>(context.header.palettePos))
        return Sentence("lies within the headers, which end at {0}", context.header.palettePos);
    if (value > static_cast<std::int64_t>(context.file.size()))
        return Sentence("the file has {0}", Sentence::plural("{0} byte", "{0} bytes", context.file.size()));
    return {};
}

Sentence checkHeaderSize(std::int64_t value, const FieldContext& /*context*/) {
    return headerKind(static_cast<std::uint32_t>(value)) == HeaderKind::Unknown
               ? N_("expected 12, 16 to 64, 108 or 124")
               : "";
}

Sentence checkWidth(std::int64_t value, const FieldContext& /*context*/) {
    return value >= 1 ? "" : N_("expected at least 1");
}

Sentence checkHeight(std::int64_t value, const FieldContext& context) {
    if (value == 0)
        return N_("expected at least 1, or at most -1 for the top row first");
    return value < 0 && context.header.runLengthCoded() ? N_("run-length codes should not be top-down") : "";
}

Sentence checkPlanes(std::int64_t value, const FieldContext& /*context*/) {
    return value == 1 ? "" : N_("expected 1");
}

Sentence checkBits(std::int64_t value, const FieldContext& context) {
    const auto compression = static_cast<Compression>(context.header.compression);
    if (value == 0 && (compression == Compression::Jpeg || compression == Compression::Png))
        return {};
    constexpr std::array<std::int64_t, 7> known{1, 2, 4, 8, 16, 24, 32};
    return std::ranges::find(known, value) == known.end() ? N_("expected 1, 4, 8, 16, 24 or 32") : "";
}

Sentence checkCompression(std::int64_t value, const FieldContext& context) {
    const unsigned bits = context.header.bitsPerPixel;
    if (value > 6)
        return value >= 11 && value <= 13 ? "" : N_("expected 0 to 6");
    if (value == 1 && bits != 8)
        return Sentence("needs 8 bits a pixel, the file has {0}", bits);
    if (value == 2 && bits != 4)
        return Sentence("needs 4 bits a pixel, the file has {0}", bits);
    const bool masks =
        (value == 3 || value == 6) && headerKind(context.header.headerSize) != HeaderKind::Os22;
    return masks && bits != 16 && bits != 32 ? Sentence("needs 16 or 32 bits a pixel, the file has {0}", bits)
                                             : "";
}

// 0 is fine for uncompressed pixels; many writers leave it out, and some count without the padding.
Sentence checkImageSize(std::int64_t value, const FieldContext& context) {
    const Header& header = context.header;
    const bool raw = header.compression == 0 || header.masksPos != 0;
    if (!raw || value == 0 || header.width < 1 || header.height < 1 || header.bitsPerPixel < 1)
        return {};
    const std::uint64_t needed = header.pixelBytes() + header.rowStride() - header.rowBytes();
    return static_cast<std::uint64_t>(value) == needed
               ? ""
               : Sentence("the pixels need {0}", Sentence::plural("{0} byte", "{0} bytes", needed));
}

Sentence checkColorsUsed(std::int64_t value, const FieldContext& context) {
    const unsigned bits = context.header.bitsPerPixel;
    if (bits < 1 || bits > 8 || value <= std::int64_t{1} << bits)
        return {};
    return Sentence("{0} a pixel can index {1} entries", Sentence::plural("{0} bit", "{0} bits", bits),
                    1 << bits);
}

Sentence checkColorsImportant(std::int64_t value, const FieldContext& context) {
    const std::int64_t used = context.header.colorsUsed;
    return used != 0 && value > used ? Sentence("more than the {0} available", used) : "";
}

Sentence checkMask(std::int64_t value, const FieldContext& context) {
    const auto mask = static_cast<std::uint32_t>(value);
    if (context.header.masksPos == 0)
        return {}; // not used
    if (!contiguous(mask))
        return N_("its bits are not contiguous");
    return context.header.bitsPerPixel == 16 && mask > 0xFFFF ? N_("a pixel has 16 bits") : "";
}

constexpr std::array fileFields{
    FieldRow{0, 2, "bfType", N_("the kind of file"), Show::Letters, checkMagic},
    FieldRow{2, 4, "bfSize", N_("size of the file in bytes"), Show::Number, checkFileSize},
    FieldRow{6, 2, "bfReserved1", "", Show::Number, checkZero},
    FieldRow{8, 2, "bfReserved2", "", Show::Number, checkZero},
    FieldRow{10, 4, "bfOffBits", N_("offset of the pixels"), Show::Number, checkDataPos},
};

constexpr std::array coreFields{
    FieldRow{14, 4, "bcSize", N_("size of this header in bytes"), Show::Number, checkHeaderSize},
    FieldRow{18, 2, "bcWidth", N_("pixels in a row"), Show::Number, checkWidth},
    FieldRow{20, 2, "bcHeight", N_("rows"), Show::Number, checkWidth},
    FieldRow{22, 2, "bcPlanes", "", Show::Number, checkPlanes},
    FieldRow{24, 2, "bcBitCount", N_("bits a pixel"), Show::Number, checkBits},
};

// Each longer Windows header begins with the shorter one. The names are the first header's that has a field.
constexpr std::array windowsFields{
    FieldRow{14, 4, "biSize", N_("size of this header in bytes"), Show::Number, checkHeaderSize},
    FieldRow{18, 4, "biWidth", N_("pixels in a row"), Show::Signed, checkWidth},
    FieldRow{22, 4, "biHeight", N_("rows; negative: the top row comes first"), Show::Signed, checkHeight},
    FieldRow{26, 2, "biPlanes", "", Show::Number, checkPlanes},
    FieldRow{28, 2, "biBitCount", N_("bits a pixel"), Show::Number, checkBits},
    FieldRow{30, 4, "biCompression", N_("coding of the pixels"), Show::Compression, checkCompression},
    FieldRow{34, 4, "biSizeImage", N_("size of the pixels in bytes"), Show::Number, checkImageSize},
    FieldRow{38, 4, "biXPelsPerMeter", N_("pixels a metre, across"), Show::Signed},
    FieldRow{42, 4, "biYPelsPerMeter", N_("pixels a metre, up"), Show::Signed},
    FieldRow{46, 4, "biClrUsed", N_("palette entries; 0: as many as the bits can index"), Show::Number,
             checkColorsUsed},
    FieldRow{50, 4, "biClrImportant", N_("important palette entries; 0: all"), Show::Number,
             checkColorsImportant},
    FieldRow{54, 4, "biRedMask", N_("which bits of a pixel are red"), Show::Mask, checkMask},
    FieldRow{58, 4, "biGreenMask", N_("which bits of a pixel are green"), Show::Mask, checkMask},
    FieldRow{62, 4, "biBlueMask", N_("which bits of a pixel are blue"), Show::Mask, checkMask},
    FieldRow{66, 4, "biAlphaMask", N_("which bits of a pixel are alpha; 0: none"), Show::Mask, checkMask},
    FieldRow{70, 4, "bV4CSType", N_("colour space"), Show::ColorSpace},
    FieldRow{74, 4, "bV4RedX", N_("red in CIE XYZ"), Show::Fixed30},
    FieldRow{78, 4, "bV4RedY", "", Show::Fixed30},
    FieldRow{82, 4, "bV4RedZ", "", Show::Fixed30},
    FieldRow{86, 4, "bV4GreenX", N_("green in CIE XYZ"), Show::Fixed30},
    FieldRow{90, 4, "bV4GreenY", "", Show::Fixed30},
    FieldRow{94, 4, "bV4GreenZ", "", Show::Fixed30},
    FieldRow{98, 4, "bV4BlueX", N_("blue in CIE XYZ"), Show::Fixed30},
    FieldRow{102, 4, "bV4BlueY", "", Show::Fixed30},
    FieldRow{106, 4, "bV4BlueZ", "", Show::Fixed30},
    FieldRow{110, 4, "bV4GammaRed", N_("gamma of red"), Show::Fixed16},
    FieldRow{114, 4, "bV4GammaGreen", N_("gamma of green"), Show::Fixed16},
    FieldRow{118, 4, "bV4GammaBlue", N_("gamma of blue"), Show::Fixed16},
    FieldRow{122, 4, "bV5Intent", N_("rendering intent: 1 business, 2 graphics, 4 images, 8 absolute")},
    FieldRow{126, 4, "bV5ProfileData", N_("offset of the profile, from offset 14")},
    FieldRow{130, 4, "bV5ProfileSize", N_("size of the profile in bytes")},
    FieldRow{134, 4, "bV5Reserved", "", Show::Number, checkZero},
};

constexpr std::array os2Fields{
    FieldRow{14, 4, "cbFix", N_("size of this header in bytes"), Show::Number, checkHeaderSize},
    FieldRow{18, 4, "cx", N_("pixels in a row"), Show::Signed, checkWidth},
    FieldRow{22, 4, "cy", N_("rows"), Show::Signed, checkHeight},
    FieldRow{26, 2, "cPlanes", "", Show::Number, checkPlanes},
    FieldRow{28, 2, "cBitCount", N_("bits a pixel"), Show::Number, checkBits},
    FieldRow{30, 4, "ulCompression", N_("coding of the pixels"), Show::Compression, checkCompression},
    FieldRow{34, 4, "cbImage", N_("size of the pixels in bytes"), Show::Number, checkImageSize},
    FieldRow{38, 4, "cxResolution", N_("pixels a metre, across")},
    FieldRow{42, 4, "cyResolution", N_("pixels a metre, up")},
    FieldRow{46, 4, "cclrUsed", N_("palette entries; 0: as many as the bits can index"), Show::Number,
             checkColorsUsed},
    FieldRow{50, 4, "cclrImportant", N_("important palette entries; 0: all"), Show::Number,
             checkColorsImportant},
    FieldRow{54, 2, "usUnits", N_("unit of the resolution; 0: pixels a metre"), Show::Number, checkZero},
    FieldRow{56, 2, "usReserved", "", Show::Number, checkZero},
    FieldRow{58, 2, "usRecording", N_("order of the rows; 0: bottom row first"), Show::Number, checkZero},
    FieldRow{60, 2, "usRendering", N_("halftoning; 0: none")},
    FieldRow{62, 4, "cSize1", N_("of the halftoning")},
    FieldRow{66, 4, "cSize2", N_("of the halftoning")},
    FieldRow{70, 4, "ulColorEncoding", "0: RGB", Show::Number, checkZero},
    FieldRow{74, 4, "ulIdentifier", N_("for the application")},
};

constexpr std::array behindFields{
    FieldRow{54, 4, N_("red mask"), N_("which bits of a pixel are red"), Show::Mask, checkMask},
    FieldRow{58, 4, N_("green mask"), N_("which bits of a pixel are green"), Show::Mask, checkMask},
    FieldRow{62, 4, N_("blue mask"), N_("which bits of a pixel are blue"), Show::Mask, checkMask},
    FieldRow{66, 4, N_("alpha mask"), N_("which bits of a pixel are alpha; 0: none"), Show::Mask, checkMask},
};

static_assert(windowsFields.back().offset + 4 == fileHeaderSize + 124);
static_assert(os2Fields.back().offset + 4 == fileHeaderSize + 64);
static_assert(coreFields.back().offset + 2 == fileHeaderSize + 12);

std::uint32_t numberOf(const FieldRow& row, ByteView file) {
    ByteReader reader(file.subspan(row.offset));
    return row.size == 2 ? reader.u16() : reader.u32();
}

// A mask's width and place: "0x0000f800, 5 bits from bit 11".
Sentence maskText(std::uint32_t mask) {
    if (mask == 0)
        return "0x00000000";
    return Sentence("0x{0:08x}, {1} from bit {2}", mask,
                    Sentence::plural("{0} bit", "{0} bits", std::popcount(mask)), std::countr_zero(mask));
}

std::string letters(ByteView bytes, bool reversed) {
    std::string text;
    for (const std::byte byte : bytes) {
        const auto letter = std::to_integer<char>(byte);
        text += letter >= ' ' && letter <= '~' ? letter : '?';
    }
    if (reversed)
        std::ranges::reverse(text);
    return '"' + text + '"';
}

} // namespace

std::span<const FieldRow> fileHeaderFields() {
    return fileFields;
}

std::span<const FieldRow> infoHeaderFields(std::uint32_t headerSize) {
    switch (headerKind(headerSize)) {
    case HeaderKind::Os21:
        return coreFields;
    case HeaderKind::Os22:
        return os2Fields;
    case HeaderKind::Unknown:
        return std::span(windowsFields).first(1);
    default:
        return windowsFields;
    }
}

std::span<const FieldRow> maskFields() {
    return behindFields;
}

Sentence valueOf(const FieldRow& row, const FieldContext& context) {
    const std::uint32_t value = numberOf(row, context.file);
    const double fixed = static_cast<std::int32_t>(value);
    switch (row.show) {
    case Show::Letters:
        return letters(context.file.subspan(row.offset, row.size), false);
    case Show::Number:
        return std::to_string(value);
    case Show::Signed:
        return std::to_string(static_cast<std::int32_t>(value));
    case Show::Compression:
        return Sentence("{0}, {1}", value, compressionName(value, context.header.headerSize));
    case Show::Mask:
        return maskText(value);
    case Show::ColorSpace: // a number, or four letters that stand last one first
        return value <= 2 ? std::to_string(value) : letters(context.file.subspan(row.offset, row.size), true);
    case Show::Fixed16:
        return fmt::format("{:.5g}", fixed / (1 << 16));
    case Show::Fixed30:
        return fmt::format("{:.5g}", fixed / (1 << 30));
    }
    return {};
}

Sentence wrongOf(const FieldRow& row, const FieldContext& context) {
    if (!row.check)
        return {};
    const std::uint32_t value = numberOf(row, context.file);
    return row.check(row.show == Show::Signed ? std::int64_t{static_cast<std::int32_t>(value)}
                                              : std::int64_t{value},
                     context);
}

std::string hexColor(std::byte red, std::byte green, std::byte blue) {
    return fmt::format("#{:02x}{:02x}{:02x}", red, green, blue);
}

} // namespace texplorer::bmp

#include "texplorer/codec/dds/dds_format.h"

#include "texplorer/base/translatable.h"

#include <algorithm>

namespace texplorer::dds {
namespace {

constexpr std::array fourCCTable{
    FourCCRow{fourCC("DXT1"), BlockFormat::Dxt1, AlphaMeaning::Straight, "DXT1"},
    FourCCRow{fourCC("DXT2"), BlockFormat::Dxt3, AlphaMeaning::Premultiplied, "DXT2"},
    FourCCRow{fourCC("DXT3"), BlockFormat::Dxt3, AlphaMeaning::Straight, "DXT3"},
    FourCCRow{fourCC("DXT4"), BlockFormat::Dxt5, AlphaMeaning::Premultiplied, "DXT4"},
    FourCCRow{fourCC("DXT5"), BlockFormat::Dxt5, AlphaMeaning::Straight, "DXT5"},
    FourCCRow{fourCC("ATI1"), BlockFormat::Bc4, AlphaMeaning::None, "ATI1"},
    FourCCRow{fourCC("BC4U"), BlockFormat::Bc4, AlphaMeaning::None, "BC4U"},
    FourCCRow{fourCC("BC4S"), BlockFormat::Bc4Signed, AlphaMeaning::None, "BC4S"},
    FourCCRow{fourCC("ATI2"), BlockFormat::Bc5, AlphaMeaning::None, "ATI2"},
    FourCCRow{fourCC("BC5U"), BlockFormat::Bc5, AlphaMeaning::None, "BC5U"},
    FourCCRow{fourCC("BC5S"), BlockFormat::Bc5Signed, AlphaMeaning::None, "BC5S"},
};

constexpr MaskedPixels rgba8{32, {0xFF, 0xFF00, 0xFF0000, 0xFF000000}, PixelFormat::Rgba8};
constexpr MaskedPixels bgra8{32, {0xFF0000, 0xFF00, 0xFF, 0xFF000000}, PixelFormat::Rgba8};
constexpr MaskedPixels bgrx8{32, {0xFF0000, 0xFF00, 0xFF, 0}, PixelFormat::Rgb8};
constexpr MaskedPixels rgb10a2{32, {0x3FF, 0xFFC00, 0x3FF00000, 0xC0000000}, PixelFormat::Rgba8};
constexpr MaskedPixels rg16{32, {0xFFFF, 0xFFFF0000, 0, 0}, PixelFormat::Rgb8};
constexpr MaskedPixels rg8{16, {0xFF, 0xFF00, 0, 0}, PixelFormat::Rgb8};
// Red alone is shown as grey, as BC4 is.
constexpr MaskedPixels r16{16, {0xFFFF, 0, 0, 0}, PixelFormat::Luminance8};
constexpr MaskedPixels r8{8, {0xFF, 0, 0, 0}, PixelFormat::Luminance8};
constexpr MaskedPixels a8{8, {0, 0, 0, 0xFF}, PixelFormat::Alpha8};
constexpr MaskedPixels b5g6r5{16, {0xF800, 0x7E0, 0x1F, 0}, PixelFormat::Rgb8};
constexpr MaskedPixels b5g5r5a1{16, {0x7C00, 0x3E0, 0x1F, 0x8000}, PixelFormat::Rgba8};
constexpr MaskedPixels b4g4r4a4{16, {0xF00, 0xF0, 0xF, 0xF000}, PixelFormat::Rgba8};
constexpr MaskedPixels a4b4g4r4{16, {0xF000, 0xF00, 0xF0, 0xF}, PixelFormat::Rgba8};
constexpr UnreadPixels unreadBlocks{16, 4};

constexpr std::array dxgiTable{
    DxgiRow{2, "DXGI_FORMAT_R32G32B32A32_FLOAT", UnreadPixels{16, 1}, false},
    DxgiRow{6, "DXGI_FORMAT_R32G32B32_FLOAT", UnreadPixels{12, 1}, false},
    DxgiRow{10, "DXGI_FORMAT_R16G16B16A16_FLOAT", UnreadPixels{8, 1}, false},
    DxgiRow{11, "DXGI_FORMAT_R16G16B16A16_UNORM", UnreadPixels{8, 1}, false},
    DxgiRow{13, "DXGI_FORMAT_R16G16B16A16_SNORM", UnreadPixels{8, 1}, false},
    DxgiRow{16, "DXGI_FORMAT_R32G32_FLOAT", UnreadPixels{8, 1}, false},
    DxgiRow{23, "DXGI_FORMAT_R10G10B10A2_TYPELESS", rgb10a2, false},
    DxgiRow{24, "DXGI_FORMAT_R10G10B10A2_UNORM", rgb10a2, false},
    DxgiRow{26, "DXGI_FORMAT_R11G11B10_FLOAT", UnreadPixels{4, 1}, false},
    DxgiRow{27, "DXGI_FORMAT_R8G8B8A8_TYPELESS", rgba8, false},
    DxgiRow{28, "DXGI_FORMAT_R8G8B8A8_UNORM", rgba8, false},
    DxgiRow{29, "DXGI_FORMAT_R8G8B8A8_UNORM_SRGB", rgba8, true},
    DxgiRow{31, "DXGI_FORMAT_R8G8B8A8_SNORM", UnreadPixels{4, 1}, false},
    DxgiRow{33, "DXGI_FORMAT_R16G16_TYPELESS", rg16, false},
    DxgiRow{34, "DXGI_FORMAT_R16G16_FLOAT", UnreadPixels{4, 1}, false},
    DxgiRow{35, "DXGI_FORMAT_R16G16_UNORM", rg16, false},
    DxgiRow{41, "DXGI_FORMAT_R32_FLOAT", UnreadPixels{4, 1}, false},
    DxgiRow{48, "DXGI_FORMAT_R8G8_TYPELESS", rg8, false},
    DxgiRow{49, "DXGI_FORMAT_R8G8_UNORM", rg8, false},
    DxgiRow{51, "DXGI_FORMAT_R8G8_SNORM", UnreadPixels{2, 1}, false},
    DxgiRow{53, "DXGI_FORMAT_R16_TYPELESS", r16, false},
    DxgiRow{54, "DXGI_FORMAT_R16_FLOAT", UnreadPixels{2, 1}, false},
    DxgiRow{56, "DXGI_FORMAT_R16_UNORM", r16, false},
    DxgiRow{60, "DXGI_FORMAT_R8_TYPELESS", r8, false},
    DxgiRow{61, "DXGI_FORMAT_R8_UNORM", r8, false},
    DxgiRow{63, "DXGI_FORMAT_R8_SNORM", UnreadPixels{1, 1}, false},
    DxgiRow{65, "DXGI_FORMAT_A8_UNORM", a8, false},
    DxgiRow{67, "DXGI_FORMAT_R9G9B9E5_SHAREDEXP", UnreadPixels{4, 1}, false},
    DxgiRow{70, "DXGI_FORMAT_BC1_TYPELESS", BlockFormat::Dxt1, false},
    DxgiRow{71, "DXGI_FORMAT_BC1_UNORM", BlockFormat::Dxt1, false},
    DxgiRow{72, "DXGI_FORMAT_BC1_UNORM_SRGB", BlockFormat::Dxt1, true},
    DxgiRow{73, "DXGI_FORMAT_BC2_TYPELESS", BlockFormat::Dxt3, false},
    DxgiRow{74, "DXGI_FORMAT_BC2_UNORM", BlockFormat::Dxt3, false},
    DxgiRow{75, "DXGI_FORMAT_BC2_UNORM_SRGB", BlockFormat::Dxt3, true},
    DxgiRow{76, "DXGI_FORMAT_BC3_TYPELESS", BlockFormat::Dxt5, false},
    DxgiRow{77, "DXGI_FORMAT_BC3_UNORM", BlockFormat::Dxt5, false},
    DxgiRow{78, "DXGI_FORMAT_BC3_UNORM_SRGB", BlockFormat::Dxt5, true},
    DxgiRow{79, "DXGI_FORMAT_BC4_TYPELESS", BlockFormat::Bc4, false},
    DxgiRow{80, "DXGI_FORMAT_BC4_UNORM", BlockFormat::Bc4, false},
    DxgiRow{81, "DXGI_FORMAT_BC4_SNORM", BlockFormat::Bc4Signed, false},
    DxgiRow{82, "DXGI_FORMAT_BC5_TYPELESS", BlockFormat::Bc5, false},
    DxgiRow{83, "DXGI_FORMAT_BC5_UNORM", BlockFormat::Bc5, false},
    DxgiRow{84, "DXGI_FORMAT_BC5_SNORM", BlockFormat::Bc5Signed, false},
    DxgiRow{85, "DXGI_FORMAT_B5G6R5_UNORM", b5g6r5, false},
    DxgiRow{86, "DXGI_FORMAT_B5G5R5A1_UNORM", b5g5r5a1, false},
    DxgiRow{87, "DXGI_FORMAT_B8G8R8A8_UNORM", bgra8, false},
    DxgiRow{88, "DXGI_FORMAT_B8G8R8X8_UNORM", bgrx8, false},
    DxgiRow{90, "DXGI_FORMAT_B8G8R8A8_TYPELESS", bgra8, false},
    DxgiRow{91, "DXGI_FORMAT_B8G8R8A8_UNORM_SRGB", bgra8, true},
    DxgiRow{92, "DXGI_FORMAT_B8G8R8X8_TYPELESS", bgrx8, false},
    DxgiRow{93, "DXGI_FORMAT_B8G8R8X8_UNORM_SRGB", bgrx8, true},
    DxgiRow{95, "DXGI_FORMAT_BC6H_UF16", unreadBlocks, false},
    DxgiRow{96, "DXGI_FORMAT_BC6H_SF16", unreadBlocks, false},
    DxgiRow{97, "DXGI_FORMAT_BC7_TYPELESS", unreadBlocks, false},
    DxgiRow{98, "DXGI_FORMAT_BC7_UNORM", unreadBlocks, false},
    DxgiRow{99, "DXGI_FORMAT_BC7_UNORM_SRGB", unreadBlocks, true},
    DxgiRow{115, "DXGI_FORMAT_B4G4R4A4_UNORM", b4g4r4a4, false},
    DxgiRow{191, "DXGI_FORMAT_A4B4G4R4_UNORM", a4b4g4r4, false},
};

static_assert(std::ranges::is_sorted(dxgiTable, {}, &DxgiRow::number));

tl::unexpected<Error> unsupported(const Sentence& message) {
    return fail(ErrorCode::Unsupported, Sentence("DDS: {0}", message));
}

bool mayHaveAlpha(const Format& format) {
    if (const BlockFormat* block = std::get_if<BlockFormat>(&format.pixels))
        return *block == BlockFormat::Dxt1 || *block == BlockFormat::Dxt3 || *block == BlockFormat::Dxt5;
    const MaskedPixels* masked = std::get_if<MaskedPixels>(&format.pixels);
    return masked != nullptr && masked->masks[3] != 0;
}

AlphaMeaning alphaMeaning(std::uint32_t mode, Findings& findings) {
    switch (mode) {
    case alphaStraight:
        return AlphaMeaning::Straight;
    case alphaPremultiplied:
        return AlphaMeaning::Premultiplied;
    case alphaOpaque:
        return AlphaMeaning::None;
    case alphaUnknown:
    case alphaCustom:
        return AlphaMeaning::Unknown;
    default:
        findings.push_back(
            {at::miscFlags2,
             Sentence("miscFlags2 has alpha mode {0}, which doesn't exist; the meaning of alpha is "
                      "unknown",
                      mode)});
        return AlphaMeaning::Unknown;
    }
}

Result<Format> fromDxgi(const Header& header, Findings& findings) {
    const DxgiRow* row = findDxgi(header.dxgiFormat);
    constexpr std::uint32_t maxDxgi = 191; // 0 is DXGI_FORMAT_UNKNOWN
    if (header.dxgiFormat == 0 || header.dxgiFormat > maxDxgi)
        return fail(ErrorCode::Malformed, Sentence("DDS: DXGI formats are 1 to {0}, dxgiFormat is {1}",
                                                   maxDxgi, header.dxgiFormat));
    if (row == nullptr)
        return unsupported(Sentence(
            "DXGI format {0} is not read; BC1 to BC5 and unsigned formats of at most 32 bits a pixel are",
            header.dxgiFormat));
    if (row->name.ends_with("_TYPELESS"))
        findings.push_back({at::dxgiFormat,
                            Sentence("{0} does not define its bits; read as UNORM", ProperName{row->name}),
                            false});
    Format format{row->name, row->pixels, row->srgb, AlphaMeaning::None};
    const AlphaMeaning said = alphaMeaning(header.miscFlags2 & alphaModeMask, findings);
    if (mayHaveAlpha(format))
        format.alpha = said;
    return format;
}

Result<Format> fromFourCC(const Header& header, Findings& findings) {
    if ((header.formatFlags & formatFourCC) == 0)
        findings.push_back(
            {at::formatFlags, Sentence("DDPF_FOURCC is not set although dwFourCC is {0}; dwFourCC is used",
                                       ProperName{spellFourCC(header.fourCC)})});
    if (header.extended())
        return fromDxgi(header, findings);
    const auto row = std::ranges::find(fourCCTable, header.fourCC, &FourCCRow::code);
    if (row == fourCCTable.end()) {
        std::string known;
        for (const FourCCRow& each : fourCCTable)
            known.append(each.name).append(", ");
        return unsupported(
            Sentence("dwFourCC is {0}; {1}DX10 are read", ProperName{spellFourCC(header.fourCC)}, known));
    }
    if (row->alpha == AlphaMeaning::Premultiplied)
        findings.push_back(
            {at::fourCC, Sentence("{0}: the colours are multiplied by alpha", ProperName{row->name}), false});
    return Format{row->name, row->format, false, row->alpha};
}

/// The channels' names as the masks' fields are called.
constexpr std::array<std::string_view, 4> maskNames{"dwRBitMask", "dwGBitMask", "dwBBitMask", "dwABitMask"};

/// D3DX writes A2B10G10R10, red in the low bits, with the masks of A2R10G10B10. Readers allow for it, because
/// that format itself was rarely written. The opposite order is read as it says.
void swapMasksOfD3dx(MaskedPixels& pixels, Findings& findings) {
    constexpr std::array<std::uint32_t, 4> reversed{0x3FF00000, 0xFFC00, 0x3FF, 0xC0000000};
    if (pixels.masks != reversed)
        return;
    std::swap(pixels.masks[0], pixels.masks[2]);
    findings.push_back(
        {at::masks, N_("the masks of red and blue are swapped, as D3DX writes them for 10:10:10:2; red is "
                       "read from the low bits")});
}

/// Of depth with or without stencil: the second mask is the depth's.
Result<Format> depthFormat(MaskedPixels pixels) {
    if (pixels.masks[1] == 0)
        return fail(ErrorCode::Malformed,
                    "DDS: DDPF_ZBUFFER is set, but the mask of the depth, dwGBitMask, is 0");
    pixels.decoded = PixelFormat::Luminance8;
    pixels.masks = {pixels.masks[1], 0, 0, 0};
    return Format{N_("depth"), pixels, false, AlphaMeaning::None};
}

Result<Format> fromMasks(const Header& header, Findings& findings) {
    const std::uint32_t flags = header.formatFlags;
    if (header.bitCount != 8 && header.bitCount != 16 && header.bitCount != 24 && header.bitCount != 32)
        return unsupported(
            Sentence("8, 16, 24 or 32 bits a pixel are read, dwRGBBitCount is {0}", header.bitCount));
    const std::uint32_t all = 0xFFFFFFFFU >> (32 - header.bitCount);
    MaskedPixels pixels{static_cast<int>(header.bitCount), header.masks, PixelFormat::Rgba8};
    for (std::size_t i = 0; i < 4; ++i) {
        if ((pixels.masks[i] & ~all) != 0)
            findings.push_back(
                {at::masks + 4 * i,
                 Sentence("{0} is {1}, beyond the {2} bits of a pixel; those bits are ignored",
                          ProperName{maskNames[i]}, ProperName{hex(pixels.masks[i])}, header.bitCount)});
        pixels.masks[i] &= all;
    }

    if ((flags & formatZBuffer) != 0)
        return depthFormat(pixels);
    bool alpha = (flags & formatAlphaPixels) != 0;
    if (alpha && pixels.masks[3] == 0) {
        findings.push_back(
            {at::formatFlags, N_("DDPF_ALPHAPIXELS is set, but dwABitMask is 0; read without alpha")});
        alpha = false;
    }
    const bool alphaAlone = (flags & formatAlpha) != 0 && (flags & (formatRgb | formatLuminance)) == 0;
    if (!alpha && !alphaAlone && pixels.masks[3] != 0) {
        findings.push_back(
            {at::formatFlags,
             Sentence("DDPF_ALPHAPIXELS is not set although dwABitMask is {0}; read without alpha",
                      ProperName{hex(pixels.masks[3])})});
        pixels.masks[3] = 0;
    }

    std::string_view name = "RGB";
    if (alphaAlone) {
        name = N_("alpha");
        pixels.decoded = PixelFormat::Alpha8;
        pixels.masks = {0, 0, 0, pixels.masks[3] == 0 ? all : pixels.masks[3]};
        if (header.masks[3] == 0)
            findings.push_back({at::masks + 12, N_("dwABitMask is 0; all bits of a pixel are its alpha")});
    } else if ((flags & formatLuminance) != 0) {
        name = alpha ? N_("luminance and alpha") : N_("luminance");
        pixels.decoded = alpha ? PixelFormat::LuminanceAlpha8 : PixelFormat::Luminance8;
        pixels.masks[1] = pixels.masks[2] = 0; // some writers repeat the mask
        if (pixels.masks[0] == 0) {
            pixels.masks[0] = all & ~pixels.masks[3];
            findings.push_back({at::masks, N_("dwRBitMask is 0; all bits but alpha's are the luminance")});
        }
    } else {
        name = alpha ? "RGBA" : "RGB";
        pixels.decoded = alpha ? PixelFormat::Rgba8 : PixelFormat::Rgb8;
        if ((pixels.masks[0] | pixels.masks[1] | pixels.masks[2]) == 0)
            return fail(ErrorCode::Malformed, "DDS: the masks of red, green and blue are all 0");
        if ((flags & formatRgb) == 0)
            findings.push_back({at::formatFlags, N_("neither DDPF_RGB nor another kind of pixel is set; the "
                                                    "masks are used as RGB")});
        swapMasksOfD3dx(pixels, findings);
    }
    AlphaMeaning meaning = alpha || alphaAlone ? AlphaMeaning::Straight : AlphaMeaning::None;
    if (alpha && (flags & formatAlphaPremultiplied) != 0)
        meaning = AlphaMeaning::Premultiplied;
    return Format{name, pixels, false, meaning};
}

std::uint64_t texels(int width, int height, int depth) {
    return static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height) *
           static_cast<std::uint64_t>(depth);
}

} // namespace

std::uint64_t Format::surfaceBytes(int width, int height, int depth) const {
    if (const BlockFormat* block = std::get_if<BlockFormat>(&pixels))
        return texels((width + 3) / 4, (height + 3) / 4, depth) * bytesPerBlock(*block);
    if (const UnreadPixels* unread = std::get_if<UnreadPixels>(&pixels)) {
        const auto units = [&](int extent) { return (extent + unread->extent - 1) / unread->extent; };
        return texels(units(width), units(height), depth) * static_cast<std::uint64_t>(unread->bytes);
    }
    return texels(width, height, depth) * std::get<MaskedPixels>(pixels).bytes();
}

std::uint64_t Format::decodedBytes(int width, int height, int depth) const {
    if (const MaskedPixels* masked = std::get_if<MaskedPixels>(&pixels))
        return texels(width, height, depth) * static_cast<std::uint64_t>(bytesPerPixel(masked->decoded));
    return surfaceBytes(width, height, depth);
}

std::span<const FourCCRow> fourCCRows() {
    return fourCCTable;
}

std::span<const DxgiRow> dxgiRows() {
    return dxgiTable;
}

const DxgiRow* findDxgi(std::uint32_t number) {
    const auto found = std::ranges::find(dxgiTable, number, &DxgiRow::number);
    return found == dxgiTable.end() ? nullptr : &*found;
}

Result<Format> formatOf(const Header& header, Findings& findings) {
    if (header.formatSize != formatSize)
        findings.push_back(
            {at::formatSize,
             Sentence("ddspf.dwSize is {0} where 32 is expected; it is ignored", header.formatSize)});
    if (header.hasFourCC())
        return fromFourCC(header, findings);
    if ((header.formatFlags & formatUnread) != 0)
        return unsupported(
            Sentence("pixels with {0} are not read; RGB, luminance, alpha, depth and compressed ones are",
                     ProperName{spellBits(header.formatFlags & formatUnread, formatFlagRows)}));
    if ((header.formatFlags & formatFourCC) != 0)
        findings.push_back(
            {at::formatFlags, N_("DDPF_FOURCC is set, but dwFourCC is 0; the masks are used instead")});
    return fromMasks(header, findings);
}

} // namespace texplorer::dds

#pragma once

// The header of a DDS file, and the names of its bits. dds_format.h and dds_layout.h interpret it. Source:
// Microsoft's "Programming Guide for DDS".

#include "texplorer/base/bytes.h"
#include "texplorer/base/sentence.h"

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace texplorer::dds {

inline constexpr std::size_t legacyEnd = 128;    ///< where the pixels begin
inline constexpr std::size_t extendedEnd = 148;  ///< or here, after a DX10 header
inline constexpr std::uint32_t headerSize = 124; ///< without the magic number
inline constexpr std::uint32_t formatSize = 32;  ///< of the pixel format in it

/// A four-character code as a number, as in the file.
[[nodiscard]] constexpr std::uint32_t fourCC(const char (&text)[5]) {
    std::uint32_t code = 0;
    for (unsigned i = 0; i < 4; ++i)
        code |= static_cast<std::uint32_t>(static_cast<unsigned char>(text[i])) << (8 * i);
    return code;
}

/// The offset of each field from the beginning of the file; findings name their field by it.
namespace at {
inline constexpr std::size_t size = 4;
inline constexpr std::size_t flags = 8;
inline constexpr std::size_t height = 12;
inline constexpr std::size_t width = 16;
inline constexpr std::size_t pitchOrLinearSize = 20;
inline constexpr std::size_t depth = 24;
inline constexpr std::size_t mipMapCount = 28;
inline constexpr std::size_t reserved = 32;
inline constexpr std::size_t formatSize = 76;
inline constexpr std::size_t formatFlags = 80;
inline constexpr std::size_t fourCC = 84;
inline constexpr std::size_t bitCount = 88;
inline constexpr std::size_t masks = 92; ///< red, green, blue, alpha
inline constexpr std::size_t caps = 108;
inline constexpr std::size_t caps2 = 112;
inline constexpr std::size_t caps3 = 116;
inline constexpr std::size_t caps4 = 120;
inline constexpr std::size_t reserved2 = 124;
inline constexpr std::size_t dxgiFormat = 128;
inline constexpr std::size_t dimension = 132;
inline constexpr std::size_t miscFlag = 136;
inline constexpr std::size_t arraySize = 140;
inline constexpr std::size_t miscFlags2 = 144;
} // namespace at

struct Header {
    std::uint32_t size = headerSize;
    std::uint32_t flags = 0;
    std::uint32_t height = 0;
    std::uint32_t width = 0;
    std::uint32_t pitchOrLinearSize = 0;
    std::uint32_t depth = 0;
    std::uint32_t mipMapCount = 0;

    std::uint32_t formatSize = dds::formatSize;
    std::uint32_t formatFlags = 0;
    std::uint32_t fourCC = 0;
    std::uint32_t bitCount = 0;
    std::array<std::uint32_t, 4> masks{}; ///< red, green, blue, alpha

    std::uint32_t caps = 0;
    std::uint32_t caps2 = 0;

    // The DX10 header; 0 without one.
    std::uint32_t dxgiFormat = 0;
    std::uint32_t dimension = 0;
    std::uint32_t miscFlag = 0;
    std::uint32_t arraySize = 0;
    std::uint32_t miscFlags2 = 0;

    /// Whether dwFourCC defines the pixels: it is not 0, and its flag is set or no other one is.
    [[nodiscard]] bool hasFourCC() const;
    [[nodiscard]] bool extended() const; ///< whether a DX10 header follows
    [[nodiscard]] std::size_t end() const { return extended() ? extendedEnd : legacyEnd; }
};

/// Fields beyond the end of the file are 0.
[[nodiscard]] Header readHeader(ByteView file);

/// Returns the magic number and the headers: header.end() bytes.
[[nodiscard]] Bytes writeHeader(const Header& header);

/// A tolerated contradiction between the header and the rest of the file.
struct Finding {
    std::uint64_t offset; ///< of the field, as in `at`
    Sentence sentence;
    bool isFault = true; ///< false: valid, but ignored
};
using Findings = std::vector<Finding>;

/// A bit, or a value of a field that holds one of several.
struct NameRow {
    std::uint32_t value;
    std::string_view name;
    std::string_view meaning;
};

enum Flags : std::uint32_t {
    flagCaps = 0x1,
    flagHeight = 0x2,
    flagWidth = 0x4,
    flagPitch = 0x8,
    flagPixelFormat = 0x1000,
    flagMipMapCount = 0x20000,
    flagLinearSize = 0x80000,
    flagDepth = 0x800000,
};

inline constexpr std::array flagRows{
    NameRow{flagCaps, "DDSD_CAPS", N_("dwCaps is set")},
    NameRow{flagHeight, "DDSD_HEIGHT", N_("dwHeight is set")},
    NameRow{flagWidth, "DDSD_WIDTH", N_("dwWidth is set")},
    NameRow{flagPitch, "DDSD_PITCH", N_("dwPitchOrLinearSize is the bytes of a row")},
    NameRow{flagPixelFormat, "DDSD_PIXELFORMAT", N_("ddspf is set")},
    NameRow{flagMipMapCount, "DDSD_MIPMAPCOUNT", N_("dwMipMapCount is set")},
    NameRow{flagLinearSize, "DDSD_LINEARSIZE", N_("dwPitchOrLinearSize is the bytes of level 0")},
    NameRow{flagDepth, "DDSD_DEPTH", N_("dwDepth is set: a volume")},
};

enum FormatFlags : std::uint32_t {
    formatAlphaPixels = 0x1,
    formatAlpha = 0x2,
    formatFourCC = 0x4,
    formatPalette4 = 0x8,
    formatPaletteTo8 = 0x10,
    formatPalette8 = 0x20,
    formatRgb = 0x40,
    formatYuv = 0x200,
    formatZBuffer = 0x400,
    formatPalette1 = 0x800,
    formatPalette2 = 0x1000,
    formatAlphaPremultiplied = 0x8000,
    formatLuminance = 0x20000,
    formatBumpLuminance = 0x40000,
    formatBump = 0x80000,
};

/// The unsupported kinds of pixels.
inline constexpr std::uint32_t formatUnread = formatPalette1 | formatPalette2 | formatPalette4 |
                                              formatPalette8 | formatPaletteTo8 | formatYuv |
                                              formatBumpLuminance | formatBump;

inline constexpr std::array formatFlagRows{
    NameRow{formatAlphaPixels, "DDPF_ALPHAPIXELS", N_("pixels have alpha")},
    NameRow{formatAlpha, "DDPF_ALPHA", N_("pixels are alpha alone")},
    NameRow{formatFourCC, "DDPF_FOURCC", N_("dwFourCC is the format")},
    NameRow{formatPalette4, "DDPF_PALETTEINDEXED4", N_("4-bit palette indices")},
    NameRow{formatPaletteTo8, "DDPF_PALETTEINDEXEDTO8", N_("indices of a palette of 8-bit indices")},
    NameRow{formatPalette8, "DDPF_PALETTEINDEXED8", N_("8-bit palette indices")},
    NameRow{formatRgb, "DDPF_RGB", N_("red, green and blue by masks")},
    NameRow{formatYuv, "DDPF_YUV", N_("luma and chroma")},
    NameRow{formatZBuffer, "DDPF_ZBUFFER", N_("depth by the green mask")},
    NameRow{formatPalette1, "DDPF_PALETTEINDEXED1", N_("1-bit palette indices")},
    NameRow{formatPalette2, "DDPF_PALETTEINDEXED2", N_("2-bit palette indices")},
    NameRow{formatAlphaPremultiplied, "DDPF_ALPHAPREMULT", N_("colours are multiplied by alpha")},
    NameRow{formatLuminance, "DDPF_LUMINANCE", N_("luminance by the red mask")},
    NameRow{formatBumpLuminance, "DDPF_BUMPLUMINANCE", N_("a bump map with luminance")},
    NameRow{formatBump, "DDPF_BUMPDUDV", N_("a bump map of signed numbers")},
};

enum Caps : std::uint32_t { capsComplex = 0x8, capsTexture = 0x1000, capsMipMap = 0x400000 };

inline constexpr std::array capsRows{
    NameRow{capsComplex, "DDSCAPS_COMPLEX", N_("more than one surface")},
    NameRow{capsTexture, "DDSCAPS_TEXTURE", N_("a texture")},
    NameRow{capsMipMap, "DDSCAPS_MIPMAP", N_("mip levels")},
};

enum Caps2 : std::uint32_t {
    caps2CubeMap = 0x200,
    caps2AllFaces = 0xFC00,
    caps2Volume = 0x200000,
};

inline constexpr std::array caps2Rows{
    NameRow{caps2CubeMap, "DDSCAPS2_CUBEMAP", N_("a cube map")},
    NameRow{0x400, "DDSCAPS2_CUBEMAP_POSITIVEX", N_("face +x")},
    NameRow{0x800, "DDSCAPS2_CUBEMAP_NEGATIVEX", N_("face -x")},
    NameRow{0x1000, "DDSCAPS2_CUBEMAP_POSITIVEY", N_("face +y")},
    NameRow{0x2000, "DDSCAPS2_CUBEMAP_NEGATIVEY", N_("face -y")},
    NameRow{0x4000, "DDSCAPS2_CUBEMAP_POSITIVEZ", N_("face +z")},
    NameRow{0x8000, "DDSCAPS2_CUBEMAP_NEGATIVEZ", N_("face -z")},
    NameRow{caps2Volume, "DDSCAPS2_VOLUME", N_("a volume")},
};

enum Dimension : std::uint32_t { dimension1D = 2, dimension2D = 3, dimension3D = 4 };

inline constexpr std::array dimensionRows{
    NameRow{0, "D3D10_RESOURCE_DIMENSION_UNKNOWN", N_("not specified")},
    NameRow{1, "D3D10_RESOURCE_DIMENSION_BUFFER", N_("no texture at all")},
    NameRow{dimension1D, "D3D10_RESOURCE_DIMENSION_TEXTURE1D", N_("a line")},
    NameRow{dimension2D, "D3D10_RESOURCE_DIMENSION_TEXTURE2D", N_("a picture or a cube map")},
    NameRow{dimension3D, "D3D10_RESOURCE_DIMENSION_TEXTURE3D", N_("a volume")},
};

inline constexpr std::uint32_t miscTextureCube = 0x4;

inline constexpr std::array miscRows{
    NameRow{miscTextureCube, "DDS_RESOURCE_MISC_TEXTURECUBE", N_("a cube map")},
};

enum AlphaMode : std::uint32_t {
    alphaUnknown = 0,
    alphaStraight = 1,
    alphaPremultiplied = 2,
    alphaOpaque = 3,
    alphaCustom = 4,
};
inline constexpr std::uint32_t alphaModeMask = 7; ///< the bits of miscFlags2 with the alpha mode

inline constexpr std::array alphaModeRows{
    NameRow{alphaUnknown, "DDS_ALPHA_MODE_UNKNOWN", N_("the meaning of alpha is not specified")},
    NameRow{alphaStraight, "DDS_ALPHA_MODE_STRAIGHT", N_("colours do not depend on alpha")},
    NameRow{alphaPremultiplied, "DDS_ALPHA_MODE_PREMULTIPLIED", N_("colours are multiplied by alpha")},
    NameRow{alphaOpaque, "DDS_ALPHA_MODE_OPAQUE", N_("alpha is 1 everywhere")},
    NameRow{alphaCustom, "DDS_ALPHA_MODE_CUSTOM", N_("the fourth component is not alpha")},
};

/// "DDSD_CAPS | DDSD_WIDTH | 0x40"; "0" where no bit is set.
[[nodiscard]] std::string spellBits(std::uint32_t bits, std::span<const NameRow> rows);

/// "0x00FF0000"
[[nodiscard]] std::string hex(std::uint32_t value);

/// "DXT1" in quotation marks if all four characters are printable, else hex.
[[nodiscard]] std::string spellFourCC(std::uint32_t code);

} // namespace texplorer::dds

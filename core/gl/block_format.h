#pragma once

// Formats that store 4 x 4 texels in a block of 8 or 16 bytes: EXT_texture_compression_s3tc and
// ARB_texture_compression_rgtc.

#include "texplorer/gl/environment.h"

#include <cstddef>

namespace texplorer {

enum class BlockFormat : std::uint32_t {
    Dxt1 = 0x83F0,
    Dxt1Alpha = 0x83F1,
    Dxt3 = 0x83F2,
    Dxt5 = 0x83F3,
    Bc4 = 0x8DBB,
    Bc4Signed = 0x8DBC,
    Bc5 = 0x8DBD,
    Bc5Signed = 0x8DBE,
};

inline constexpr std::array blockFormatRows{
    row(BlockFormat::Dxt1, "GL_COMPRESSED_RGB_S3TC_DXT1_EXT", "DXT1",
        "Two 5:6:5 colours and two between them, 2 bits a texel: 4 bits a texel in all, no alpha.",
        "GL_EXT_texture_compression_s3tc"),
    row(BlockFormat::Dxt1Alpha, "GL_COMPRESSED_RGBA_S3TC_DXT1_EXT", "DXT1 with 1-bit alpha",
        "As DXT1. Blocks whose first colour is not the larger one have a transparent black.",
        "GL_EXT_texture_compression_s3tc"),
    row(BlockFormat::Dxt3, "GL_COMPRESSED_RGBA_S3TC_DXT3_EXT", "DXT3",
        "Four bits of alpha a texel before the colours: sharp alpha in 16 steps.",
        "GL_EXT_texture_compression_s3tc"),
    row(BlockFormat::Dxt5, "GL_COMPRESSED_RGBA_S3TC_DXT5_EXT", "DXT5",
        "Two alphas and six between them before the colours: smooth alpha.",
        "GL_EXT_texture_compression_s3tc"),
    row(BlockFormat::Bc4, "GL_COMPRESSED_RED_RGTC1", "BC4",
        "One channel, two values and six between them: 4 bits a texel. Also called ATI1.", "3.0"),
    row(BlockFormat::Bc4Signed, "GL_COMPRESSED_SIGNED_RED_RGTC1", "BC4, signed",
        "BC4 with values from -1 to 1.", "3.0"),
    row(BlockFormat::Bc5, "GL_COMPRESSED_RG_RGTC2", "BC5",
        "Two channels, each a BC4 block: for normal maps. Also called ATI2.", "3.0"),
    row(BlockFormat::Bc5Signed, "GL_COMPRESSED_SIGNED_RG_RGTC2", "BC5, signed",
        "BC5 with values from -1 to 1.", "3.0"),
};

template<>
struct EnumTable<BlockFormat> {
    static constexpr std::span<const EnumRow> rows = blockFormatRows;
};

static_assert(blockFormatRows.size() == 8);

/// DXT1, DXT3 and DXT5, unlike the formats of one and two channels (RGTC).
[[nodiscard]] constexpr bool isS3tc(BlockFormat format) {
    return format == BlockFormat::Dxt1 || format == BlockFormat::Dxt1Alpha || format == BlockFormat::Dxt3 ||
           format == BlockFormat::Dxt5;
}

/// The base internal format (OpenGL 2.1, table 3.17 and the extensions' tables). The formats of one and two
/// channels have only the red and green of RGB.
[[nodiscard]] constexpr BaseFormat baseFormat(BlockFormat format) {
    return isS3tc(format) && format != BlockFormat::Dxt1 ? BaseFormat::Rgba : BaseFormat::Rgb;
}

/// How many of red, green, blue and alpha a format stores.
[[nodiscard]] constexpr std::size_t keptComponents(BlockFormat format) {
    if (isS3tc(format))
        return baseFormat(format) == BaseFormat::Rgb ? 3 : 4;
    return format == BlockFormat::Bc4 || format == BlockFormat::Bc4Signed ? 1 : 2;
}

/// 8 for DXT1 and BC4, else 16.
[[nodiscard]] constexpr std::size_t bytesPerBlock(BlockFormat format) {
    return format == BlockFormat::Dxt1 || format == BlockFormat::Dxt1Alpha || format == BlockFormat::Bc4 ||
                   format == BlockFormat::Bc4Signed
               ? 8
               : 16;
}

} // namespace texplorer

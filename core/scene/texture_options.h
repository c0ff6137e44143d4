#pragma once

// How a texture's image becomes what is uploaded: which way up, and compressed how.

#include "core/gl/block_format.h"
#include "core/s3tc/encode_quality.h"

namespace texplorer {

enum class FlipMode : std::uint32_t { Blocks, Pixels, Coordinates, Matrix, None };

inline constexpr std::array flipModeRows{
    row(FlipMode::Blocks, "blocks", "Blocks, lossless",
        "When it is loaded: compressed blocks are turned around without decompressing them, pixels where the "
        "file isn't compressed. Where a level's height makes that impossible, the texture is decompressed."),
    row(FlipMode::Pixels, "pixels", "Pixels",
        "When it is loaded: the rows of pixels are exchanged. A compressed file is decompressed for it."),
    row(FlipMode::Coordinates, "coordinates", "Coordinates",
        "The image stays as the file has it and every vertex gets 1 - t for t; the texture matrix then works "
        "on the flipped coordinates."),
    row(FlipMode::Matrix, "matrix", "Texture matrix",
        "The image stays as the file has it; the texture matrix begins with t -> 1 - t (glTranslatef(0, 1, "
        "0), "
        "glScalef(1, -1, 1))."),
    row(FlipMode::None, "none", "None",
        "The file's first row becomes row 0, the bottom one for OpenGL: upside down where the file begins at "
        "the top, as most formats do."),
};

enum class Compression : std::uint32_t { FromFile, None, Driver, Cached };

inline constexpr std::array compressionRows{
    row(Compression::FromFile, "file", "As in the file",
        "Blocks of a DDS file go to OpenGL as they are, level by level (glCompressedTexImage2D); everything "
        "else is not compressed."),
    row(Compression::None, "none", "None", "Eight bits a component; compressed files are decompressed."),
    row(Compression::Driver, "driver", "By the driver",
        "glTexImage2D with a compressed internal format: the driver compresses while it uploads, quickly."),
    row(Compression::Cached, "cached", "Run time, cached",
        "Texplorer compresses, with the quality below, and keeps the blocks as a DDS file in the user's "
        "cache "
        "directory: the next time they are read from there."),
};

/// The formats that a texture can be compressed to; the numbers and rows are those of BlockFormat.
enum class CompressedFormat : std::uint32_t {
    Dxt1 = static_cast<std::uint32_t>(BlockFormat::Dxt1),
    Dxt1Alpha = static_cast<std::uint32_t>(BlockFormat::Dxt1Alpha),
    Dxt3 = static_cast<std::uint32_t>(BlockFormat::Dxt3),
    Dxt5 = static_cast<std::uint32_t>(BlockFormat::Dxt5),
};

inline constexpr std::array compressedFormatRows{
    rowOf(BlockFormat::Dxt1),
    rowOf(BlockFormat::Dxt1Alpha),
    rowOf(BlockFormat::Dxt3),
    rowOf(BlockFormat::Dxt5),
};

[[nodiscard]] constexpr BlockFormat blockFormat(CompressedFormat format) {
    return static_cast<BlockFormat>(format);
}

template<>
struct EnumTable<FlipMode> {
    static constexpr std::span<const EnumRow> rows = flipModeRows;
};
template<>
struct EnumTable<Compression> {
    static constexpr std::span<const EnumRow> rows = compressionRows;
};
template<>
struct EnumTable<CompressedFormat> {
    static constexpr std::span<const EnumRow> rows = compressedFormatRows;
};

static_assert(flipModeRows.size() == 5 && compressionRows.size() == 4 && compressedFormatRows.size() == 4);

} // namespace texplorer

#pragma once

// Options for uploading a texture's image: flip, compression, and what is uploaded if it is too large.

#include "texplorer/gl/block_format.h"
#include "texplorer/s3tc/encode_quality.h"

namespace texplorer {

enum class FlipMode : std::uint32_t { Blocks, Pixels, Coordinates, Matrix, None };

inline constexpr std::array flipModeRows{
    row(FlipMode::Blocks, "blocks", "Blocks, lossless",
        "At loading, flips compressed blocks without decompressing them, or pixels if the file isn't "
        "compressed. If the height of a level makes that impossible, the texture is decompressed."),
    row(FlipMode::Pixels, "pixels", "Pixels",
        "At loading, reverses the rows of pixels. A compressed file is decompressed."),
    row(FlipMode::Coordinates, "coordinates", "Coordinates",
        "The image stays as in the file, and every vertex gets 1 - t for t. The texture matrix acts on the "
        "flipped coordinates."),
    row(FlipMode::Matrix, "matrix", "Texture matrix",
        "The image stays as in the file, and the texture matrix begins with t -> 1 - t (glTranslatef(0, 1, "
        "0), glScalef(1, -1, 1))."),
    row(FlipMode::None, "none", "None",
        "The file's first row becomes row 0, OpenGL's bottom row. Upside down if the file begins with the "
        "top row, as in most formats."),
};

enum class Compression : std::uint32_t { FromFile, None, Driver, Cached };

inline constexpr std::array compressionRows{
    row(Compression::FromFile, "file", "As in the file",
        "Uploads the blocks of a DDS file unchanged, level by level (glCompressedTexImage2D). Other images "
        "are not compressed."),
    row(Compression::None, "none", "None", "Eight bits a component. Compressed files are decompressed."),
    row(Compression::Driver, "driver", "By the driver",
        "glTexImage2D with a compressed internal format: the driver compresses quickly during upload."),
    row(Compression::Cached, "cached", "Run time, cached",
        "Texplorer compresses with the quality below and keeps the blocks as a DDS file in the user's "
        "cache directory, to read them from there next time."),
};

/// The formats that a texture can be compressed to; numbers and rows are those of BlockFormat.
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

/// What is uploaded of an image that is larger than the driver's limit for the target.
enum class Oversize : std::uint32_t { None, Smaller };

inline constexpr std::array oversizeRows{
    row(Oversize::None, "none", "No image",
        "As OpenGL: glTexImage fails with GL_INVALID_VALUE, and the texture is incomplete."),
    row(Oversize::Smaller, "smaller", "Smaller levels",
        "The levels of the file that are small enough. Without such levels, the image is halved until it "
        "fits."),
};

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
template<>
struct EnumTable<Oversize> {
    static constexpr std::span<const EnumRow> rows = oversizeRows;
};

static_assert(flipModeRows.size() == 5 && compressionRows.size() == 4 && compressedFormatRows.size() == 4 &&
              oversizeRows.size() == 2);

} // namespace texplorer

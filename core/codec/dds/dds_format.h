#pragma once

// The pixels that a DDS header describes: a block format, or channels in each pixel.

#include "texplorer/base/result.h"
#include "texplorer/codec/dds/dds_header.h"
#include "texplorer/image/texture_image.h"

#include <variant>

namespace texplorer::dds {

/// Uncompressed pixels: little-endian numbers of `bits` bits, with channels at any of their bits.
struct MaskedPixels {
    int bits = 0;                         ///< 8, 16, 24 or 32
    std::array<std::uint32_t, 4> masks{}; ///< red (or luminance), green, blue, alpha; 0 for a missing channel
    PixelFormat decoded = PixelFormat::Rgba8;

    [[nodiscard]] std::size_t bytes() const { return static_cast<std::size_t>(bits) / 8; }
    [[nodiscard]] int widest() const { ///< the most bits of a channel
        int most = 0;
        for (const std::uint32_t mask : masks)
            most = std::max(most, std::popcount(mask));
        return most;
    }
    bool operator==(const MaskedPixels&) const = default;
};

/// Pixels of a known format that is not decoded: units of extent x extent texels.
struct UnreadPixels {
    int bytes = 0;  ///< per unit
    int extent = 1; ///< 4 for blocks
    bool operator==(const UnreadPixels&) const = default;
};

using Pixels = std::variant<MaskedPixels, BlockFormat, UnreadPixels>;

struct Format {
    std::string_view name; ///< "DXT1", "DXGI_FORMAT_BC1_UNORM_SRGB", "RGB"
    Pixels pixels;
    bool srgb = false;
    AlphaMeaning alpha = AlphaMeaning::None;

    /// The size of a surface in the file, and decoded.
    [[nodiscard]] std::uint64_t surfaceBytes(int width, int height, int depth) const;
    [[nodiscard]] std::uint64_t decodedBytes(int width, int height, int depth) const;
};

/// A four-character code of a format.
struct FourCCRow {
    std::uint32_t code;
    BlockFormat format;
    AlphaMeaning alpha;
    std::string_view name;
};

/// A format number of the DX10 header.
struct DxgiRow {
    std::uint32_t number;
    std::string_view name;
    Pixels pixels;
    bool srgb;
};

[[nodiscard]] std::span<const FourCCRow> fourCCRows();
[[nodiscard]] std::span<const DxgiRow> dxgiRows();
[[nodiscard]] const DxgiRow* findDxgi(std::uint32_t number);

/// Returns the header's format, also of formats that are not decoded. Tolerated errors are added to
/// `findings`. DXT1 is always BlockFormat::Dxt1, with the meaning of its alpha if there is any: only the
/// blocks tell.
[[nodiscard]] Result<Format> formatOf(const Header& header, Findings& findings);

} // namespace texplorer::dds

#pragma once

// The palette of a BMP of up to eight bits per pixel. Private to the BMP codec.

#include "texplorer/codec/bmp/bmp_header.h"
#include "texplorer/image/pixel_format.h"

namespace texplorer::bmp {

class Palette {
public:
    /// Reads the entries that the file has; missing ones are black. Reserved bytes are not alpha.
    Palette(ByteView file, const Header& header);

    /// Luminance8 if the palette is the whole ramp of greys, so that each index is its colour; else Rgb8.
    [[nodiscard]] PixelFormat format() const {
        return greyRamp_ ? PixelFormat::Luminance8 : PixelFormat::Rgb8;
    }
    /// Writes the pixels of a row of indices, one index per byte.
    void paint(ByteView indices, std::byte* to);
    /// Whether an index beyond the end of the palette was used.
    [[nodiscard]] bool exceeded() const { return highest_ >= entries_; }
    [[nodiscard]] std::size_t highest() const { return highest_; }

private:
    std::array<std::array<std::byte, 4>, 256>
        colors_{}; // red, green, blue; a fourth byte makes copies faster
    std::size_t entries_;
    std::size_t highest_ = 0; // updated only if the palette is short
    bool complete_;
    bool greyRamp_ = false;
};

} // namespace texplorer::bmp

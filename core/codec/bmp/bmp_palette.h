#pragma once

// The palette of a BMP of up to eight bits a pixel. Private to the BMP codec.

#include "core/codec/bmp/bmp_header.h"
#include "core/image/pixel_format.h"

namespace texplorer::bmp {

class Palette {
public:
    /// The entries that the file has; those that it lacks are black. Reserved bytes are not alpha.
    Palette(ByteView file, const Header& header);

    /// Luminance8 where the palette is the whole ramp of greys, so that an index is its colour; else Rgb8.
    [[nodiscard]] PixelFormat format() const {
        return greyRamp_ ? PixelFormat::Luminance8 : PixelFormat::Rgb8;
    }
    /// Writes the pixels of a row of indices, one a byte.
    void paint(ByteView indices, std::byte* to);
    /// Whether an index beyond the palette's end was painted.
    [[nodiscard]] bool exceeded() const { return highest_ >= entries_; }
    [[nodiscard]] std::size_t highest() const { return highest_; }

private:
    std::array<std::array<std::byte, 4>, 256> colors_{}; // red, green, blue; a fourth byte to copy faster
    std::size_t entries_;
    std::size_t highest_ = 0; // followed only where the palette is short
    bool complete_;
    bool greyRamp_ = false;
};

} // namespace texplorer::bmp

#pragma once

// Pixels of 16 or 32 bits with components at the bits of masks. Private to the BMP codec.

#include "texplorer/codec/bmp/bmp_header.h"

#include <cstddef>
#include <vector>

namespace texplorer::bmp {

/// One component: the bits of a mask, scaled to 0 … 255 and rounded to nearest, as OpenGL 2.1 converts
/// normalised integers (section 2.14, table 2.9).
class Component {
public:
    explicit Component(std::uint32_t mask);
    [[nodiscard]] std::byte of(std::uint32_t pixel) const {
        const std::uint32_t value = (pixel & mask_) >> shift_;
        return table_.empty() ? scaled(value) : table_[value];
    }

private:
    [[nodiscard]] std::byte scaled(std::uint32_t value) const;

    std::uint32_t mask_;
    int shift_;
    std::uint32_t max_;
    std::vector<std::byte> table_; ///< by value; empty for components of more than 12 bits
};

/// Writes the components of rows of pixels: three if the alpha mask is 0, else four.
class BitFields {
public:
    BitFields(const Masks& masks, unsigned bitsPerPixel);

    [[nodiscard]] bool hasAlpha() const { return hasAlpha_; }
    void paint(const std::byte* from, std::byte* to, std::size_t count) const;

private:
    template<std::size_t BytesPerPixel, std::size_t Components>
    void paintAny(const std::byte* from, std::byte* to, std::size_t count) const;

    std::array<Component, 4> components_;
    std::array<std::uint8_t, 4> order_{}; ///< the byte of a pixel that holds each component
    unsigned bitsPerPixel_;
    bool hasAlpha_;
    bool wholeBytes_ = true;
};

/// Whether the bits of a mask are adjacent, as Windows requires.
[[nodiscard]] bool contiguous(std::uint32_t mask);

} // namespace texplorer::bmp

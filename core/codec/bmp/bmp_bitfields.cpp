#include "texplorer/codec/bmp/bmp_bitfields.h"

#include "texplorer/codec/common/reorder.h"

#include <bit>

namespace texplorer::bmp {

namespace {

constexpr std::uint32_t maxTabled = (1U << 12) - 1;

// A component that no bit stands for is 0.
int shiftOf(std::uint32_t mask) {
    return mask == 0 ? 0 : std::countr_zero(mask);
}

} // namespace

bool contiguous(std::uint32_t mask) {
    const std::uint32_t bits = mask >> shiftOf(mask);
    return (bits & (bits + 1)) == 0;
}

Component::Component(std::uint32_t mask)
    : mask_(mask)
    , shift_(shiftOf(mask))
    , max_(mask >> shift_) {
    if (max_ > maxTabled)
        return;
    table_.resize(std::size_t{max_} + 1);
    for (std::uint32_t value = 0; value <= max_; ++value)
        table_[value] = scaled(value);
}

std::byte Component::scaled(std::uint32_t value) const {
    if (max_ == 0)
        return std::byte{0};
    return static_cast<std::byte>((std::uint64_t{value} * 255 + max_ / 2) / max_);
}

BitFields::BitFields(const Masks& masks, unsigned bitsPerPixel)
    : components_{Component(masks[0]), Component(masks[1]), Component(masks[2]), Component(masks[3])}
    , bitsPerPixel_(bitsPerPixel)
    , hasAlpha_(masks[3] != 0) {
    for (std::size_t i = 0; i < (hasAlpha_ ? 4U : 3U); ++i) {
        const int shift = shiftOf(masks[i]);
        wholeBytes_ = wholeBytes_ && shift % 8 == 0 && masks[i] >> shift == 0xFF;
        order_[i] = static_cast<std::uint8_t>(shift / 8);
    }
    wholeBytes_ = wholeBytes_ && bitsPerPixel == 32;
}

template<std::size_t BytesPerPixel, std::size_t Components>
void BitFields::paintAny(const std::byte* from, std::byte* to, std::size_t count) const {
    for (; count > 0; --count, from += BytesPerPixel, to += Components) {
        std::uint32_t pixel = 0;
        for (std::size_t i = 0; i < BytesPerPixel; ++i)
            pixel |= std::to_integer<std::uint32_t>(from[i]) << (8 * i);
        for (std::size_t i = 0; i < Components; ++i)
            to[i] = components_[i].of(pixel);
    }
}

void BitFields::paint(const std::byte* from, std::byte* to, std::size_t count) const {
    if (wholeBytes_ && hasAlpha_)
        reorderFourToFour(from, to, count, order_);
    else if (wholeBytes_)
        reorderFourToThree(from, to, count, order_);
    else if (bitsPerPixel_ == 16 && hasAlpha_)
        paintAny<2, 4>(from, to, count);
    else if (bitsPerPixel_ == 16)
        paintAny<2, 3>(from, to, count);
    else if (hasAlpha_)
        paintAny<4, 4>(from, to, count);
    else
        paintAny<4, 3>(from, to, count);
}

} // namespace texplorer::bmp

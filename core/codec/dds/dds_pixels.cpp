#include "texplorer/codec/dds/dds_pixels.h"

#include "texplorer/codec/common/swizzle.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace texplorer::dds {
namespace {

/// Where the components of a decoded pixel come from: the index of its mask.
std::span<const std::size_t> componentsOf(PixelFormat format) {
    static constexpr std::array<std::size_t, 4> rgba{0, 1, 2, 3};
    static constexpr std::array<std::size_t, 2> luminanceAlpha{0, 3};
    switch (format) {
    case PixelFormat::Alpha8:
        return std::span(rgba).last(1);
    case PixelFormat::Luminance8:
        return std::span(rgba).first(1);
    case PixelFormat::LuminanceAlpha8:
        return luminanceAlpha;
    case PixelFormat::Rgb8:
        return std::span(rgba).first(3);
    case PixelFormat::Rgba8:
    case PixelFormat::Depth32:
    case PixelFormat::RgbaFloat:
        break;
    }
    return rgba;
}

/// One channel: shifted down, `largest` is 1.0. Channels of up to eight bits have their results in a table.
struct Channel {
    std::uint32_t mask = 0;
    int shift = 0;
    std::uint64_t largest = 0;
    std::array<std::byte, 256> table{};

    explicit Channel(std::uint32_t bits)
        : mask(bits)
        , shift(bits == 0 ? 0 : std::countr_zero(bits))
        , largest(bits >> shift) {
        for (std::size_t value = 0; value < table.size() && value <= largest; ++value)
            table[value] = widen(value);
    }
    [[nodiscard]] std::byte widen(std::uint64_t value) const {
        return largest == 0 ? std::byte{0} : static_cast<std::byte>((value * 255 + largest / 2) / largest);
    }
    [[nodiscard]] std::byte of(std::uint32_t pixel) const {
        const std::uint32_t value = (pixel & mask) >> shift;
        return largest <= 255 ? table[value] : widen(value);
    }
};

/// Bytes that only change places: `places[i]` is where component i is within a pixel.
template<std::size_t components>
void pickBytes(ByteView from, std::size_t stride, std::span<const std::size_t> places, Image& image) {
    std::array<std::size_t, components> at;
    std::ranges::copy(places, at.begin());
    const std::byte* in = from.data();
    std::byte* to = image.pixels.data();
    const std::byte* end = to + image.pixels.size();
    for (; to != end; in += stride, to += components)
        for (std::size_t i = 0; i < components; ++i)
            to[i] = in[at[i]];
}

/// Whether every component is a byte of its own, and which.
bool findBytes(const MaskedPixels& pixels, std::span<std::size_t> places) {
    const std::span<const std::size_t> components = componentsOf(pixels.decoded);
    for (std::size_t i = 0; i < components.size(); ++i) {
        const std::uint32_t mask = pixels.masks[components[i]];
        const int shift = mask == 0 ? 0 : std::countr_zero(mask);
        if (mask >> shift != 0xFF || shift % 8 != 0)
            return false;
        places[i] = static_cast<std::size_t>(shift) / 8;
    }
    return true;
}

void copyBytes(const MaskedPixels& pixels, ByteView from, std::span<const std::size_t> places, Image& image) {
    const std::size_t stride = pixels.bytes();
    bool inOrder = true; // no std::views::iota: clang 14, which fuzzes this, can't compile it
    for (std::size_t i = 0; i < places.size(); ++i)
        inOrder = inOrder && places[i] == i;
    if (inOrder && stride == places.size()) {
        std::memcpy(image.pixels.data(), from.data(), image.pixels.size());
        return;
    }
    constexpr std::array<std::size_t, 3> blueGreenRed{2, 1, 0};
    if (stride == 3 && std::ranges::equal(places, blueGreenRed))
        return swapRedBlue(from.data(), image.pixels.data(), image.pixels.size() / 3);
    if (stride == 4 && places.size() == 4 && std::ranges::equal(places.first(3), blueGreenRed))
        return swapRedBlueAlpha(from.data(), image.pixels.data(), image.pixels.size() / 4);
    switch (places.size()) {
    case 1:
        return pickBytes<1>(from, stride, places, image);
    case 2:
        return pickBytes<2>(from, stride, places, image);
    case 3:
        return pickBytes<3>(from, stride, places, image);
    default:
        return pickBytes<4>(from, stride, places, image);
    }
}

// The two bits of each texel in columns 0 to columns - 1 of rows 0 to rows - 1.
std::uint32_t visibleCodes(int columns, int rows) {
    const std::uint32_t row = 0xFFU >> (8 - 2 * columns);
    return (row * 0x01010101U) & (0xFFFFFFFFU >> (32 - 8 * rows));
}

} // namespace

void unpackPixels(const MaskedPixels& pixels, ByteView from, Image& image) {
    const std::span<const std::size_t> components = componentsOf(pixels.decoded);
    std::array<std::size_t, 4> places{};
    if (findBytes(pixels, places))
        return copyBytes(pixels, from, std::span(places).first(components.size()), image);

    std::vector<Channel> channels;
    for (const std::size_t component : components)
        channels.emplace_back(pixels.masks[component]);
    const std::size_t stride = pixels.bytes();
    const std::byte* in = from.data();
    std::byte* to = image.pixels.data();
    const std::byte* end = to + image.pixels.size();
    for (; to != end; in += stride) {
        std::uint32_t pixel = 0;
        for (std::size_t i = 0; i < stride; ++i)
            pixel |= std::to_integer<std::uint32_t>(in[i]) << (8 * i);
        for (const Channel& channel : channels)
            *to++ = channel.of(pixel);
    }
}

bool hasPunchThrough(ByteView blocks, int width, int height, int depth) {
    const std::byte* block = blocks.data();
    const auto number = [&](std::size_t offset, std::size_t bytes) {
        std::uint32_t value = 0;
        for (std::size_t i = 0; i < bytes; ++i)
            value |= std::to_integer<std::uint32_t>(block[offset + i]) << (8 * i);
        return value;
    };
    for (int z = 0; z < depth; ++z)
        for (int top = 0; top < height; top += 4)
            for (int left = 0; left < width; left += 4, block += 8) {
                if (number(0, 2) > number(2, 2))
                    continue; // four colours, none of them transparent
                const std::uint32_t codes = number(4, 4);
                const std::uint32_t threes = codes & codes >> 1 & 0x55555555U;
                if ((threes & visibleCodes(std::min(4, width - left), std::min(4, height - top))) != 0)
                    return true;
            }
    return false;
}

} // namespace texplorer::dds

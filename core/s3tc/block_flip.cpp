#include "texplorer/s3tc/block_flip.h"

#include <algorithm>
#include <cassert>

namespace texplorer {
namespace {

// Where 8 bytes of a block keep their 16 texels, `bits` each, row by row from bit `first` on
// (little-endian, the lowest bit at the right):
//
//   colours   |texel 15 … texel 0: 2 bits each      |color 1: 16|color 0: 16|
//   alphas    |texel 15 … texel 0: 4 bits each                              |
//   values    |texel 15 … texel 0: 3 bits each            |value 1: 8|value 0: 8|
struct HalfLayout {
    unsigned bits;
    unsigned first;
};

constexpr HalfLayout colorHalf{2, 32};
constexpr HalfLayout alphaHalf{4, 0};
constexpr HalfLayout valueHalf{3, 16};

std::array<HalfLayout, 2> halvesOf(BlockFormat format) {
    switch (format) {
    case BlockFormat::Dxt1:
    case BlockFormat::Dxt1Alpha:
        return {colorHalf, colorHalf};
    case BlockFormat::Dxt3:
        return {alphaHalf, colorHalf};
    case BlockFormat::Dxt5:
        return {valueHalf, colorHalf};
    case BlockFormat::Bc4:
    case BlockFormat::Bc4Signed:
    case BlockFormat::Bc5:
    case BlockFormat::Bc5Signed:
        break;
    }
    return {valueHalf, valueHalf};
}

enum class Axis { Rows, Columns };

/// The fields of all texels whose row (or column) is `index`.
std::uint64_t fieldsAt(HalfLayout layout, Axis axis, unsigned index) {
    std::uint64_t mask = 0;
    for (unsigned texel = 0; texel < 16; ++texel)
        if ((axis == Axis::Rows ? texel / 4 : texel % 4) == index)
            mask |= ((std::uint64_t{1} << layout.bits) - 1) << (layout.first + layout.bits * texel);
    return mask;
}

/// 0 1 2 3 becomes 2 3 0 1, and that becomes 3 2 1 0; of three, 0 1 2 becomes 2 1 0; of two, 0 1 becomes 1 0.
void addSwaps(HalfLayout layout, Axis axis, int extent, FieldSwap* swaps) {
    assert(extent >= 1 && extent <= 4);
    const unsigned step = axis == Axis::Rows ? 4 * layout.bits : layout.bits;
    const std::uint64_t first = fieldsAt(layout, axis, 0);
    if (extent == 2)
        swaps[0] = {first, step};
    if (extent == 3)
        swaps[0] = {first, 2 * step};
    if (extent == 4) {
        swaps[0] = {first | fieldsAt(layout, axis, 1), 2 * step};
        swaps[1] = {first | fieldsAt(layout, axis, 2), step};
    }
}

bool movesWholeBytes(const FieldSwap& swap) {
    bool whole = swap.shift % 8 == 0;
    for (unsigned i = 0; i < 64; i += 8) {
        const std::uint64_t byte = swap.low >> i & 0xFF;
        whole = whole && (byte == 0 || byte == 0xFF);
    }
    return whole;
}

std::uint64_t load(const std::byte* bytes) {
    std::uint64_t bits = 0;
    for (unsigned i = 0; i < 8; ++i) // compiles to one load
        bits |= std::to_integer<std::uint64_t>(bytes[i]) << (8 * i);
    return bits;
}

void store(std::byte* bytes, std::uint64_t bits) {
    for (unsigned i = 0; i < 8; ++i)
        bytes[i] = static_cast<std::byte>(bits >> (8 * i));
}

} // namespace

BlockFlip::BlockFlip(BlockFormat format, int rows, int columns)
    : blockBytes(bytesPerBlock(format)) {
    const std::array<HalfLayout, 2> layouts = halvesOf(format);
    for (std::size_t half = 0; half < 2; ++half) {
        addSwaps(layouts[half], Axis::Rows, rows, &halves[half][0]);
        addSwaps(layouts[half], Axis::Columns, columns, &halves[half][2]);
        std::uint64_t places = 0x0706050403020100; // follow the bytes to where the flip puts them
        std::size_t part = 0;
        for (const FieldSwap& swap : halves[half]) {
            if (movesWholeBytes(swap)) {
                places = swap(places);
            } else {
                parts[part].low[half] = swap.low;
                parts[part].shift[half] = swap.shift;
                partCount = std::max(partCount, ++part);
            }
        }
        for (std::size_t i = 0; i < 8; ++i)
            shuffle[8 * half + i] = static_cast<std::uint8_t>((places >> (8 * i) & 7) + 8 * half);
    }
}

void swapFlippedPlain(const BlockFlip& flip, std::byte* first, std::byte* second, std::size_t bytes) {
    for (std::size_t i = 0; i < bytes; i += 8) {
        const std::uint64_t a = load(first + i);
        const std::uint64_t b = load(second + i);
        store(first + i, flip(b, i / 8 % 2));
        store(second + i, flip(a, i / 8 % 2));
    }
}

void swapFlipped(const BlockFlip& flip, std::byte* first, std::byte* second, std::size_t bytes) {
    const std::size_t done = swapFlippedInVectors(flip, first, second, bytes);
    swapFlippedPlain(flip, first + done, second + done, bytes - done);
}

void reverseFlipped(const BlockFlip& flip, std::byte* blocks, std::size_t bytes) {
    std::byte* low = blocks;
    std::byte* high = blocks + bytes - flip.blockBytes;
    for (; low < high; low += flip.blockBytes, high -= flip.blockBytes)
        swapFlippedPlain(flip, low, high, flip.blockBytes);
    if (low == high)
        swapFlippedPlain(flip, low, high, flip.blockBytes);
}

} // namespace texplorer

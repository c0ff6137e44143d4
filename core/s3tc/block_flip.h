#pragma once

// Flips single blocks, for core/s3tc/flip.h.

#include "texplorer/gl/block_format.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace texplorer {

/// Swaps the bits in the mask `low` with those `shift` places higher.
struct FieldSwap {
    std::uint64_t low = 0;
    unsigned shift = 0;

    [[nodiscard]] constexpr std::uint64_t operator()(std::uint64_t bits) const {
        const std::uint64_t differing = (bits >> shift ^ bits) & low;
        return bits ^ differing ^ differing << shift;
    }
};

/// The swaps that flip a block: up to two for the rows and two for the columns, for each 8 bytes of a block.
/// Blocks of 8 bytes have both halves equal, so 16 bytes are always flipped in the same way. The swaps of a
/// half can be done in any order.
struct BlockFlip {
    std::array<std::array<FieldSwap, 4>, 2> halves{};
    std::size_t blockBytes = 8;

    /// The same for vectors: a shuffle of 16 bytes for all swaps of whole bytes, then the other swaps,
    /// `partCount` of them, step by step for both halves.
    struct PartSwaps {
        std::array<std::uint64_t, 2> low{};
        std::array<std::uint64_t, 2> shift{};
    };
    std::array<std::uint8_t, 16> shuffle{};
    std::array<PartSwaps, 4> parts{};
    std::size_t partCount = 0;

    /// @param rows     how many texel rows are reversed: 1 (none), 2 or 3 (the first ones) or 4
    /// @param columns  the same for texel columns
    BlockFlip(BlockFormat format, int rows, int columns);

    [[nodiscard]] std::uint64_t operator()(std::uint64_t bits, std::size_t half) const {
        for (const FieldSwap& swap : halves[half])
            bits = swap(bits);
        return bits;
    }
};

/// Swaps two runs of blocks and flips each block: first[i] becomes flip(second[i]) and vice versa. The two
/// may be the same run, which is then flipped in place, but must not overlap otherwise. Uses the widest
/// vectors of the processor.
void swapFlipped(const BlockFlip& flip, std::byte* first, std::byte* second, std::size_t bytes);

/// The same without vectors: for processors without them, and for tests.
void swapFlippedPlain(const BlockFlip& flip, std::byte* first, std::byte* second, std::size_t bytes);

/// The same for as many bytes as fill vectors; returns their number, which is 0 on processors without AVX2.
[[nodiscard]] std::size_t swapFlippedInVectors(const BlockFlip& flip, std::byte* first, std::byte* second,
                                               std::size_t bytes);

/// Reverses the order of a run of blocks and flips each block.
void reverseFlipped(const BlockFlip& flip, std::byte* blocks, std::size_t bytes);

} // namespace texplorer

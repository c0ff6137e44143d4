#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace texplorer {

/// Which byte of a pixel (0 … 3) becomes its first, second, third and fourth.
using ByteOrder = std::array<std::uint8_t, 4>;

/// Copies `count` pixels of four bytes with their bytes in another order. The areas must not overlap. Takes
/// SSSE3's byte shuffle where the processor has it.
void reorderFourToFour(const std::byte* from, std::byte* to, std::size_t count, const ByteOrder& order);

/// The same to pixels of three bytes: the order's fourth entry is not used.
void reorderFourToThree(const std::byte* from, std::byte* to, std::size_t count, const ByteOrder& order);

/// Both, one byte after the other: what the tests compare with.
void reorderScalar(const std::byte* from, std::byte* to, std::size_t count, const ByteOrder& order,
                   std::size_t components);

} // namespace texplorer

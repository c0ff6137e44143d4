#pragma once

#include <cstdint>

namespace texplorer {

// Randomness that is the same on every machine: integer hashes, and nothing of <cmath> but what IEEE 754
// makes exact.

/// 32 bits that look random and depend on every bit of all four numbers.
[[nodiscard]] std::uint32_t hash(int x, int y, int z, std::uint32_t seed);

/// The same as a number from 0 to 1.
[[nodiscard]] float hash01(int x, int y, int z, std::uint32_t seed);

/// Smooth noise from 0 to 1 whose lattice points lie at the integers. It repeats after `period` lattice cells
/// along each axis, so that what is made of it tiles.
[[nodiscard]] float tiledNoise(float x, float y, float z, int period, std::uint32_t seed);

/// Four octaves of tiledNoise, each of half the size and half the strength of the one before; from 0 to 1.
[[nodiscard]] float tiledTurbulence(float x, float y, float z, int period, std::uint32_t seed);

} // namespace texplorer

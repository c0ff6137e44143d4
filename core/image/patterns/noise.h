#pragma once

#include <cstdint>

namespace texplorer {

// Noise that is the same on every machine: it uses integer hashes, and of <cmath> only what IEEE 754 defines
// exactly.

/// Returns 32 pseudorandom bits that depend on every bit of all four numbers.
[[nodiscard]] std::uint32_t hash(int x, int y, int z, std::uint32_t seed);

/// The same as a number from 0 to 1.
[[nodiscard]] float hash01(int x, int y, int z, std::uint32_t seed);

/// Smooth noise from 0 to 1 with lattice points at the integers. It repeats after `period` lattice cells
/// along each axis, so that patterns made of it tile.
[[nodiscard]] float tiledNoise(float x, float y, float z, int period, std::uint32_t seed);

/// Four octaves of tiledNoise, each with half the size and half the strength of the one before; from 0 to 1.
[[nodiscard]] float tiledTurbulence(float x, float y, float z, int period, std::uint32_t seed);

} // namespace texplorer

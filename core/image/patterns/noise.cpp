#include "texplorer/image/patterns/noise.h"

#include <array>
#include <cmath>
#include <initializer_list>

namespace texplorer {

namespace {

// The finalizer of MurmurHash3 (Austin Appleby, public domain): each input bit flips each output bit half the
// time.
std::uint32_t scramble(std::uint32_t bits) {
    bits ^= bits >> 16;
    bits *= 0x85EBCA6BU;
    bits ^= bits >> 13;
    bits *= 0xC2B2AE35U;
    bits ^= bits >> 16;
    return bits;
}

// A number of each lattice point, in three steps: what neighbours share is computed once.
std::uint32_t hashed(std::uint32_t bits, int part) {
    return scramble(bits ^ (static_cast<std::uint32_t>(part) + 0x9E3779B9U));
}

float unitOf(std::uint32_t bits) {
    return static_cast<float>(bits >> 8) / 16777215.0F;
}

int wrap(int value, int period) {
    const int rest = value % period;
    return rest < 0 ? rest + period : rest;
}

float smooth(float t) {
    return t * t * (3 - 2 * t);
}

float lerp(float from, float to, float amount) {
    return from + (to - from) * amount;
}

} // namespace

std::uint32_t hash(int x, int y, int z, std::uint32_t seed) {
    std::uint32_t bits = scramble(seed + 0x9E3779B9U);
    for (const int part : {x, y, z})
        bits = hashed(bits, part);
    return bits;
}

float hash01(int x, int y, int z, std::uint32_t seed) {
    return unitOf(hash(x, y, z, seed));
}

float tiledNoise(float x, float y, float z, int period, std::uint32_t seed) {
    const float floors[3] = {std::floor(x), std::floor(y), std::floor(z)};
    const float blends[3] = {smooth(x - floors[0]), smooth(y - floors[1]), smooth(z - floors[2])};
    const auto wrapped = [&](int axis) {
        const auto at = static_cast<int>(floors[axis]);
        return std::array{wrap(at, period), wrap(at + 1, period)};
    };
    const std::array xs = wrapped(0);
    const std::array ys = wrapped(1);
    const std::array zs = wrapped(2);
    std::uint32_t columns[2][2]; // the hash of x and y
    for (std::size_t dx = 0; dx < 2; ++dx) {
        const std::uint32_t ofX = hashed(scramble(seed + 0x9E3779B9U), xs[dx]);
        for (std::size_t dy = 0; dy < 2; ++dy)
            columns[dx][dy] = hashed(ofX, ys[dy]);
    }
    const auto slice = [&](std::size_t dz) {
        const auto corner = [&](std::size_t dx, std::size_t dy) {
            return unitOf(hashed(columns[dx][dy], zs[dz]));
        };
        return lerp(lerp(corner(0, 0), corner(1, 0), blends[0]), lerp(corner(0, 1), corner(1, 1), blends[0]),
                    blends[1]);
    };
    return blends[2] == 0 ? slice(0) : lerp(slice(0), slice(1), blends[2]);
}

float tiledTurbulence(float x, float y, float z, int period, std::uint32_t seed) {
    float sum = 0;
    float strength = 8.0F / 15;
    for (std::uint32_t octave = 0; octave < 4; ++octave) {
        const auto scale = static_cast<float>(1 << octave);
        sum += strength * tiledNoise(x * scale, y * scale, z * scale, period << octave, seed + octave);
        strength /= 2;
    }
    return sum;
}

} // namespace texplorer

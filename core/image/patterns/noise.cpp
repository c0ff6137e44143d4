#include "texplorer/image/patterns/noise.h"

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

int wrap(int value, int period) {
    return (value % period + period) % period;
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
        bits = scramble(bits ^ (static_cast<std::uint32_t>(part) + 0x9E3779B9U));
    return bits;
}

float hash01(int x, int y, int z, std::uint32_t seed) {
    return static_cast<float>(hash(x, y, z, seed) >> 8) / 16777215.0F;
}

float tiledNoise(float x, float y, float z, int period, std::uint32_t seed) {
    const float floors[3] = {std::floor(x), std::floor(y), std::floor(z)};
    const float blends[3] = {smooth(x - floors[0]), smooth(y - floors[1]), smooth(z - floors[2])};
    const auto corner = [&](int dx, int dy, int dz) {
        return hash01(wrap(static_cast<int>(floors[0]) + dx, period),
                      wrap(static_cast<int>(floors[1]) + dy, period),
                      wrap(static_cast<int>(floors[2]) + dz, period), seed);
    };
    const auto slice = [&](int dz) {
        return lerp(lerp(corner(0, 0, dz), corner(1, 0, dz), blends[0]),
                    lerp(corner(0, 1, dz), corner(1, 1, dz), blends[0]), blends[1]);
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

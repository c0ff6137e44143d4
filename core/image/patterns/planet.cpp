#include "texplorer/image/patterns/canvas.h"
#include "texplorer/image/patterns/noise.h"
#include "texplorer/image/patterns/patterns.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace texplorer {

namespace {

constexpr int mapWidth = 512;
constexpr int mapHeight = 256;

struct Turn {
    float sine;
    float cosine;
};

// By polynomials, of at most an eighth of a turn: the same on every machine, which <cmath> need not be.
Turn turnBy(float turns) {
    const float quarters = std::floor(4 * turns + 0.5F);
    const float x = (4 * turns - quarters) * 1.57079633F;
    const float xx = x * x;
    const float sine = x * (1 - xx / 6 * (1 - xx / 20 * (1 - xx / 42)));
    const float cosine = 1 - xx / 2 * (1 - xx / 12 * (1 - xx / 30 * (1 - xx / 56)));
    const std::array<Turn, 4> all{{{sine, cosine}, {cosine, -sine}, {-sine, -cosine}, {-cosine, sine}}};
    return all[static_cast<std::size_t>(static_cast<int>(quarters) & 3)];
}

float rise(float from, float to, float value) {
    const float part = std::fmin(1.0F, std::fmax(0.0F, (value - from) / (to - from)));
    return part * part * (3 - 2 * part);
}

// A map of the whole sphere, as gluSphere wants it: s around the axis, t from pole to pole. The noise is that
// of a block in which the sphere lies, so that the map has neither a seam nor pinched poles.
Color planetAt(int column, int row) {
    const Turn longitude = turnBy((static_cast<float>(column) + 0.5F) / mapWidth);
    const Turn latitude = turnBy((static_cast<float>(row) + 0.5F) / (2 * mapHeight)); // from the south pole
    const float x = 1 + latitude.sine * longitude.cosine;
    const float y = 1 + latitude.sine * longitude.sine;
    const float z = 1 - latitude.cosine;
    const auto noise = [&](float scale, std::uint32_t seed) {
        return tiledTurbulence(x * scale, y * scale, z * scale, 1024, seed);
    };
    const float polar = std::fabs(latitude.cosine); // 0 at the equator, 1 at the poles
    const float height = noise(1.7F, 5);
    const float coast = 0.525F;
    const float fine = noise(6, 17);
    if (polar + 0.16F * (fine - 0.5F) > 0.93F - 0.08F * rise(coast - 0.02F, coast, height))
        return shade({238, 244, 250, 255}, 0.92F + 0.12F * fine);
    if (height < coast) {
        const Color deep{10, 34, 92, 255};
        const Color shelf{36, 108, 168, 255};
        return shade(mix(deep, shelf, rise(coast - 0.09F, coast, height)), 0.92F + 0.16F * fine);
    }
    const float dry = rise(0.42F, 0.62F, noise(2.3F, 29) + 0.25F * (0.45F - std::fabs(polar - 0.4F)) - 0.06F);
    Color land = mix({44, 104, 44, 255}, {196, 168, 104, 255}, dry);
    land = mix(land, {118, 122, 96, 255}, rise(0.62F, 0.9F, polar));
    land = mix(land, {132, 112, 92, 255}, rise(coast + 0.08F, coast + 0.16F, height));
    return shade(land, 0.78F + 0.44F * fine);
}

} // namespace

Image drawPlanet() {
    Canvas canvas(mapWidth, mapHeight);
    for (int row = 0; row < mapHeight; ++row)
        for (int column = 0; column < mapWidth; ++column)
            canvas.set(column, row, planetAt(column, row));
    return std::move(canvas).take();
}

} // namespace texplorer

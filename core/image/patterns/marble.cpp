#include "texplorer/image/patterns/canvas.h"
#include "texplorer/image/patterns/noise.h"
#include "texplorer/image/patterns/patterns.h"

#include <cmath>

namespace texplorer {

namespace {

constexpr int marbleSize = 32;

// Distance to the nearest integer, from 0 to 0.5: sheets that repeat once a unit.
float sheet(float phase) {
    return std::fabs(phase - std::floor(phase + 0.5F));
}

// Parallel sheets, bent by turbulence. Each phase grows by a whole number over the block, so that the block
// tiles.
Color colorAt(int x, int y, int z) {
    const float u = static_cast<float>(x) / marbleSize;
    const float v = static_cast<float>(y) / marbleSize;
    const float w = static_cast<float>(z) / marbleSize;
    const float bend = tiledTurbulence(2 * u, 2 * v, 2 * w, 2, 11);
    const float twist = tiledTurbulence(2 * u, 2 * v, 2 * w, 2, 23);
    const float cloud = tiledTurbulence(3 * u, 3 * v, 3 * w, 3, 37);

    const float broad = sheet(u + v + w + 2.4F * bend);
    const float thin = sheet(u - v + 2 * w + 3.0F * twist);
    Color stone = mix({244, 240, 232, 255}, {204, 200, 198, 255}, 1.6F * (cloud - 0.25F));
    stone = mix({92, 100, 116, 255}, stone, std::sqrt(std::fmin(1.0F, broad / 0.20F)));
    return mix({150, 120, 96, 255}, stone, 0.35F + std::fmin(1.0F, thin / 0.07F));
}

} // namespace

Image drawMarble() {
    Canvas canvas(marbleSize, marbleSize, marbleSize);
    for (int z = 0; z < marbleSize; ++z)
        for (int y = 0; y < marbleSize; ++y)
            for (int x = 0; x < marbleSize; ++x)
                canvas.set(x, y, z, colorAt(x, y, z));
    return std::move(canvas).take();
}

} // namespace texplorer

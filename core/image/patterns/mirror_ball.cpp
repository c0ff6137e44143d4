#include "texplorer/image/patterns/canvas.h"
#include "texplorer/image/patterns/noise.h"
#include "texplorer/image/patterns/patterns.h"

#include <cmath>

namespace texplorer {

namespace {

constexpr int ballSize = 256;

float fade(float from, float to, float value) {
    const float part = std::fmin(1.0F, std::fmax(0.0F, (value - from) / (to - from)));
    return part * part * (3 - 2 * part);
}

struct Direction {
    float x, y, z;
};

// What one sees in a direction, y being up: sky and sun, a plain of sand, dark hills between them.
Color seen(Direction to) {
    const float rim = 0.05F + 0.10F * tiledNoise(4 + 3 * to.x, 4 + 3 * to.z, 0, 64, 3);
    if (to.y > rim) {
        Color sky = mix({214, 226, 238, 255}, {40, 92, 178, 255}, fade(0, 0.9F, to.y));
        const float cloud =
            tiledTurbulence(8 + 2 * to.x / (to.y + 0.4F), 8 + 2 * to.z / (to.y + 0.4F), 0, 64, 7);
        sky = mix(sky, {250, 250, 250, 255}, 0.85F * fade(0.5F, 0.7F, cloud));
        const float sun = (-0.48F * to.x + 0.64F * to.y + 0.6F * to.z);
        return mix(sky, {255, 250, 226, 255}, fade(0.955F, 0.985F, sun));
    }
    if (to.y > 0)
        return mix({52, 64, 74, 255}, {96, 112, 124, 255}, fade(0, rim, to.y));
    const float grain = tiledNoise(32 + 6 * to.x / (0.12F - to.y), 32 + 6 * to.z / (0.12F - to.y), 0, 256, 9);
    return shade(mix({186, 160, 118, 255}, {104, 82, 60, 255}, fade(0, 0.9F, -to.y)), 0.86F + 0.22F * grain);
}

// The photograph of a mirror ball from far away, as GL_SPHERE_MAP reads it (OpenGL 2.1, section 2.11.4): the
// middle shows what is behind the eye, the rim what is behind the ball, and nothing reads what lies beyond.
Color reflectionAt(int column, int row) {
    const float u = (static_cast<float>(column) + 0.5F) / (ballSize / 2) - 1;
    const float v = (static_cast<float>(row) + 0.5F) / (ballSize / 2) - 1;
    const float away = u * u + v * v;
    if (away >= 1)
        return {196, 196, 190, 255};
    const Direction normal{u, v, std::sqrt(1 - away)};
    return seen({2 * normal.z * normal.x, 2 * normal.z * normal.y, 2 * normal.z * normal.z - 1});
}

} // namespace

Image drawMirrorBall() {
    Canvas canvas(ballSize, ballSize);
    for (int row = 0; row < ballSize; ++row)
        for (int column = 0; column < ballSize; ++column)
            canvas.set(column, row, reflectionAt(column, row));
    return std::move(canvas).take();
}

} // namespace texplorer

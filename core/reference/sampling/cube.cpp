#include "texplorer/reference/sampling/cube.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace texplorer::reference {

namespace {

/// A row of table 3.19: which components of the direction are sc and tc, and with which sign.
struct FaceAxes {
    int s;
    float sSign;
    int t;
    float tSign;
    int major;
};

constexpr int axisX = 0;
constexpr int axisY = 1;
constexpr int axisZ = 2;

constexpr std::array<FaceAxes, 6> table{{
    {axisZ, -1, axisY, -1, axisX}, // +x: sc = -rz, tc = -ry
    {axisZ, +1, axisY, -1, axisX}, // -x: sc =  rz, tc = -ry
    {axisX, +1, axisZ, +1, axisY}, // +y: sc =  rx, tc =  rz
    {axisX, +1, axisZ, -1, axisY}, // -y: sc =  rx, tc = -rz
    {axisX, +1, axisY, -1, axisZ}, // +z: sc =  rx, tc = -ry
    {axisX, -1, axisY, -1, axisZ}, // -z: sc = -rx, tc = -ry
}};

int majorAxis(glm::vec3 direction) {
    const float ax = std::abs(direction.x);
    const float ay = std::abs(direction.y);
    const float az = std::abs(direction.z);
    return ax >= ay && ax >= az ? axisX : ay >= az ? axisY : axisZ;
}

const FaceAxes& axesOfFace(int face) {
    return table[static_cast<std::size_t>(face)];
}

int majorSign(int face) {
    return face % 2 == 0 ? 1 : -1;
}

/// The centre of a texel, in halves of a texel from the centre of a cube whose edges are `size` texels long.
glm::ivec3 centreOf(const FaceTexel& texel, int size) {
    const FaceAxes& axes = axesOfFace(texel.face);
    glm::ivec3 centre(0);
    centre[axes.s] = static_cast<int>(axes.sSign) * (2 * texel.index.x + 1 - size);
    centre[axes.t] = static_cast<int>(axes.tSign) * (2 * texel.index.y + 1 - size);
    centre[axes.major] = majorSign(texel.face) * size;
    return centre;
}

/// The texel of the face with this centre, which lies in the plane of the face.
glm::ivec2 indexOf(glm::ivec3 centre, int face, int size) {
    const FaceAxes& axes = axesOfFace(face);
    return {(static_cast<int>(axes.sSign) * centre[axes.s] + size - 1) / 2,
            (static_cast<int>(axes.tSign) * centre[axes.t] + size - 1) / 2};
}

/// What is finite stays so: beyond the range of a float it becomes the largest one.
float asFloat(double value) {
    constexpr double max = std::numeric_limits<float>::max();
    return static_cast<float>(std::isfinite(value) ? std::clamp(value, -max, max) : value);
}

} // namespace

CubePlace cubePlace(glm::vec3 direction, const Derivatives& derivatives) {
    const int major = majorAxis(direction);
    const float length = std::abs(direction[major]);
    CubePlace place;
    place.coords = {0.5F, 0.5F, 0};
    if (!std::isfinite(direction.x) || !std::isfinite(direction.y) || !std::isfinite(direction.z) ||
        !(length > 0))
        return place;
    place.face = 2 * major + (direction[major] < 0 ? 1 : 0);
    const FaceAxes& axes = axesOfFace(place.face);
    const float s = axes.sSign * direction[axes.s] / length;
    const float t = axes.tSign * direction[axes.t] / length;
    place.coords = {(s + 1) / 2, (t + 1) / 2, 0};
    // (sc / |ma|)' = (sc' - (sc / |ma|) |ma|') / |ma|; section 3.8.8 lets u and v be those of one face.
    const double sign = direction[major] < 0 ? -1 : 1;
    const auto onFace = [&](glm::dvec3 change) {
        const double growth = sign * change[axes.major];
        return glm::vec3(
            asFloat((double{axes.sSign} * change[axes.s] - double{s} * growth) / double{length} / 2),
            asFloat((double{axes.tSign} * change[axes.t] - double{t} * growth) / double{length} / 2), 0);
    };
    place.derivatives = {onFace(derivatives.dx), onFace(derivatives.dy)};
    return place;
}

// What lies beyond an edge by some length in the plane of a face lies below the edge by that length on the
// next one.
std::optional<FaceTexel> foldedTexel(const FaceTexel& texel, int size) {
    const FaceAxes& axes = axesOfFace(texel.face);
    glm::ivec3 centre = centreOf(texel, size);
    const bool beyondS = std::abs(centre[axes.s]) > size;
    const bool beyondT = std::abs(centre[axes.t]) > size;
    if (!beyondS && !beyondT)
        return texel;
    if (beyondS && beyondT)
        return std::nullopt;
    const int across = beyondS ? axes.s : axes.t;
    const int sign = centre[across] < 0 ? -1 : 1;
    const int excess = std::abs(centre[across]) - size;
    centre[across] = sign * size;
    centre[axes.major] -= majorSign(texel.face) * excess;
    const int face = 2 * across + (sign < 0 ? 1 : 0);
    return FaceTexel{face, indexOf(centre, face, size)};
}

std::optional<glm::ivec2> unfoldedTexel(const FaceTexel& texel, int onto, int size) {
    if (texel.face == onto)
        return texel.index;
    const int across = axesOfFace(texel.face).major;
    const int major = axesOfFace(onto).major;
    if (across == major)
        return std::nullopt;
    glm::ivec3 centre = centreOf(texel, size);
    const int below = size - majorSign(onto) * centre[major];
    centre[across] += majorSign(texel.face) * below;
    centre[major] = majorSign(onto) * size;
    return indexOf(centre, onto, size);
}

} // namespace texplorer::reference

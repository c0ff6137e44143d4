#include "core/mesh/shapes.h"

#include <fmt/core.h>

#include <cmath>
#include <numbers>

namespace texplorer {

namespace {

struct Circle {
    float sine;
    float cosine;
};

// Quarter turns are exact, so that poles are points and the seam closes without a gap.
Circle circleAt(int step, int steps) {
    const double quarters = 4.0 * step / steps;
    if (quarters == std::floor(quarters)) {
        constexpr float sines[] = {0, 1, 0, -1, 0};
        const int quarter = static_cast<int>(quarters) % 4;
        return {sines[quarter], sines[quarter + 1]};
    }
    const double angle = quarters * std::numbers::pi / 2;
    return {static_cast<float>(std::sin(angle)), static_cast<float>(std::cos(angle))};
}

void addTriangle(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    mesh.triangles.insert(mesh.triangles.end(), {a, b, c});
}

} // namespace

// gluSphere turned so that its z axis is our y axis: s = 0 at the back (-z), growing eastwards over the left
// (-x, 0.25), the front (0.5) and the right (0.75). Vertices lie in rows from the south pole up; the seam and
// the poles have a vertex for each s, because one position there needs several texture coordinates.
Mesh makeSphere(int slices, int stacks) {
    Mesh mesh;
    const int rowLength = slices + 1;
    mesh.vertices.reserve(static_cast<std::size_t>(rowLength) * static_cast<std::size_t>(stacks + 1));
    for (int stack = 0; stack <= stacks; ++stack) {
        const Circle latitude = circleAt(stack, 2 * stacks); // from the south pole
        for (int slice = 0; slice <= slices; ++slice) {
            const Circle longitude = circleAt(slice, slices);
            const glm::vec3 point{-latitude.sine * longitude.sine, -latitude.cosine,
                                  -latitude.sine * longitude.cosine};
            const float s = static_cast<float>(slice) / static_cast<float>(slices);
            const float t = static_cast<float>(stack) / static_cast<float>(stacks);
            mesh.vertices.push_back({point, point, {s, t, 0, 1}});
        }
    }

    const auto length = static_cast<std::uint32_t>(rowLength);
    for (int stack = 0; stack < stacks; ++stack) {
        const auto lower = static_cast<std::uint32_t>(stack) * length;
        const std::uint32_t upper = lower + length;
        Face band{fmt::format("Stack {}", stack + 1), {}};
        for (std::uint32_t slice = 0; slice < length; ++slice)
            band.vertices.push_back(lower + slice);
        for (std::uint32_t slice = length; slice-- > 0;)
            band.vertices.push_back(upper + slice);
        mesh.faces.push_back(std::move(band));
    }
    // gluSphere's strips: from the north pole down, westwards. Where nothing hides what lies behind, the
    // order shows.
    for (int stack = stacks; stack-- > 0;) {
        const auto lower = static_cast<std::uint32_t>(stack) * length;
        const std::uint32_t upper = lower + length;
        for (std::uint32_t slice = length - 1; slice-- > 0;) {
            const std::array corners{lower + slice, lower + slice + 1, upper + slice + 1, upper + slice};
            // At a pole one edge of the quadrilateral is a point: only one of its triangles has an area.
            if (stack + 1 == stacks)
                addTriangle(mesh, corners[0], corners[1], corners[3]);
            else if (stack == 0)
                addTriangle(mesh, corners[1], corners[2], corners[3]);
            else
                addQuad(mesh, corners);
        }
    }
    return mesh;
}

} // namespace texplorer

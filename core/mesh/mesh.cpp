#include "texplorer/mesh/mesh.h"

#include "texplorer/mesh/shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace texplorer {

namespace {

constexpr float maxRadius = 1000;

int clampSlices(int slices) {
    return std::clamp(slices, minSlices, maxSubdivision);
}
int clampStacks(Shape shape, int stacks) {
    const int min = shape == Shape::Torus ? 3 : minStacks; // a tube of two sides is flat
    return std::clamp(stacks, min, shape == Shape::Teapot ? maxTeapotStacks : maxSubdivision);
}
float clampRadius(float radius, float greatest) {
    return std::fmin(std::fmax(radius, 0.0F), greatest); // what is no number becomes 0
}
float finiteAngle(float degrees) {
    return std::isfinite(degrees) ? degrees : 0;
}

ShapeOptions withinLimits(const ShapeOptions& options) {
    return {.shape = options.shape,
            .slices = clampSlices(options.slices),
            .stacks = clampStacks(options.shape, options.stacks),
            .topRadius = clampRadius(options.topRadius, maxRadius),
            .innerRadius = clampRadius(options.innerRadius, 1),
            .tubeRadius = clampRadius(options.tubeRadius, maxRadius),
            .startAngle = finiteAngle(options.startAngle),
            .sweepAngle = finiteAngle(options.sweepAngle)};
}

} // namespace

Circle circleAt(double quarters) {
    const double rest = quarters - 4 * std::floor(quarters / 4);
    if (rest == std::floor(rest)) {
        constexpr float sines[] = {0, 1, 0, -1, 0, 1};
        const int quarter = static_cast<int>(rest);
        return {sines[quarter], sines[quarter + 1]};
    }
    const double angle = rest * std::numbers::pi / 2;
    return {static_cast<float>(std::sin(angle)), static_cast<float>(std::cos(angle))};
}

void addTriangle(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    mesh.triangles.insert(mesh.triangles.end(), {a, b, c});
}

void addQuad(Mesh& mesh, const std::array<std::uint32_t, 4>& corners) {
    for (const std::size_t corner : {0U, 1U, 3U, 1U, 2U, 3U})
        mesh.triangles.push_back(corners[corner]);
}

void addBandFaces(Mesh& mesh, const char* name, int slices, int firstRow, int stacks) {
    const auto length = static_cast<std::uint32_t>(slices + 1);
    for (int stack = 0; stack < stacks; ++stack) {
        const std::uint32_t lower = static_cast<std::uint32_t>(firstRow + stack) * length;
        const std::uint32_t upper = lower + length;
        Face face{Sentence("{0} {1}", name, stack + 1), {}};
        face.vertices.reserve(std::size_t{2} * length);
        for (std::uint32_t i = 0; i < length; ++i)
            face.vertices.push_back(lower + i);
        for (std::uint32_t i = length; i-- > 0;)
            face.vertices.push_back(upper + i);
        mesh.faces.push_back(std::move(face));
    }
}

void addBandQuads(Mesh& mesh, int slices, int row) {
    const auto samePlace = [&](std::uint32_t a, std::uint32_t b) {
        return mesh.vertices[a].position == mesh.vertices[b].position;
    };
    const auto length = static_cast<std::uint32_t>(slices + 1);
    const std::uint32_t lower = static_cast<std::uint32_t>(row) * length;
    const std::uint32_t upper = lower + length;
    for (std::uint32_t i = length - 1; i-- > 0;) {
        const std::array corners{lower + i, lower + i + 1, upper + i + 1, upper + i};
        const bool lowerPoint = samePlace(corners[0], corners[1]);
        const bool upperPoint = samePlace(corners[2], corners[3]);
        // At a pole one edge of the quadrilateral is a point: only one of its triangles has an area.
        if (lowerPoint == upperPoint)
            addQuad(mesh, corners);
        else if (upperPoint)
            addTriangle(mesh, corners[0], corners[1], corners[3]);
        else
            addTriangle(mesh, corners[1], corners[2], corners[3]);
    }
}

Mesh turned(std::span<const Ring> rings, int slices) {
    Mesh mesh;
    mesh.vertices.reserve(rings.size() * static_cast<std::size_t>(slices + 1));
    for (std::size_t row = 0; row < rings.size(); ++row) {
        const Ring& ring = rings[row];
        const float t = static_cast<float>(row) / static_cast<float>(rings.size() - 1);
        for (int slice = 0; slice <= slices; ++slice) {
            const Circle longitude = circleAt(4.0 * slice / slices);
            const float s = static_cast<float>(slice) / static_cast<float>(slices);
            mesh.vertices.push_back(
                {{-ring.radius * longitude.sine, ring.height, -ring.radius * longitude.cosine},
                 {-ring.normal.x * longitude.sine, ring.normal.y, -ring.normal.x * longitude.cosine},
                 {s, t, 0, 1}});
        }
    }
    addBandFaces(mesh, N_("Stack"), slices, 0, static_cast<int>(rings.size()) - 1);
    return mesh;
}

void addPatch(Mesh& mesh, std::string name, const Patch& patch) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    const glm::vec3 normal = glm::normalize(glm::cross(patch.right, patch.up));
    const glm::vec4& low = patch.texLowerLeft;
    const glm::vec4& high = patch.texUpperRight;

    mesh.vertices.push_back({patch.lowerLeft, normal, low});
    mesh.vertices.push_back({patch.lowerLeft + patch.right, normal, {high.s, low.t, low.p, low.q}});
    mesh.vertices.push_back({patch.lowerLeft + patch.right + patch.up, normal, high});
    mesh.vertices.push_back({patch.lowerLeft + patch.up, normal, {low.s, high.t, low.p, low.q}});
    addQuad(mesh, {first, first + 1, first + 2, first + 3});
    mesh.faces.push_back({std::move(name), {first, first + 1, first + 2, first + 3}});
}

Mesh makeMesh(const ShapeOptions& options) {
    const ShapeOptions limited = withinLimits(options);
    switch (limited.shape) {
    case Shape::Cube:
        return makeCube();
    case Shape::Sphere:
        return makeSphere(limited.slices, limited.stacks);
    case Shape::Quad:
        return makeQuad();
    case Shape::Floor:
        return makeFloor();
    case Shape::Cylinder:
        return makeCylinder(limited.topRadius, limited.slices, limited.stacks);
    case Shape::Disk:
        return makeDisk(limited.innerRadius, limited.slices, limited.stacks);
    case Shape::PartialDisk:
        return makePartialDisk(limited);
    case Shape::Torus:
        return makeTorus(limited.tubeRadius, limited.slices, limited.stacks);
    case Shape::Teapot:
        return makeTeapot(limited.slices, limited.stacks);
    case Shape::Mesh:
        break;
    }
    return {};
}

std::size_t vertexCount(const ShapeOptions& options) {
    const auto rowLength = static_cast<std::size_t>(clampSlices(options.slices) + 1);
    const auto stacks = static_cast<std::size_t>(clampStacks(options.shape, options.stacks));
    switch (options.shape) {
    case Shape::Cube:
        return 24;
    case Shape::Sphere:
    case Shape::Cylinder:
    case Shape::Disk:
    case Shape::PartialDisk:
    case Shape::Torus:
        return rowLength * (stacks + 1);
    case Shape::Teapot: // ten rings of patches, in four parts
        return rowLength * (10 * stacks + 4);
    case Shape::Quad:
    case Shape::Floor:
        return 4;
    case Shape::Mesh:
        break;
    }
    return 0;
}

} // namespace texplorer

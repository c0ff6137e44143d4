#include "texplorer/mesh/mesh_data.h"

#include "texplorer/mesh/shapes.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

namespace texplorer {

namespace {

constexpr std::size_t maxPartFaces = 64;

/// The vertices in the order in which they are drawn.
using Order = std::span<const std::uint32_t>;

void assemblePoints(Mesh& mesh, Order order) {
    mesh.points.assign(order.begin(), order.end());
}

void assembleLines(Mesh& mesh, Order order) {
    mesh.lines.assign(order.begin(), order.end());
}

void assembleLineStrip(Mesh& mesh, Order order) {
    for (std::size_t i = 1; i < order.size(); ++i)
        mesh.lines.insert(mesh.lines.end(), {order[i - 1], order[i]});
}

void assembleLineLoop(Mesh& mesh, Order order) {
    assembleLineStrip(mesh, order);
    mesh.lines.insert(mesh.lines.end(), {order.back(), order.front()});
}

void assembleTriangles(Mesh& mesh, Order order) {
    mesh.triangles.assign(order.begin(), order.end());
}

void assembleTriangleStrip(Mesh& mesh, Order order) {
    for (std::size_t i = 2; i < order.size(); ++i) {
        const std::size_t odd = i % 2; // every second one turns the other way
        addTriangle(mesh, order[i - 2 + odd], order[i - 1 - odd], order[i]);
    }
}

void assembleTriangleFan(Mesh& mesh, Order order) {
    for (std::size_t i = 2; i < order.size(); ++i)
        addTriangle(mesh, order[0], order[i - 1], order[i]);
}

void assembleQuads(Mesh& mesh, Order order) {
    for (std::size_t i = 3; i < order.size(); i += 4)
        addQuad(mesh, {order[i - 3], order[i - 2], order[i - 1], order[i]});
}

// The corners run 0, 1, 3, 2. The strip's last vertex has to be the last corner: it gives the flat colour. Of
// the two triangles Mesa draws that with the first edge first, which shows where a twisted quadrilateral
// covers itself.
void assembleQuadStrip(Mesh& mesh, Order order) {
    for (std::size_t i = 3; i < order.size(); i += 2) {
        addTriangle(mesh, order[i - 3], order[i - 2], order[i]);
        addTriangle(mesh, order[i - 1], order[i - 3], order[i]);
    }
}

// A polygon has the flat colour of its first vertex.
void assemblePolygon(Mesh& mesh, Order order) {
    for (std::size_t i = 2; i < order.size(); ++i)
        addTriangle(mesh, order[i - 1], order[i], order[0]);
}

enum class Outline : std::uint8_t {
    Parts,  ///< one for each part
    Whole,  ///< all vertices as they are drawn
    Zigzag, ///< a strip's: along one edge and back along the other
};

struct Assembly {
    Primitive primitive;
    void (*assemble)(Mesh& mesh, Order order);
    std::size_t minVertices; ///< so many vertices make the first part
    std::size_t step;        ///< and so many more another one
    Outline outline;
    const char* face;
    bool closed; ///< whether a face leads back to its first vertex
};

constexpr std::array assemblies{
    Assembly{Primitive::Points, assemblePoints, 1, 1, Outline::Whole, N_("Points"), false},
    Assembly{Primitive::Lines, assembleLines, 2, 2, Outline::Parts, N_("Line"), false},
    Assembly{Primitive::LineStrip, assembleLineStrip, 2, 1, Outline::Whole, N_("Line strip"), false},
    Assembly{Primitive::LineLoop, assembleLineLoop, 2, 1, Outline::Whole, N_("Line loop"), true},
    Assembly{Primitive::Triangles, assembleTriangles, 3, 3, Outline::Parts, N_("Triangle"), true},
    Assembly{Primitive::TriangleStrip, assembleTriangleStrip, 3, 1, Outline::Zigzag, N_("Strip"), true},
    Assembly{Primitive::TriangleFan, assembleTriangleFan, 3, 1, Outline::Whole, N_("Fan"), true},
    Assembly{Primitive::Quads, assembleQuads, 4, 4, Outline::Parts, N_("Quad"), true},
    Assembly{Primitive::QuadStrip, assembleQuadStrip, 4, 2, Outline::Zigzag, N_("Strip"), true},
    Assembly{Primitive::Polygon, assemblePolygon, 3, 1, Outline::Whole, N_("Polygon"), true},
};
static_assert(assemblies.size() == primitiveRows.size());

std::vector<std::uint32_t> upTo(std::size_t count) {
    std::vector<std::uint32_t> numbers(count);
    std::iota(numbers.begin(), numbers.end(), 0U);
    return numbers;
}

/// The vertices that complete a part.
Order completeParts(Order order, const Assembly& assembly) {
    if (order.size() < assembly.minVertices)
        return {};
    return order.first(order.size() - (order.size() - assembly.minVertices) % assembly.step);
}

void addPartFaces(Mesh& mesh, Order order, const Assembly& assembly) {
    if (order.size() / assembly.step > maxPartFaces) {
        mesh.faces.push_back({N_("Vertices"), upTo(mesh.vertices.size()), false});
        return;
    }
    for (std::size_t first = 0; first < order.size(); first += assembly.step) {
        const Order part = order.subspan(first, assembly.step);
        mesh.faces.push_back({Sentence("{0} {1}", assembly.face, mesh.faces.size() + 1),
                              {part.begin(), part.end()},
                              assembly.closed});
    }
}

// Counter-clockwise, as a strip's first triangle: 0, then the odd ones, then the even ones back.
std::vector<std::uint32_t> zigzagOutline(Order strip) {
    std::vector<std::uint32_t> outline{strip[0]};
    for (std::size_t i = 1; i < strip.size(); i += 2)
        outline.push_back(strip[i]);
    for (std::size_t i = (strip.size() - 1) / 2; i > 0; --i)
        outline.push_back(strip[2 * i]);
    return outline;
}

void addFaces(Mesh& mesh, Order order, const Assembly& assembly) {
    if (assembly.outline == Outline::Parts)
        addPartFaces(mesh, order, assembly);
    else if (assembly.outline == Outline::Zigzag)
        mesh.faces.push_back({assembly.face, zigzagOutline(order)});
    else
        mesh.faces.push_back({assembly.face, {order.begin(), order.end()}, assembly.closed});
}

// A normal without a direction becomes (0, 0, 0): no light falls on it.
glm::vec3 unitNormal(const glm::vec3& normal) {
    const glm::dvec3 exact(normal); // in which no square overflows
    const double length = glm::length(exact);
    return length > 0 && std::isfinite(length) ? glm::vec3(exact / length) : glm::vec3(0);
}

/// The vertex's entry, or `otherwise` where the list is empty or doesn't fit.
template<typename Value>
Value entryOr(const SharedList<Value>& list, std::size_t index, const MeshData& data,
              const Value& otherwise) {
    return list.size() == data.positions.size() ? list[index] : otherwise;
}

} // namespace

std::vector<std::uint32_t> drawnOrder(const MeshData& data) {
    if (data.indices.empty())
        return upTo(data.positions.size());
    std::vector<std::uint32_t> order;
    order.reserve(data.indices.size());
    for (const int index : data.indices)
        if (index >= 0 && static_cast<std::size_t>(index) < data.positions.size())
            order.push_back(static_cast<std::uint32_t>(index));
    return order;
}

Mesh makeMesh(const MeshData& data) {
    Mesh mesh;
    mesh.colored = !data.colors.empty() && data.colors.size() == data.positions.size();
    mesh.vertices.reserve(data.positions.size());
    for (std::size_t i = 0; i < data.positions.size(); ++i)
        mesh.vertices.push_back({data.positions[i],
                                 unitNormal(entryOr(data.normals, i, data, glm::vec3(0, 0, 1))),
                                 entryOr(data.texCoords, i, data, glm::vec4(0, 0, 0, 1)),
                                 entryOr(data.colors, i, data, glm::vec4(1))});

    const auto assembly = std::ranges::find(assemblies, data.primitive, &Assembly::primitive);
    if (assembly == assemblies.end())
        return mesh;
    const std::vector<std::uint32_t> drawn = drawnOrder(data);
    const Order order = completeParts(drawn, *assembly);
    if (order.empty())
        return mesh;
    assembly->assemble(mesh, order);
    addFaces(mesh, order, *assembly);
    return mesh;
}

} // namespace texplorer

#include "texplorer/scene/sent_vertices.h"

#include "texplorer/scene/model_mesh.h"
#include "texplorer/scene/tex_coords.h"

#include <algorithm>
#include <numeric>
#include <ranges>

namespace texplorer {
namespace {

bool isVertex(int number, std::size_t vertices) {
    return number >= 0 && static_cast<std::size_t>(number) < vertices;
}

/// By vertex, whether its call is left out.
std::vector<bool> leftOut(const std::vector<int>& numbers, std::size_t vertices) {
    std::vector<bool> flags(vertices);
    for (const int number : numbers)
        if (isVertex(number, vertices))
            flags[static_cast<std::size_t>(number)] = true;
    return flags;
}

std::vector<std::uint32_t> orderOf(const Model& model, const Mesh& mesh) {
    if (model.shape == Shape::Mesh)
        return drawnOrder(model.mesh);
    if (sentPrimitive(model) == Primitive::Triangles)
        return mesh.triangles;
    MeshData data;
    data.positions.resize(mesh.vertices.size());
    return drawnOrder(data);
}

/// The vertices' entries in a list that has one for each, in the order in which they are sent.
template<class T>
std::vector<T> inOrder(const SharedList<T>& list, const Mesh& mesh, const std::vector<SentVertex>& sent) {
    std::vector<T> values;
    if (list.size() != mesh.vertices.size())
        return values;
    values.reserve(sent.size());
    for (const SentVertex& each : sent)
        values.push_back(list[each.vertex]);
    return values;
}

Model expanded(const Model& model, const Mesh& mesh, const std::vector<SentVertex>& sent) {
    Model made = model;
    made.shape = Shape::Mesh;
    made.noTexCoord = {};
    made.mesh = {.primitive = sentPrimitive(model)};
    for (const SentVertex& each : sent)
        made.mesh.positions.push_back(mesh.vertices[each.vertex].position);
    if (model.shape == Shape::Mesh) {
        made.mesh.normals = inOrder(model.mesh.normals, mesh, sent);
        made.mesh.colors = inOrder(model.mesh.colors, mesh, sent);
    } else {
        for (const SentVertex& each : sent)
            made.mesh.normals.push_back(mesh.vertices[each.vertex].normal);
    }
    for (std::size_t u = 0; u < maxUnits; ++u) {
        const TexCoords given = effectiveTexCoords(model, mesh, static_cast<int>(u));
        TexCoords list;
        list.reserve(sent.size());
        for (const SentVertex& each : sent)
            list.push_back(each.coordsOf[u] ? given[*each.coordsOf[u]] : glm::vec4(0, 0, 0, 1));
        if (u == 0)
            made.mesh.texCoords = list;
        made.texCoords[u] = list == made.mesh.texCoords.read() ? TexCoords() : std::move(list);
    }
    return made;
}

} // namespace

bool leavesOutCalls(const Model& model) {
    if (std::ranges::all_of(model.noTexCoord, &std::vector<int>::empty))
        return false;
    const std::size_t vertices = vertexCountOf(model);
    return std::ranges::any_of(model.noTexCoord, [vertices](const std::vector<int>& numbers) {
        return std::ranges::any_of(numbers, [vertices](int each) { return isVertex(each, vertices); });
    });
}

std::vector<SentVertex> sentVertices(const Model& model, const Mesh& mesh) {
    const std::vector<std::uint32_t> order = orderOf(model, mesh);
    std::vector<SentVertex> sent;
    sent.reserve(order.size());
    for (const std::uint32_t vertex : order)
        sent.push_back({vertex});
    for (std::size_t u = 0; u < maxUnits; ++u) {
        const std::vector<bool> skipped = leftOut(model.noTexCoord[u], mesh.vertices.size());
        std::optional<std::uint32_t> current;
        for (SentVertex& each : sent) {
            if (!skipped[each.vertex])
                current = each.vertex;
            each.coordsOf[u] = current;
        }
    }
    return sent;
}

std::optional<SentVertex> firstWithoutCall(const std::vector<SentVertex>& sent, std::size_t unit) {
    const auto first = std::ranges::find_if(
        sent, [unit](const SentVertex& each) { return each.coordsOf[unit] != each.vertex; });
    return first == sent.end() ? std::nullopt : std::optional(*first);
}

std::vector<std::optional<std::uint32_t>> coordSources(const Model& model, const Mesh& mesh, int unit) {
    const auto at = static_cast<std::size_t>(unit);
    std::vector<std::optional<std::uint32_t>> sources(mesh.vertices.size());
    std::iota(sources.begin(), sources.end(), 0U);
    if (model.noTexCoord[at].empty())
        return sources;
    for (const SentVertex& each : sentVertices(model, mesh) | std::views::reverse) // the first one remains
        sources[each.vertex] = each.coordsOf[at];
    return sources;
}

std::optional<std::uint32_t> coordSource(const Model& model, const Mesh& mesh, int unit, std::size_t vertex) {
    if (model.noTexCoord[static_cast<std::size_t>(unit)].empty())
        return static_cast<std::uint32_t>(vertex);
    return coordSources(model, mesh, unit)[vertex];
}

void setLeftOut(Model& model, int unit, std::size_t vertex, bool leftOut) {
    std::vector<int>& numbers = model.noTexCoord[static_cast<std::size_t>(unit)];
    const int number = static_cast<int>(vertex);
    std::erase(numbers, number);
    if (leftOut)
        numbers.insert(std::ranges::lower_bound(numbers, number), number);
}

Primitive sentPrimitive(const Model& model) {
    switch (model.shape) {
    case Shape::Mesh:
        return model.mesh.primitive;
    case Shape::Cube:
    case Shape::Quad:
    case Shape::Floor: // whose squares have four corners of their own
        return Primitive::Quads;
    default:
        return Primitive::Triangles;
    }
}

SentModel::SentModel(const Model& model)
    : model_(model) {
    if (!leavesOutCalls(model))
        return;
    Mesh mesh = meshOf(model);
    std::vector<SentVertex> sent = sentVertices(model, mesh);
    Model made = expanded(model, mesh, sent);
    made_ = Made{std::move(made), std::move(mesh), std::move(sent)};
}

} // namespace texplorer

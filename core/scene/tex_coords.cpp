#include "texplorer/scene/tex_coords.h"

#include <cassert>

namespace texplorer {

TexCoords effectiveTexCoords(const Model& model, const Mesh& mesh, int unit) {
    assert(unit >= 0 && unit < maxUnits);
    const TexCoords& own = model.texCoords[static_cast<std::size_t>(unit)];
    if (own.size() == mesh.vertices.size())
        return own;
    TexCoords list(mesh.vertices.size());
    std::ranges::transform(mesh.vertices, list.begin(), &Vertex::texCoord);
    return list;
}

glm::vec4 effectiveTexCoord(const Model& model, const Mesh& mesh, int unit, std::size_t vertex) {
    assert(unit >= 0 && unit < maxUnits && vertex < mesh.vertices.size());
    const TexCoords& own = model.texCoords[static_cast<std::size_t>(unit)];
    return own.size() == mesh.vertices.size() ? own[vertex] : mesh.vertices[vertex].texCoord;
}

void setTexCoord(Model& model, const Mesh& mesh, int unit, std::size_t vertex, glm::vec4 value) {
    if (vertex >= mesh.vertices.size())
        return;
    TexCoords list = effectiveTexCoords(model, mesh, unit);
    list[vertex] = value;
    model.texCoords[static_cast<std::size_t>(unit)] = std::move(list);
}

} // namespace texplorer

#include "texplorer/scene/mesh_edits.h"

#include "texplorer/scene/model_mesh.h"

#include <algorithm>
#include <utility>

namespace texplorer {
namespace {

/// Calls `edit` with every list that has an entry for each vertex; the others are dropped.
void eachVertexList(Model& model, const auto& edit) {
    MeshData& mesh = model.mesh;
    const std::size_t count = mesh.positions.size();
    const auto visit = [&](auto& list) {
        if (list.size() == count)
            edit(list.edit());
        else
            list.clear();
    };
    visit(mesh.normals);
    visit(mesh.colors);
    visit(mesh.texCoords);
    for (SharedList<glm::vec4>& list : model.texCoords)
        visit(list);
    edit(mesh.positions.edit());
}

/// Calls `edit` with the numbers of the vertices without glTexCoord; those of no vertex are dropped.
void eachLeftOut(Model& model, const auto& edit) {
    for (std::vector<int>& numbers : model.noTexCoord) {
        std::erase_if(numbers, [count = model.mesh.positions.size()](int number) {
            return std::cmp_greater_equal(number, count);
        });
        edit(numbers);
    }
}

/// How many vertices each part takes for itself alone; 1 where parts share them.
std::size_t ownVertices(Primitive primitive) {
    switch (primitive) {
    case Primitive::Lines:
        return 2;
    case Primitive::Triangles:
        return 3;
    case Primitive::Quads:
        return 4;
    default:
        return 1;
    }
}

bool hasRoom(const MeshData& mesh) {
    return mesh.positions.size() < maxMeshVertices && mesh.indices.size() < maxMeshIndices;
}

/// Adds one like `vertex` before the one that is at `at` so far.
void insertLike(Model& model, std::size_t vertex, std::size_t at) {
    const int number = static_cast<int>(at);
    eachLeftOut(model, [&](std::vector<int>& numbers) {
        const bool also = std::ranges::find(numbers, static_cast<int>(vertex)) != numbers.end();
        for (int& each : numbers)
            each += each >= number ? 1 : 0;
        if (also)
            numbers.insert(std::ranges::lower_bound(numbers, number), number);
    });
    eachVertexList(model, [&](auto& list) {
        const auto value = list[vertex];
        list.insert(list.begin() + static_cast<std::ptrdiff_t>(at), value);
    });
}

} // namespace

Result<void> turnIntoMesh(Model& model) {
    if (model.shape == Shape::Mesh)
        return fail(ErrorCode::OutOfRange, "it already is a mesh");
    const std::string_view shape = rowOf(model.shape).name;
    if (const std::size_t count = vertexCountOf(model); count > maxMeshVertices)
        return fail(ErrorCode::TooLarge, Sentence("the {0} has {1} vertices, a mesh has at most {2}", shape,
                                                  count, maxMeshVertices));
    const Mesh mesh = meshOf(model);
    MeshData data{.primitive = Primitive::Quads};
    for (const Vertex& vertex : mesh.vertices) {
        data.positions.push_back(vertex.position);
        data.normals.push_back(vertex.normal);
        data.texCoords.push_back(vertex.texCoord);
    }
    if (makeMesh(data).triangles != mesh.triangles) {
        if (mesh.triangles.size() > maxMeshIndices)
            return fail(ErrorCode::TooLarge,
                        Sentence("the triangles of the {0} have {1} corners, a mesh has at most {2} indices",
                                 shape, mesh.triangles.size(), maxMeshIndices));
        data.primitive = Primitive::Triangles;
        data.indices = std::vector<int>(mesh.triangles.begin(), mesh.triangles.end());
    }
    model.shape = Shape::Mesh;
    model.mesh = std::move(data);
    return {};
}

Result<void> takeVertices(MeshData& mesh) {
    if (mesh.positions.size() > maxMeshVertices || mesh.indices.size() > maxMeshIndices)
        return fail(
            ErrorCode::TooLarge,
            Sentence("the part of {0} has {1} vertices and {2} indices; at most {3} and {4} can be edited",
                     ProperName{mesh.file}, mesh.positions.size(), mesh.indices.size(), maxMeshVertices,
                     maxMeshIndices));
    mesh.file.clear();
    mesh.part = 0;
    return {};
}

glm::vec3 givenNormal(const MeshData& mesh, std::size_t vertex) {
    return mesh.normals.size() == mesh.positions.size() ? mesh.normals[vertex] : glm::vec3(0, 0, 1);
}

void setPosition(MeshData& mesh, std::size_t vertex, glm::vec3 value, bool together) {
    const glm::vec3 before = mesh.positions[vertex];
    std::vector<glm::vec3>& positions = mesh.positions.edit();
    if (together)
        std::ranges::replace(positions, before, value);
    positions[vertex] = value;
}

void setNormal(MeshData& mesh, std::size_t vertex, glm::vec3 value) {
    if (mesh.normals.size() != mesh.positions.size())
        mesh.normals.assign(mesh.positions.size(), glm::vec3(0, 0, 1));
    mesh.normals.edit()[vertex] = value;
}

void setColor(MeshData& mesh, std::size_t vertex, glm::vec4 value, glm::vec4 others) {
    if (mesh.colors.size() != mesh.positions.size())
        mesh.colors.assign(mesh.positions.size(), others);
    mesh.colors.edit()[vertex] = value;
}

bool appendVertex(Model& model, std::size_t like) {
    MeshData& mesh = model.mesh;
    if (!hasRoom(mesh))
        return false;
    const std::size_t count = mesh.positions.size();
    if (count == 0) {
        eachVertexList(model, [](auto& list) { list.clear(); });
        eachLeftOut(model, [](std::vector<int>& /*numbers*/) {}); // there is no vertex
    }
    if (!mesh.indices.empty())
        mesh.indices.push_back(static_cast<int>(count));
    if (count == 0)
        mesh.positions.emplace_back(0);
    else
        insertLike(model, like, count);
    return true;
}

bool duplicateVertex(Model& model, std::size_t vertex) {
    MeshData& mesh = model.mesh;
    if (!hasRoom(mesh))
        return false;
    insertLike(model, vertex, vertex + 1);
    const int like = static_cast<int>(vertex);
    std::vector<int>& indices = mesh.indices.edit();
    for (int& index : indices)
        index += index > like ? 1 : 0;
    if (const auto drawn = std::ranges::find(indices, like); drawn != indices.end())
        indices.insert(drawn + 1, like + 1);
    return true;
}

void removeVertex(Model& model, std::size_t vertex) {
    MeshData& mesh = model.mesh;
    const int removed = static_cast<int>(vertex);
    eachLeftOut(model, [&](std::vector<int>& numbers) {
        std::erase(numbers, removed);
        for (int& each : numbers)
            each -= each > removed ? 1 : 0;
    });
    eachVertexList(model,
                   [&](auto& list) { list.erase(list.begin() + static_cast<std::ptrdiff_t>(vertex)); });
    const std::size_t part = ownVertices(mesh.primitive);
    std::vector<int> left;
    for (std::size_t first = 0; first < mesh.indices.size(); first += part) {
        const auto begin = mesh.indices.begin() + static_cast<std::ptrdiff_t>(first);
        const auto end = begin + static_cast<std::ptrdiff_t>(std::min(part, mesh.indices.size() - first));
        if (std::find(begin, end, removed) == end)
            left.insert(left.end(), begin, end);
    }
    for (int& index : left)
        index -= index > removed ? 1 : 0;
    mesh.indices = std::move(left);
}

} // namespace texplorer

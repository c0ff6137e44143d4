#pragma once

#include "texplorer/base/sentence.h"
#include "texplorer/scene/model_mesh.h"
#include "texplorer/scene/sent_vertices.h"

#include <algorithm>
#include <span>
#include <vector>

namespace texplorer::reference {

/// The name of the first face that holds a part's corners; empty: none.
inline Sentence faceOf(const Mesh& mesh, std::span<const std::uint32_t> part) {
    for (const Face& face : mesh.faces) {
        const bool holdsAll = std::ranges::all_of(part, [&](std::uint32_t vertex) {
            return std::ranges::find(face.vertices, vertex) != face.vertices.end();
        });
        if (holdsAll)
            return face.name;
    }
    return {};
}

/// The scene's numbers of the vertices that are drawn, which are others if the model leaves out glTexCoord.
class GivenVertices {
public:
    explicit GivenVertices(const Model& model) {
        if (!leavesOutCalls(model))
            return;
        mesh_ = meshOf(model);
        sent_ = sentVertices(model, mesh_);
    }

    [[nodiscard]] std::uint32_t vertexOf(std::uint32_t drawn) const {
        return sent_.empty() ? drawn : sent_[drawn].vertex;
    }
    [[nodiscard]] std::optional<std::uint32_t> coordsOf(std::uint32_t drawn, std::size_t unit) const {
        return sent_.empty() ? drawn : sent_[drawn].coordsOf[unit];
    }
    [[nodiscard]] Sentence faceOf(const Mesh& drawn, std::span<const std::uint32_t> part) const {
        std::vector<std::uint32_t> vertices;
        for (const std::uint32_t each : part)
            vertices.push_back(vertexOf(each));
        return reference::faceOf(sent_.empty() ? drawn : mesh_, vertices);
    }

private:
    Mesh mesh_;
    std::vector<SentVertex> sent_;
};

} // namespace texplorer::reference

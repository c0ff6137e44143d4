#pragma once

#include "texplorer/base/sentence.h"
#include "texplorer/mesh/mesh.h"
#include "texplorer/scene/sent_vertices.h"

#include <algorithm>
#include <span>

namespace texplorer::reference {

/// The name of the first face of the given model that holds the corners of a part of the drawn one; empty:
/// none.
inline Sentence faceName(const SentModel& model, const Mesh& drawn, std::span<const std::uint32_t> part) {
    const Mesh* given = model.givenMesh();
    for (const Face& face : (given ? *given : drawn).faces) {
        const bool holdsAll = std::ranges::all_of(part, [&](std::uint32_t corner) {
            return std::ranges::find(face.vertices, model.vertexOf(corner)) != face.vertices.end();
        });
        if (holdsAll)
            return face.name;
    }
    return {};
}

} // namespace texplorer::reference

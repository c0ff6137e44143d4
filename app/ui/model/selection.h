#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace texplorer::ui {

/// Vertices of one model that are chosen together.
struct VertexGroup {
    int model = 0;
    std::vector<std::size_t> vertices{}; ///< ascending
};

/// What the panels show. Indices beyond the scene are brought back by `settle`.
struct Selection {
    int model = 0;
    std::optional<std::size_t> vertex;
    VertexGroup group{}; ///< counts while `vertex` is one of it: see chosen_vertices.h
    int pass = 0;
    int unit = 0;
};

} // namespace texplorer::ui

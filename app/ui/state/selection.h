#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace texplorer::ui {

/// Vertices of one model that are selected together.
struct VertexGroup {
    int model = 0;
    std::vector<std::size_t> vertices{}; ///< ascending
};

/// The selected objects, which the panels show. `settle` corrects indices outside of the scene.
struct Selection {
    int model = 0;
    std::optional<std::size_t> vertex;
    VertexGroup group{}; ///< valid while it contains `vertex`: see chosen_vertices.h
    int pass = 0;
    int unit = 0;
};

} // namespace texplorer::ui

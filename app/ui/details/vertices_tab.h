#pragma once

#include "app/ui/model/session.h"

#include <optional>

namespace texplorer::ui {

/// What the list shows of each vertex. Shapes other than meshes have coordinates alone to edit.
enum class VertexPart { Coordinates, Position, Normal, Color };

/// What the tab remembers.
struct VerticesTabState {
    std::optional<std::size_t> revealed; ///< the vertex that the list was scrolled to already
    VertexPart part = VertexPart::Coordinates;
    bool together = true; ///< vertices at one place are moved as one
};

void drawVerticesTab(Session& session, VerticesTabState& state);

} // namespace texplorer::ui

#pragma once

#include "app/ui/details/vertex_parts.h"
#include "app/ui/model/session.h"

#include <optional>

namespace texplorer::ui {

/// What the tab remembers.
struct VerticesTabState {
    std::optional<std::size_t> revealed; ///< the vertex that the list was scrolled to already
    VertexPart part = VertexPart::Coordinates;
    bool together = true; ///< vertices at one place are moved as one
};

void drawVerticesTab(Session& session, VerticesTabState& state);

} // namespace texplorer::ui

#pragma once

#include "app/ui/details/vertex_parts.h"
#include "app/ui/model/session.h"

#include <optional>

namespace texplorer::ui {

/// The state of the tab.
struct VerticesTabState {
    std::optional<std::size_t> revealed; ///< the vertex that the list was already scrolled to
    VertexPart part = VertexPart::Coordinates;
    bool together = true; ///< vertices at one place move together
};

void drawVerticesTab(const Session& session, VerticesTabState& state);

} // namespace texplorer::ui

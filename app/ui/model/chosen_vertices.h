#pragma once

#include "app/ui/model/window_state.h"

#include <vector>

namespace texplorer::ui {

// Selection::vertex is the one that lists and labels are about; others may be chosen with it. Who sets the
// vertex alone, or another model, has chosen no others: a group counts while it has the vertex.

/// All that are chosen, ascending.
[[nodiscard]] std::vector<std::size_t> chosenVertices(const Selection& selection);

[[nodiscard]] bool isChosen(const Selection& selection, std::size_t vertex);

/// Chooses exactly these; none: nothing is chosen. The one that was the vertex stays it where it is among
/// them.
void chooseVertices(Selection& selection, std::vector<std::size_t> vertices);

/// Adds one to those that are chosen, which becomes the vertex, or takes it away.
void toggleVertex(Selection& selection, std::size_t vertex);

} // namespace texplorer::ui

#pragma once

#include "app/ui/state/selection.h"

#include <cstddef>
#include <vector>

namespace texplorer::ui {

// Selection::vertex is the main vertex, for lists and labels; others may be selected with it. Setting the
// vertex alone, or another model, deselects the others: a group is valid only while it contains the vertex.

/// All selected vertices, ascending.
[[nodiscard]] std::vector<std::size_t> chosenVertices(const Selection& selection);

[[nodiscard]] bool isChosen(const Selection& selection, std::size_t vertex);

/// Selects exactly these vertices; none: clears the selection. The main vertex stays the same if it is among
/// them.
void chooseVertices(Selection& selection, std::vector<std::size_t> vertices);

/// Adds a vertex to the selection as the main vertex, or removes it.
void toggleVertex(Selection& selection, std::size_t vertex);

} // namespace texplorer::ui

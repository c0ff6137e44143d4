#pragma once

#include "app/ui/texture_space/plane_coords.h"
#include "app/ui/texture_space/plane_drawing.h"
#include "app/ui/widgets/inset_placement.h"

#include <span>
#include <vector>

namespace texplorer::ui {

// The outlines of a mesh's faces in the plane. Of a mesh with very many faces only those of the chosen
// vertex: Dear ImGui counts the vertices of a panel with 16 bits.

/// What of a mesh stands out.
struct OutlineMarks {
    std::optional<std::size_t> vertex;  ///< the chosen one
    std::vector<std::size_t> chosen;    ///< it, and those that are chosen with it
    std::optional<std::size_t> hovered; ///< the pointer is on it, here or in the view
};

/// Faint: where the coordinates are given, while they end elsewhere. From there an arrow leads to where the
/// chosen vertex ends.
void drawGivenOutlines(ImDrawList& draw, const Canvas& canvas, const Mesh& mesh, const PlaneCoords& coords,
                       const OutlineMarks& marks);

/// Strong: where the coordinates end, with the diagonals of quadrilaterals.
void drawOutlines(ImDrawList& draw, const Canvas& canvas, const Mesh& mesh, const PlaneCoords& coords,
                  const OutlineMarks& marks);

/// What the coordinates are of vertices that stand out, and with `numbers` those of all vertices, where they
/// have room. `taken`: where nothing else may be written.
void drawVertexTexts(ImDrawList& draw, const Canvas& canvas, const PlaneCoords& coords,
                     const OutlineMarks& marks, std::vector<Box> taken, bool numbers);

[[nodiscard]] bool contains(const Face& face, std::size_t vertex);

} // namespace texplorer::ui

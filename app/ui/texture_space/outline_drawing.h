#pragma once

#include "app/ui/texture_space/plane_coords.h"
#include "app/ui/texture_space/plane_drawing.h"

#include <optional>
#include <vector>

namespace texplorer::ui {

// The outlines of a mesh's faces in the plane. For a mesh with very many faces only those of the selected
// vertex: Dear ImGui counts the vertices of a panel with 16 bits.

/// The marked parts of a mesh.
struct OutlineMarks {
    std::optional<std::size_t> vertex;  ///< the selected one
    std::vector<std::size_t> chosen;    ///< all selected vertices
    std::optional<std::size_t> hovered; ///< under the pointer, here or in the view
};

/// Faint: the given coordinates, if the final ones differ. An arrow goes from there to the final position of
/// the selected vertex.
void drawGivenOutlines(ImDrawList& draw, const Canvas& canvas, const Mesh& mesh, const PlaneCoords& coords,
                       const OutlineMarks& marks);

/// Strong: the final coordinates, with the diagonals of quadrilaterals.
void drawOutlines(ImDrawList& draw, const Canvas& canvas, const Mesh& mesh, const PlaneCoords& coords,
                  const OutlineMarks& marks);

/// The coordinates of marked vertices, and with `numbers` the numbers of all vertices, if they have room next
/// to the legend.
void drawVertexTexts(ImDrawList& draw, const Canvas& canvas, const PlaneCoords& coords,
                     const OutlineMarks& marks, bool numbers);

/// Whether those of vertices that are not selected are left out, because there are too many.
[[nodiscard]] bool leavesOutOutlines(const Mesh& mesh);

[[nodiscard]] bool contains(const Face& face, std::optional<std::size_t> vertex);

} // namespace texplorer::ui

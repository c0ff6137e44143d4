#pragma once

#include "app/ui/texture_space/opacity.h"
#include "app/ui/texture_space/plane_look.h"
#include "app/ui/texture_space/vertex_moves.h"

namespace texplorer::ui {

/// The action of a drag on the plane.
enum class PlaneDrag : std::uint8_t { None, Pan, Vertices, Box };

/// The state of the panel.
struct TextureSpaceState {
    PlaneCoords coords;
    PlaneLook look;
    LevelPicture level;
    Opacity opacity;
    bool legend = true;   ///< shows the legend at the upper edge
    bool numbers = true;  ///< shows the numbers of vertices if there is room
    bool selects = false; ///< a drag outside the vertices selects by a box; else it pans
    Snapping snapping;

    PlaneDrag drag = PlaneDrag::None;
    std::optional<std::size_t>
        pressed;          ///< one of several selected vertices: a click selects it alone, a drag does not
    glm::vec2 boxFrom{0}; ///< a corner of the box, in the plane
    std::optional<VertexMove> move; ///< by a drag, or after a key
};

} // namespace texplorer::ui

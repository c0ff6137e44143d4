#pragma once

#include "app/ui/texture_space/opacity.h"
#include "app/ui/texture_space/plane_look.h"
#include "app/ui/texture_space/vertex_moves.h"

namespace texplorer::ui {

/// What a drag on the plane does.
enum class PlaneDrag : std::uint8_t { None, Pan, Vertices, Box };

/// What the panel remembers.
struct TextureSpaceState {
    PlaneCoords coords;
    PlaneLook look;
    LevelPicture level;
    Opacity opacity;
    bool legend = true;   ///< what is shown is named at the upper edge
    bool numbers = true;  ///< of the vertices, where they have room
    bool selects = false; ///< a drag beside the vertices draws a box around those to be chosen; else it pans
    Snapping snapping;

    PlaneDrag drag = PlaneDrag::None;
    std::optional<std::size_t> pressed; ///< of several chosen ones: chosen alone by a click, not by a drag
    glm::vec2 boxFrom{0};               ///< a corner of the box, in the plane
    std::optional<VertexMove> move;     ///< of a drag, or after a key
};

} // namespace texplorer::ui

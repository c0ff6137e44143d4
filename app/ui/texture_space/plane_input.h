#pragma once

#include "app/ui/texture_space/plane_drawing.h"
#include "app/ui/texture_space/texture_space_state.h"

#include <optional>

namespace texplorer::ui {

/// The part of a vertex under the mouse.
struct Grip {
    std::size_t vertex = 0;
    bool result = false; ///< its final position, which differs from the given one
};

/// The nearest thing that the mouse can drag. If several vertices share a place (as the faces of a cube do),
/// the selected one comes first, then one of its face.
[[nodiscard]] std::optional<Grip> gripUnder(const Canvas& canvas, const Mesh& mesh, const PlaneCoords& coords,
                                            std::optional<std::size_t> chosen, ImVec2 mouse);

/// The mouse on the panel's canvas, which is Dear ImGui's last item.
struct PlaneMouse {
    bool hovered = false;
    bool active = false;
    bool onPatch = false; ///< over a small picture, which gets the clicks
    std::optional<Grip> grip;
};

/// Whether the mouse has moved too far for a click since its button was pressed.
[[nodiscard]] bool isDrag();

/// Handles the keys of the panel while the mouse is over it, and vertices that follow the mouse after one of
/// them. The left button drags vertices, or draws a box to select some; otherwise it moves the plane. The
/// wheel zooms. Returns true if a click ended a move by a key and has no other meaning.
bool handlePlaneInput(const Session& session, TextureSpaceState& state, const Canvas& canvas,
                      const PlaneMouse& mouse);

/// The box being drawn; nothing if there is none.
[[nodiscard]] std::optional<Box> selectionBox(const TextureSpaceState& state, const Canvas& canvas);

} // namespace texplorer::ui

#pragma once

#include "app/ui/texture_space/plane_drawing.h"
#include "app/ui/texture_space/texture_space_state.h"

#include <optional>

namespace texplorer::ui {

/// What of a vertex is under the mouse.
struct Grip {
    std::size_t vertex = 0;
    bool result = false; ///< where it ends, which isn't where it is given
};

/// What the mouse is nearest to and can take. Where several vertices share a place (the faces of a cube do),
/// the chosen one comes first, then one of its face.
[[nodiscard]] std::optional<Grip> gripUnder(const Canvas& canvas, const Mesh& mesh, const PlaneCoords& coords,
                                            std::optional<std::size_t> chosen, ImVec2 mouse);

/// The mouse on the panel's canvas, which is Dear ImGui's last item.
struct PlaneMouse {
    bool hovered = false;
    bool active = false;
    bool onPatch = false; ///< a small picture has its clicks
    std::optional<Grip> grip;
};

/// The keys of the panel, which count while the mouse is over it, and vertices that follow the mouse after
/// one of them. True where a click ended that, and means nothing else.
bool handlePlaneKeys(Session& session, TextureSpaceState& state, const Canvas& canvas,
                     const PlaneMouse& mouse);

/// The left button takes vertices, or draws a box around those to be chosen; else the plane is moved, and by
/// the wheel scaled.
void handlePlaneMouse(Session& session, TextureSpaceState& state, const Canvas& canvas,
                      const PlaneMouse& mouse);

/// The box that is drawn; nothing where none is.
[[nodiscard]] std::optional<Box> selectionBox(const TextureSpaceState& state, const Canvas& canvas);

} // namespace texplorer::ui

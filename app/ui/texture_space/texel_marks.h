#pragma once

#include "app/ui/texture_space/plane_drawing.h"

namespace texplorer::ui {

/// What the selected unit reads at the probed pixel: the pixel's footprint, where it is sampled, the texels
/// and, in small pictures at the lower edge, what is around them on each level, with their weights. A texel
/// that is clicked is asked for, `clicked` or not on a vertex. `board`: what is transparent shows a
/// checkerboard.
void drawTexelMarks(Session& session, ImDrawList& draw, const Canvas& canvas, bool clicked, bool board);

/// Whether the mouse is on one of the small pictures, which then has its clicks.
[[nodiscard]] bool isOnPatch(const Session& session, const Canvas& canvas, ImVec2 mouse);

} // namespace texplorer::ui

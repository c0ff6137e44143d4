#pragma once

#include "app/ui/texture_space/plane_drawing.h"

namespace texplorer::ui {

/// Draws what the selected unit reads at the probed pixel: the pixel's footprint, the position of the sample,
/// the texels and, in small pictures at the lower edge, their neighbourhood on each level, with their
/// weights. A click on a texel selects it, unless `clicked` on a vertex. `board`: transparent parts show a
/// checkerboard.
void drawTexelMarks(const Session& session, ImDrawList& draw, const Canvas& canvas, bool clicked, bool board);

/// Whether the mouse is on one of the small pictures, which then gets its clicks.
[[nodiscard]] bool isOnPatch(const Session& session, const Canvas& canvas, ImVec2 mouse);

} // namespace texplorer::ui

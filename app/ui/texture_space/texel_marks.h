#pragma once

#include "app/ui/texture_space/texel_insets.h"

#include <span>

namespace texplorer::ui {

/// Draws what the selected unit reads at the probed pixel: the pixel's footprint, the position of the sample,
/// the texels and, in small pictures at the lower edge, their neighbourhood on each level, with their
/// weights. A click on a texel selects it, unless `clicked` on a vertex. `board`: transparent parts show a
/// checkerboard. `insets`: those of the probed pixel.
void drawTexelMarks(const Session& session, ImDrawList& draw, const Canvas& canvas,
                    std::span<const Inset> insets, bool clicked, bool board);

} // namespace texplorer::ui

#pragma once

#include "app/ui/model/session.h"
#include "app/ui/state/layout.h"
#include "app/ui/view/panes.h"
#include "app/ui/widgets/pictures.h"

#include <string>

namespace texplorer::ui {

/// Draws the zoomed part of a pane's picture; without a picture, a sentence that says what is missing.
void drawPane(ImDrawList& draw, const Panes& panes, const Pane& pane, const Pictures& pictures,
              const ViewSettings& settings);

/// The picture of a pane.
[[nodiscard]] view::PictureHandle pictureOf(const Pane& pane, const Pictures& pictures);

/// Whether pictures of these renderers are not final yet.
[[nodiscard]] bool isDrawing(const Pictures& pictures, std::span<const RendererKind> renderers);

/// The label of a pane: its renderer, which can be changed if two are compared, or its side.
void paneLabels(const Session& session, const Panes& panes);

/// The draggable seam of Arrangement::Split and Kept. Does nothing in another arrangement.
void paneSeam(const Session& session, const Layout& layout);

/// The legend of the difference's colours, at the bottom of its pane.
void drawLegend(ImDrawList& draw, const Pane& pane, const HeatScale& scale);

/// Whether the worst pixel has a ring around it: only if it is above the tolerance.
[[nodiscard]] inline bool isRinged(const Difference& difference) {
    return difference.over > 0;
}

/// Text with a dark background, readable on any picture.
void drawChip(ImDrawList& draw, ImVec2 at, const std::string& text, ImU32 tint, float pad);

/// A ring around a pixel, in every pane.
void markPixel(ImDrawList& draw, const Panes& panes, glm::ivec2 pixel, ImU32 tint);

/// Draws the results and the controls of a comparison below the pictures.
void drawComparisonStrip(const Session& session, const Pictures& pictures, const Layout& layout);

} // namespace texplorer::ui

#pragma once

#include "app/ui/model/session.h"
#include "app/ui/view/panes.h"
#include "app/ui/widgets/pictures.h"

namespace texplorer::ui {

/// The part of a pane's picture that the zoom shows; without a picture a sentence that says what is missing.
void drawPane(ImDrawList& draw, const Panes& panes, const Pane& pane, const Pictures& pictures,
              const ViewSettings& settings);

/// What a pane shows.
[[nodiscard]] view::PictureHandle pictureOf(const Pane& pane, const Pictures& pictures);

/// Whether the pictures of these renderers will still become better, or be there at all.
[[nodiscard]] bool isDrawing(const Pictures& pictures, std::span<const RendererKind> renderers);

/// What a pane is: its renderer, which one can change where two are compared, or its side.
void paneLabels(Session& session, const Panes& panes);

/// The seam of Arrangement::Split and Kept, which one drags. Does nothing in another arrangement.
void paneSeam(Session& session, const Layout& layout);

/// What the colours of the difference mean, at the bottom of its pane.
void drawLegend(ImDrawList& draw, const Pane& pane, const HeatScale& scale);

/// Whether the worst pixel has a ring around it: only where it is over the tolerance.
[[nodiscard]] inline bool isRinged(const Difference& difference) {
    return difference.over > 0;
}

/// A ring around a pixel, in every pane.
void markPixel(ImDrawList& draw, const Panes& panes, glm::ivec2 pixel, ImU32 tint);

/// What a comparison says, below the pictures, and how it is made.
void drawComparisonStrip(Session& session, const Pictures& pictures, const Layout& layout);

} // namespace texplorer::ui

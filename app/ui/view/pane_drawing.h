#pragma once

#include "app/ui/model/session.h"
#include "app/ui/state/layout.h"
#include "app/ui/view/panes.h"
#include "app/ui/widgets/palette.h"
#include "app/ui/widgets/pictures.h"

#include <functional>
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

/// A number below a legend's bar.
struct LegendMark {
    float x; ///< in pixels from the left end
    std::string text;
    ImU32 ink = color::text;
};

/// Draws a legend's bar; `colorAt` gets a position: 0 at its left end, 1 at its right one.
void drawBar(ImDrawList& draw, ImVec2 low, ImVec2 size,
             const std::function<std::array<std::uint8_t, 4>(float)>& colorAt);

/// Draws the numbers that do not overlap, `gap` pixels apart; the last one is always shown.
void drawMarks(ImDrawList& draw, const std::vector<LegendMark>& marks, ImVec2 low, float width, float gap);

/// Text with a dark background, readable on any picture.
void drawChip(ImDrawList& draw, ImVec2 at, const std::string& text, ImU32 tint, float pad);

/// A ring around a pixel, in every pane.
void markPixel(ImDrawList& draw, const Panes& panes, glm::ivec2 pixel, ImU32 tint);

/// The choice of the shown values, as a button in the tool row that opens a list; `width` is its width.
[[nodiscard]] float shownChoiceWidth(const ViewSettings& settings);
void drawShownChoice(const Session& session);

/// The list for a menu: the picture or false colours, and their opacity.
void shownItems(const Session& session);

/// Draws the false colours over a pane, if they are switched on.
void drawFalseColors(ImDrawList& draw, const Session& session, const Pictures& pictures, const Panes& panes,
                     const Pane& pane);

/// Draws their legend at the bottom of a pane, or the reason why there are none.
void drawFalseColorLegend(ImDrawList& draw, const Session& session, const Pane& pane);

/// Shows the value of the pixel, which is under the pointer, in a tooltip.
void drawFalseColorTip(const Session& session, const Layout& layout, glm::ivec2 pixel);

/// Handles the mouse over the pictures: holding E explains the pixel below it, and so does a click if the tab
/// is open.
void probeWithMouse(const Session& session, const Panes& panes, bool hovered, bool clicked);

/// Draws the pixels that use the selected texel, and the mark of the probed one.
void drawProbedPixel(const Session& session, const Pictures& pictures, const Panes& panes, const Pane& pane);

/// Draws the pixels around the mouse enlarged, with the position and the colour of the one under it, for
/// every shown picture side by side. Does nothing if it is switched off. Call it while the mouse is on the
/// pictures.
void drawMagnifier(const Session& session, const Panes& panes, const Pictures& pictures,
                   const Layout& layout);

/// Draws the results and the controls of a comparison below the pictures.
void drawComparisonStrip(const Session& session, const Pictures& pictures, const Layout& layout);

} // namespace texplorer::ui

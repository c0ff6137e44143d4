#pragma once

#include "app/ui/model/session.h"
#include "app/ui/state/layout.h"
#include "app/ui/view/panes.h"
#include "app/ui/widgets/pictures.h"

namespace texplorer::ui {

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

} // namespace texplorer::ui

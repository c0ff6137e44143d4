#pragma once

#include "app/ui/model/session.h"
#include "app/ui/view/panes.h"
#include "app/ui/widgets/pictures.h"

namespace texplorer::ui {

/// What the view shows, as a button in its tool row that opens a list; `width` is the one it has.
[[nodiscard]] float shownChoiceWidth(const ViewSettings& settings);
void drawShownChoice(ViewSettings& settings);

/// The list itself, for a menu: the picture or false colours, and how opaque they are.
void shownItems(ViewSettings& settings);

/// The false colours over a pane, where they are wanted.
void drawFalseColors(ImDrawList& draw, const Session& session, const Pictures& pictures, const Panes& panes,
                     const Pane& pane);

/// What they mean, at the bottom of a pane, or why there are none.
void drawFalseColorLegend(ImDrawList& draw, const Session& session, const Pane& pane);

/// The number of the pixel under the pointer, beside it.
void drawFalseColorTip(const Session& session, const Layout& layout);

} // namespace texplorer::ui

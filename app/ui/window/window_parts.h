#pragma once

#include "app/ui/model/session.h"
#include "app/ui/state/layout.h"
#include "app/ui/widgets/hints.h"
#include "app/ui/widgets/pictures.h"
#include "app/view/capabilities.h"

namespace texplorer::ui {

// The parts of the window around the panels, in the order of a frame.

void drawMenuBar(const Session& session, const Layout& layout);

/// The minimum room for a hint in the status bar.
[[nodiscard]] float hintRoom(const Layout& layout);

/// First the consequence or another message; then help for the item under the pointer; the driver last.
void drawStatusBar(const Session& session, const Pictures& pictures, const view::Capabilities& capabilities,
                   const Layout& layout, const Hint& said);

/// While Explain is open, the arrow keys move the explained pixel by one, with Shift by ten, if the pointer
/// is over the view or over Explain, or over no panel and one of those two was used last. The pixel stays
/// within `picture`.
void movePixelWithKeys(const Session& session, const Layout& layout, view::Size picture);

/// A small card next to its subject, for the step WindowState::tour. At its end the settings store that it
/// was seen. `takesEscape`: Escape ends the tour, unless it has another effect in this frame.
void drawTour(const Session& session, const Layout& layout, bool takesEscape);

/// If it is on, dims everything except a disc around the pointer, to direct an audience. Call it after
/// everything else is drawn.
void drawSpotlight(const Session& session, const Layout& layout);

} // namespace texplorer::ui

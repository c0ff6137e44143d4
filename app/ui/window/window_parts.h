#pragma once

#include "app/ui/model/session.h"
#include "app/ui/state/layout.h"
#include "app/ui/widgets/pictures.h"
#include "app/ui/widgets/tip.h"
#include "app/view/capabilities.h"

namespace texplorer::ui {

// The parts of the window around the panels, in the order of a frame.

/// Whether the keyboard moves between controls.
struct KeyboardFocus {
    bool walks = false;
};

/// F6, with Shift backwards, moves the keyboard focus to the next panel: arrows then move between its
/// controls, Space and Enter activate them. Escape, or a click, restores the usual meaning of the keys. Call
/// it before the panels are drawn.
void moveKeyboardFocus(const Session& session, KeyboardFocus& focus);

void drawMenuBar(const Session& session, const Layout& layout);

void saveTextureItem(const Session& session); ///< in its menu File

void drawPlaybackControls(const Session& session); ///< in the menu bar, at its end
[[nodiscard]] float minPlaybackWidth();            ///< with less room they are only buttons
[[nodiscard]] float playbackButtonsWidth();        ///< with less room they are left out

/// The choice of the sheet, in a narrow window.
void drawSheets(const Session& session, const Layout& layout);

/// The contents of the menu "A/B".
void drawKeptMenu(const Session& session);

/// Controls in the menu bar: one button while no state is kept, else the choice of what the view shows. Does
/// nothing if there is less room; the menu has everything.
void drawKeptControls(const Session& session, float available);

/// Their width.
[[nodiscard]] float keptControlsWidth(const Session& session);

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

#pragma once

#include "app/view/size.h"
#include "texplorer/reference/probe_worker.h"

namespace texplorer::ui {

struct Session;

/// Call once per frame, before the panels. Asks the session's questions about the picture, which has this
/// size in pixels, and takes finished answers. Clears a pixel outside of a picture that became smaller.
void askAboutPicture(Session& session, view::Size picture);

/// What the selected unit of the selected pass did at the pixel, in the visible fragment; nullptr: nothing,
/// or not known.
[[nodiscard]] const reference::UnitExplanation* probedUnit(const Session& session);

/// The current explanation; nullptr: none.
[[nodiscard]] const reference::Explanation* explanationOf(const Session& session);

/// The explanation of the pinned pixel; nullptr: none is pinned.
[[nodiscard]] const reference::Explanation* pinnedExplanation(const Session& session);

/// Pins the pixel with its explanation, for a comparison. Does nothing without an explanation.
void pinPixel(Session& session);

/// Whether the explanation is for the current scene, pixel and time.
[[nodiscard]] bool explainsThePicture(const Session& session);

/// Selects a texel of the selected unit, or clears it if it was selected.
void chooseTexel(Session& session, const reference::TexelPlace& texel);
void clearTexel(Session& session);

} // namespace texplorer::ui

#pragma once

#include "app/ui/view/panes.h"
#include "app/ui/window/workbench.h"

namespace texplorer::ui {

/// To be called once a frame, before the panels: asks what the session wants to know of the picture, and
/// takes what there is to know by now. A pixel outside of a picture that became smaller is forgotten.
void askAboutPicture(Session& session, const Pictures& pictures);

/// The mouse over the pictures: E held explains the pixel below it, a click does where the tab is open.
void probeWithMouse(Session& session, const Panes& panes, bool hovered, bool clicked);

/// The pixels that the chosen texel has a share in, and the sign of the probed one.
void drawProbedPixel(Session& session, const Pictures& pictures, const Panes& panes, const Pane& pane);

/// What the selected unit of the selected pass did at the pixel, in the fragment that one sees; nullptr:
/// nothing, or nothing is known.
[[nodiscard]] const reference::UnitExplanation* probedUnit(const Session& session);

/// The explanation that there is; nullptr: none.
[[nodiscard]] const reference::Explanation* explanationOf(const Session& session);

/// Whether it is about the scene, the pixel and the time as they are now, and not about earlier ones.
[[nodiscard]] bool explainsThePicture(const Session& session);

/// Asks for a texel of the selected unit; asks no longer where it was the one.
void chooseTexel(Session& session, const reference::TexelPlace& texel);
void clearTexel(Session& session);

} // namespace texplorer::ui

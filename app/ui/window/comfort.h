#pragma once

#include "app/ui/model/session.h"

namespace texplorer::ui {

/// Goes one step up or down in the list of text sizes.
void changeTextSize(Session& session, int steps);

/// Ctrl and the wheel do the same, unless they zoom the item under the pointer. `turned`: the rest of a step,
/// from frame to frame.
void resizeTextByWheel(const Session& session, float& turned, const Layout& layout);

/// Menu items: themes, text sizes, the place of help, full screen and pictures to write.
void comfortItems(const Session& session);

/// Copies a command line that draws the view's picture to the clipboard.
void copyTexshotCommand(Session& session, const Layout& layout);

/// Copies the scene as a text that others can open to the clipboard.
void copySceneLink(Session& session);

/// Opens the scene from a text in the clipboard; reports errors.
void pasteScene(Session& session);

/// Menu items: recently opened files.
void recentItems(const Session& session);

} // namespace texplorer::ui

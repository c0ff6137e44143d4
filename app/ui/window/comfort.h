#pragma once

#include "app/ui/model/session.h"

namespace texplorer::ui {

/// One step up or down among the sizes that one can choose.
void changeTextSize(Session& session, int steps);

/// Ctrl and the wheel do the same, where they don't enlarge what the pointer is on. `turned`: what is left of
/// a step, from frame to frame.
void resizeTextByWheel(Session& session, float& turned, const Layout& layout);

/// Themes, sizes of text, where help stands, full screen and the pictures that one can write: items of a
/// menu.
void comfortItems(Session& session);

/// Puts a command line into the clipboard that draws what the view shows.
void copyTexshotCommand(Session& session, const Layout& layout);

/// Puts a text that others can open into the clipboard.
void copySceneLink(Session& session);

/// The scene that the clipboard holds as a text; says what is wrong with it.
void pasteScene(Session& session);

/// The files that were opened last: items of a menu.
void recentItems(Session& session);

} // namespace texplorer::ui

#pragma once

#include "app/ui/model/load.h"

namespace texplorer::ui {

struct Session;

/// Starts a load. `receiveFiles` finishes it or reports the error to the user.
void start(Session& session, Load load);

/// Call between two frames. Takes in loaded files, reloads changed files, and requests files that an edit has
/// added. Returns true if the window has something new to show.
bool receiveFiles(Session& session);

/// Cancels all loads that wait for this file.
void cancelLoad(Session& session, ImageLoader::Ticket ticket);
/// Cancels all loads of the document.
void cancelLoads(Session& session);

/// Blocks until all requested files are loaded, and takes them in. For programs without a user.
void waitForFiles(Session& session);

} // namespace texplorer::ui

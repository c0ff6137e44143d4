#pragma once

namespace texplorer::ui {

struct Session;

/// Call between two frames. Takes in loaded files, reloads changed files, and requests files that an edit has
/// added. Returns true if the window has something new to show.
bool receiveFiles(Session& session);

/// Blocks until all requested files are loaded, and takes them in. For programs without a user.
void waitForFiles(Session& session);

} // namespace texplorer::ui

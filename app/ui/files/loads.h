#pragma once

#include "app/ui/state/load.h"

#include <filesystem>

namespace texplorer::ui {

struct Session;

/// Starts a load. `receiveFiles` (app/ui/editor) finishes it or reports the error to the user.
void start(Session& session, Load load);

/// The folder of its files.
[[nodiscard]] std::filesystem::path folderOf(const Session& session, const Load& load);

/// Cancels all loads that wait for this file.
void cancelLoad(Session& session, ImageLoader::Ticket ticket);
/// Cancels all loads of the document.
void cancelLoads(Session& session);

/// Cancels the files of a load, which stays.
void cancelWaiting(Session& session, const Load& load);

} // namespace texplorer::ui

#pragma once

#include "app/ui/model/load.h"

namespace texplorer::ui {

struct Session;

/// Starts to load. What is asked for happens in `receiveFiles`, or the user is told there why it can't.
void start(Session& session, Load load);

/// To be called between two frames: takes in what has been loaded, reloads files that have changed, and asks
/// for those that an edit has brought into use. True
/// where the window has something new to show.
bool receiveFiles(Session& session);

/// Gives up whatever waits for this file.
void cancelLoad(Session& session, ImageLoader::Ticket ticket);
/// Gives up everything that the document waits for.
void cancelLoads(Session& session);

/// Sleeps until everything that was asked for is there, and takes it in. For programs without a user.
void waitForFiles(Session& session);

} // namespace texplorer::ui

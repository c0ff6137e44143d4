#pragma once

namespace texplorer::ui {

struct Session;

/// Does what was submitted, in this order: makes steps, which it records for undo, sets key frames, keeps the
/// selection on the same objects; undoes and redoes. A step that is not possible is reported and changes
/// nothing.
void takeRequests(Session& session);

} // namespace texplorer::ui

#pragma once

namespace texplorer::ui {

struct Session;

/// Makes the submitted steps, in their order: records them for undo, sets key frames, and keeps the selection
/// on the same objects. A step that is not possible is reported and changes nothing.
void takeSteps(Session& session);

} // namespace texplorer::ui

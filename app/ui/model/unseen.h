#pragma once

namespace texplorer::ui {

struct Session;

/// Call once per frame: frees the memory of workers for tabs and figures that are not visible.
void restUnseen(Session& session);

} // namespace texplorer::ui

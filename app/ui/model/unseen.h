#pragma once

namespace texplorer::ui {

struct Session;

/// To be called once a frame: what works for a tab or a figure that one doesn't see gives its
/// memory back.
void restUnseen(Session& session);

} // namespace texplorer::ui

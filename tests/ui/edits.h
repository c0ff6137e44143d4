#pragma once

#include "app/ui/editor/editor.h"
#include "app/ui/model/session.h"

#include <string_view>
#include <utility>

namespace texplorer::ui {

/// Records what a test has changed in the document's scene. The window's own edits are steps.
inline void recordEdit(Session& session, std::string_view what, std::string_view path = {}) {
    session.document.history.record(session.document.scene, what);
    session.document.lastChanged = path;
    showPresent(session);
}

/// Has a request taken at once: "take(session, Undo{})".
inline void take(Session& session, Request request) {
    session.out.requests.push_back(std::move(request));
    takeRequests(session);
}

} // namespace texplorer::ui

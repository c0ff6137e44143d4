#pragma once

#include "app/ui/model/session.h"

#include <string_view>

namespace texplorer::ui {

/// Opens what the address of a page names after its #: a link to a scene, "lesson=NAME" with an optional
/// "&step=NUMBER" that counts from 1, "layout=NAME" of layoutRows or "layout=embed", or nothing. Asks first
/// if there are unsaved changes. Errors: those of openSceneLink, an unknown name, a step that is no number.
/// Nothing has changed then.
[[nodiscard]] Result<void> openAddress(Session& session, std::string_view address);

} // namespace texplorer::ui

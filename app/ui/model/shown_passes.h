#pragma once

#include "app/ui/model/preview.h"
#include "app/ui/model/session.h"

namespace texplorer::ui {

/// The number of passes that are drawn: all, or those up to the selected one while the user steps through
/// them.
[[nodiscard]] std::size_t shownPasses(const Session& session);

/// The scene in the view, or its preview, with only those passes. If that differs from the scene, it is made
/// in `stepped`.
[[nodiscard]] const Scene& shownScene(const Session& session, Scene& stepped);

} // namespace texplorer::ui

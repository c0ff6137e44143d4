#pragma once

#include "app/ui/model/session.h"

namespace texplorer::ui {

/// How many passes are drawn: all, or those up to the chosen one while the user steps through them.
[[nodiscard]] std::size_t shownPasses(const Session& session);

/// The scene as the view shows it, a preview, too: with those passes alone. Where that takes a scene of its
/// own, it is made in `stepped`.
[[nodiscard]] const Scene& shownScene(const Session& session, Scene& stepped);

} // namespace texplorer::ui

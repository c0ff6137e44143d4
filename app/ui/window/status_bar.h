#pragma once

#include "app/ui/model/session.h"
#include "app/ui/widgets/hints.h"
#include "app/ui/widgets/pictures.h"
#include "app/view/capabilities.h"

namespace texplorer::ui {

/// The room that it has for what the pointer rests on, at least.
[[nodiscard]] float hintRoom(const Layout& layout);

/// The consequence first, or what else is worth saying; then what the pointer rests on; the driver last.
void drawStatusBar(Session& session, const Pictures& pictures, const view::Capabilities& capabilities,
                   const Layout& layout, const Hint& said);

} // namespace texplorer::ui

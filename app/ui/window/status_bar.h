#pragma once

#include "app/ui/model/session.h"
#include "app/ui/widgets/hints.h"
#include "app/ui/widgets/pictures.h"
#include "app/view/capabilities.h"

namespace texplorer::ui {

/// The minimum room for a hint.
[[nodiscard]] float hintRoom(const Layout& layout);

/// First the consequence or another message; then help for the item under the pointer; the driver last.
void drawStatusBar(const Session& session, const Pictures& pictures, const view::Capabilities& capabilities,
                   const Layout& layout, const Hint& said);

} // namespace texplorer::ui

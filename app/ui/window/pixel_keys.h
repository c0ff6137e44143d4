#pragma once

#include "app/ui/model/session.h"

namespace texplorer::ui {

/// While Explain is open, the arrow keys move the explained pixel by one, with Shift by ten, if the pointer
/// is over the view or over Explain, or over no panel and one of those two was used last. The pixel stays
/// within `picture`.
void movePixelWithKeys(const Session& session, const Layout& layout, view::Size picture);

} // namespace texplorer::ui

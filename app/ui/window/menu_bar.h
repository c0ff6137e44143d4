#pragma once

#include "app/ui/model/session.h"

namespace texplorer::ui {

void drawMenuBar(const Session& session, const Layout& layout);

} // namespace texplorer::ui

#pragma once

#include "app/ui/details/commands_tab.h"
#include "app/ui/details/file_tab.h"
#include "app/ui/details/glsl_tab.h"
#include "app/ui/details/vertices_tab.h"

namespace texplorer::ui {

/// What each tab remembers.
struct DetailsState {
    VerticesTabState vertices;
    CommandsTabState commands;
    GlslTabState glsl;
    FileTabState file;
};

void drawDetailsPanel(Session& session, DetailsState& state, const Pictures& pictures, const Layout& layout);

} // namespace texplorer::ui

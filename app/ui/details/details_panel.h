#pragma once

#include "app/ui/details/commands_tab.h"
#include "app/ui/details/explain_tab.h"
#include "app/ui/details/file_tab.h"
#include "app/ui/details/glsl_tab.h"
#include "app/ui/details/history_tab.h"
#include "app/ui/details/kept_tab.h"
#include "app/ui/details/levels_tab.h"
#include "app/ui/details/timeline_tab.h"
#include "app/ui/details/vertices_tab.h"
#include "app/ui/figures/figures_tab.h"

#include <optional>

namespace texplorer::ui {

/// What each tab remembers.
struct DetailsState {
    VerticesTabState vertices;
    LevelsTabState levels;
    CommandsTabState commands;
    GlslTabState glsl;
    ExplainTabState explain;
    FileTabState file;
    KeptTabState kept;
    HistoryTabState history;
    FiguresTabState figures;
    TimelineTabState timeline;
    std::optional<Tab> dragged; ///< the tab that the mouse carries from one dock to the other
};

/// The tabs that lie in a dock, and the contents of the one in front. Nothing where no tab is open.
void drawDock(Session& session, DetailsState& state, const Pictures& pictures, const Layout& layout,
              Dock dock);

/// Where the tab that the mouse carries would fall, over all panels; moves it there when it is let go. To be
/// called after the docks.
void drawDraggedTab(Session& session, DetailsState& state, const Layout& layout);

} // namespace texplorer::ui

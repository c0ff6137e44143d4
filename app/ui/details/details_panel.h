#pragma once

#include "app/ui/code/commands_tab.h"
#include "app/ui/code/glsl_tab.h"
#include "app/ui/details/file_tab.h"
#include "app/ui/details/kept_tab.h"
#include "app/ui/details/vertices_tab.h"
#include "app/ui/explain/explain_tab.h"
#include "app/ui/figures/figures_tab.h"
#include "app/ui/levels/levels_tab.h"
#include "app/ui/state/layout.h"
#include "app/ui/timeline/history_tab.h"
#include "app/ui/timeline/timeline_tab.h"

#include <optional>

namespace texplorer::ui {

/// The state of each tab.
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
    std::optional<Tab> dragged; ///< the tab that is being dragged from one dock to the other
};

/// Draws the tabs of a dock and the contents of the one in front. Does nothing if no tab is open.
void drawDock(const Session& session, DetailsState& state, const Pictures& pictures, const Layout& layout,
              Dock dock);

/// Shows over all panels where the dragged tab would go, and moves it there when it is released. Call it
/// after the docks.
void drawDraggedTab(const Session& session, DetailsState& state, const Layout& layout);

} // namespace texplorer::ui

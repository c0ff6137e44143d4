#pragma once

#include "app/ui/details/explain_pipeline.h"
#include "app/ui/model/session.h"
#include "app/ui/widgets/pictures.h"

namespace texplorer::ui {

/// What the tab remembers.
struct ExplainTabState {
    PipelineState pipeline;
    std::size_t fragment = 0; ///< the one whose cards are shown, of the pixel `fragmentOf`; else the seen one
    std::optional<reference::PixelPlace> fragmentOf;
};

/// As a pipeline from left to right where the panel is wide, else as a list.
void drawExplainTab(Session& session, ExplainTabState& state, const Pictures& pictures);

} // namespace texplorer::ui

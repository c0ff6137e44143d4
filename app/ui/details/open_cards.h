#pragma once

#include "app/ui/details/explain_pipeline.h"

#include <span>

namespace texplorer::ui {

/// Draws the open cards of the last lane side by side, at most `height` pixels high, each with all its
/// numbers; if there are several lanes, those of the first below them.
void drawOpenCards(PipelineState& state, std::span<const Lane> lanes, float height);

} // namespace texplorer::ui

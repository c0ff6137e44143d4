#pragma once

#include "app/ui/details/explain_pipeline.h"

#include <span>

namespace texplorer::ui {

/// The open cards of the last lane side by side, in pixels no higher than `height`, each with all of its
/// numbers; below them those of the first lane, where there are several.
void drawOpenCards(PipelineState& state, std::span<const Lane> lanes, float height);

} // namespace texplorer::ui

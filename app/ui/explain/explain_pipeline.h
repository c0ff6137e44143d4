#pragma once

#include "app/ui/explain/open_cards.h"

namespace texplorer::ui {

/// Draws lanes one below the other, and below them the open cards. Differences of the last lane from the
/// first one are marked. Cards leave their pictures out if the height is too small.
void drawPipeline(OpenCards& cards, std::span<const Lane> lanes);

/// Draws the stages with a description each, for when there is no pixel to explain.
void drawStages();

} // namespace texplorer::ui

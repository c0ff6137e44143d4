#pragma once

#include "app/ui/details/open_cards.h"

namespace texplorer::ui {

/// Draws lanes one below the other, and below them the open cards. Differences of the last lane from the
/// first one are marked. Cards leave their pictures out if the height is too small.
void drawPipeline(OpenCards& cards, std::span<const Lane> lanes);

/// An arrow in the middle of the room between two stages.
void drawStageArrow(float left, float y, float room);

/// Draws the stages with a description each, for when there is no pixel to explain.
void drawStages();

} // namespace texplorer::ui

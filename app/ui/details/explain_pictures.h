#pragma once

#include "app/ui/details/explain_cards.h"

#include <imgui.h>

namespace texplorer::ui {

/// The small picture of a card: what its stage did, drawn into a rectangle.
void drawStagePicture(ImDrawList& draw, ImVec2 low, ImVec2 high, const Card& card,
                      const reference::FragmentExplanation& fragment);

} // namespace texplorer::ui

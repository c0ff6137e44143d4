#pragma once

#include "app/ui/explain/explain_cards.h"

#include <imgui.h>

namespace texplorer::ui {

/// Draws the small picture of a card into a rectangle: what its stage did.
void drawStagePicture(ImDrawList& draw, ImVec2 low, ImVec2 high, const Card& card,
                      const reference::FragmentExplanation& fragment);

} // namespace texplorer::ui

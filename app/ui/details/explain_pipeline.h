#pragma once

#include "app/ui/details/explain_cards.h"

#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace texplorer::ui {

/// What the cards remember.
struct PipelineState {
    std::set<std::pair<Stage, int>> open; ///< those that show all their numbers, with their units
};

/// The cards of one fragment, which must outlive it.
struct Lane {
    std::string title; ///< above the cards, where there are several lanes
    const reference::FragmentExplanation& fragment;
    const reference::FragmentSteps& steps;
    std::vector<Card> cards;
};

/// Lanes below each other, and below them what the open cards have to say. What differs in the last lane from
/// the first one is marked. Cards that have no room in the height leave their pictures out.
void drawPipeline(PipelineState& state, std::span<const Lane> lanes);

/// The stages with what happens in them, where there is no pixel to explain.
void drawStages();

} // namespace texplorer::ui

#pragma once

#include "app/ui/details/explain_cards.h"

#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace texplorer::ui {

/// The state of the cards.
struct PipelineState {
    std::set<std::pair<Stage, int>> open; ///< the cards that show all their numbers, with their units
};

/// The cards of one fragment; the fragment must outlive it.
struct Lane {
    std::string title; ///< shown above the cards if there are several lanes
    const reference::FragmentExplanation& fragment;
    const reference::FragmentSteps& steps;
    std::vector<Card> cards;
};

/// Draws lanes one below the other, and below them the open cards. Differences of the last lane from the
/// first one are marked. Cards leave their pictures out if the height is too small.
void drawPipeline(PipelineState& state, std::span<const Lane> lanes);

/// Draws the stages with a description each, for when there is no pixel to explain.
void drawStages();

} // namespace texplorer::ui

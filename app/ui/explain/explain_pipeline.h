#pragma once

#include "app/ui/explain/explain_cards.h"

#include <set>
#include <span>
#include <utility>

namespace texplorer::ui {

/// The cards that show all their numbers, with their units.
using OpenCards = std::set<std::pair<Stage, int>>;

/// The cards of one fragment; the fragment must outlive it.
struct Lane {
    Sentence title; ///< shown above the cards if there are several lanes
    const reference::FragmentExplanation& fragment;
    const reference::FragmentSteps& steps;
    std::vector<Card> cards;
};

/// Draws lanes one below the other, and below them the open cards. Differences of the last lane from the
/// first one are marked. Cards leave their pictures out if the height is too small.
void drawPipeline(OpenCards& cards, std::span<const Lane> lanes);

/// Draws the open cards of the last lane side by side, at most `height` pixels high, each with all its
/// numbers; if there are several lanes, those of the first below them.
void drawOpenCards(OpenCards& cards, std::span<const Lane> lanes, float height);

/// Draws the stages with a description each, for when there is no pixel to explain.
void drawStages();

} // namespace texplorer::ui

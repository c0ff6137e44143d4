#pragma once

// What a fragment goes through, as a few cards from left to right: each stands for one or more steps.

#include "core/reference/explain/explanation_steps.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace texplorer::ui {

enum class Stage {
    Vertices,
    Coordinates,
    LevelOfDetail,
    Texels,
    Filter,
    Environment,
    IdleUnit,
    ColorSum,
    Fog,
    Tests,
    Pixel
};

struct StageRow {
    Stage stage;
    const char* name;
    const char* help;
    bool always = true; ///< every textured fragment goes through it
};

inline constexpr std::array stageRows{
    StageRow{Stage::Vertices, "Vertices",
             "The corners of a triangle are lit. A pixel inside has a share of each."},
    StageRow{Stage::Coordinates, "Coordinates",
             "s and t are interpolated, or generated, and multiplied by the texture matrix."},
    StageRow{Stage::LevelOfDetail, "LOD",
             "How many texels the pixel covers decides the mip level, and which filter counts."},
    StageRow{Stage::Texels, "Texels", "Coordinates are wrapped, and the texels around them are read."},
    StageRow{Stage::Filter, "Filter",
             "Their colours are mixed by their weights, in one level or between two."},
    StageRow{Stage::Environment, "Environment",
             "The texture's colour meets the colour that came in, as the environment mode says."},
    StageRow{Stage::IdleUnit, "Without effect", "The unit is switched on and does nothing.", false},
    StageRow{Stage::ColorSum, "Colour sum", "The specular colour is added after texturing.", false},
    StageRow{Stage::Fog, "Fog", "The farther away, the more it takes the fog's colour.", false},
    StageRow{Stage::Tests, "Tests",
             "Alpha and depth decide whether it is drawn; blending mixes it with what is there."},
    StageRow{Stage::Pixel, "Pixel", "What remains is rounded to bytes and stored."},
};

[[nodiscard]] constexpr const StageRow& rowOf(Stage stage) {
    return stageRows[static_cast<std::size_t>(stage)];
}
static_assert(&rowOf(Stage::Pixel) == &stageRows.back());

struct CardLine {
    std::string text;
    reference::Ink ink = reference::Ink::Plain;

    bool operator==(const CardLine&) const = default;
};

struct Card {
    Stage stage = Stage::Vertices;
    int unit = -1;                  ///< the texture unit that it is about; -1: none
    std::string name;               ///< with the unit, where there are several
    std::vector<CardLine> lines;    ///< what one wants to know first, at most three
    std::vector<std::size_t> steps; ///< of FragmentSteps, which it opens to
};

/// Every step is behind one of the cards.
[[nodiscard]] std::vector<Card> cardsOf(const reference::FragmentExplanation& fragment,
                                        const reference::FragmentSteps& steps);

/// The one of `cards` for the same stage of the same unit; nullptr: none.
[[nodiscard]] const Card* sameCard(const std::vector<Card>& cards, const Card& card);

} // namespace texplorer::ui

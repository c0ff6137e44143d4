#pragma once

// The stages of a fragment as a few cards from left to right: each stands for one or more steps.

#include "texplorer/base/sentence.h"
#include "texplorer/reference/explain/explanation_steps.h"

#include <imgui.h>

#include <array>
#include <cstddef>
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
    StageRow{Stage::Vertices, N_("Vertices"),
             N_("The vertices of a triangle are lit. A pixel inside has a share of each.")},
    StageRow{Stage::Coordinates, N_("Coordinates"),
             N_("s and t are interpolated, or generated, and multiplied by the texture matrix.")},
    StageRow{Stage::LevelOfDetail, "LOD",
             N_("The number of texels in a pixel decides the mip level and the filter.")},
    StageRow{Stage::Texels, N_("Texels"),
             N_("Coordinates are wrapped, and the texels around them are read.")},
    StageRow{Stage::Filter, N_("Filter"),
             N_("Their colours are mixed by their weights, in one level or between two.")},
    StageRow{Stage::Environment, N_("Environment"),
             N_("The environment mode combines the texture's colour with the incoming colour.")},
    StageRow{Stage::IdleUnit, N_("Without effect"), N_("The unit is on but has no effect."), false},
    StageRow{Stage::ColorSum, N_("Colour sum"), N_("The specular colour is added after texturing."), false},
    StageRow{Stage::Fog, N_("Fog"), N_("With distance, the colour fades to the fog's."), false},
    StageRow{Stage::Tests, N_("Tests"),
             N_("Alpha and depth tests may discard the fragment; blending mixes it with the stored colour.")},
    StageRow{Stage::Pixel, N_("Pixel"), N_("The result is rounded to bytes and stored.")},
};

[[nodiscard]] constexpr const StageRow& rowOf(Stage stage) {
    return stageRows[static_cast<std::size_t>(stage)];
}
static_assert(&rowOf(Stage::Pixel) == &stageRows.back());

struct CardLine {
    Sentence text;
    reference::Ink ink = reference::Ink::Plain;

    bool operator==(const CardLine&) const = default;
};

struct Card {
    Stage stage = Stage::Vertices;
    int unit = -1;                  ///< its texture unit; -1: none
    Sentence name;                  ///< with the unit if there are several
    std::vector<CardLine> lines;    ///< the most important facts, at most three
    std::vector<std::size_t> steps; ///< the FragmentSteps that it opens to
};

/// Every step belongs to one of the cards.
[[nodiscard]] std::vector<Card> cardsOf(const reference::FragmentExplanation& fragment,
                                        const reference::FragmentSteps& steps);

/// With components from 0 to 1.
[[nodiscard]] inline glm::vec4 colorOfBytes(const reference::PixelBytes& bytes) {
    return glm::vec4(bytes[0], bytes[1], bytes[2], bytes[3]) / 255.0F;
}

/// The card of `cards` for the same stage of the same unit; nullptr: none.
[[nodiscard]] const Card* sameCard(const std::vector<Card>& cards, const Card& card);

/// Draws the small picture of a card into a rectangle: what its stage did.
void drawStagePicture(ImDrawList& draw, ImVec2 low, ImVec2 high, const Card& card,
                      const reference::FragmentExplanation& fragment);

} // namespace texplorer::ui

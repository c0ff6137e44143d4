#pragma once

#include "app/ui/model/session.h"
#include "texplorer/scene/emboss_profile.h"

#include <optional>

namespace texplorer::ui {

/// The state: a line across a relief.
struct EmbossTheoryState {
    enum class Line { Sketch, Bricks };
    Line line = Line::Sketch;
    float angle = 40;                       ///< of the light, in degrees from the normal towards increasing s
    float s = 0.19F;                        ///< the position of the calculation
    float depth = 0.03F;                    ///< MAX_EMBOSS if no unit of the scene embosses
    std::optional<HeightProfile> profile{}; ///< of `drawn`
    Line drawn = Line::Sketch;
};

/// Shows how two heights make a bump: the heights at s and s + ds, the grey of their difference, and the lit
/// colour blended onto it. MAX_EMBOSS and the light's colours are the scene's.
void drawEmbossTheory(const Session& session, EmbossTheoryState& state);

} // namespace texplorer::ui

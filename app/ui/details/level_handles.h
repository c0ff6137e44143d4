#pragma once

#include "app/ui/details/level_strip.h"
#include "app/ui/model/session.h"

namespace texplorer::ui {

/// Where a strip of levels lies in the window, and which of its levels are read.
struct StripPlace {
    const LevelStrip& strip;
    ImVec2 origin;   ///< upper left of the pictures
    float axis;      ///< the height of λ's axis
    int first, last; ///< numbers of the levels that there are
    int base, max;   ///< of those that are read

    [[nodiscard]] float xOf(float level) const { return origin.x + strip.placeOf(level); }
    [[nodiscard]] float levelUnderMouse() const {
        return strip.levelAt(ImGui::GetIO().MousePos.x - origin.x);
    }
};

/// The bars beside the first and the last level that is read, which one drags from level to level.
void drawLevelHandles(Session& session, const StripPlace& place);

/// The axis of λ, on which 0 is below the base level: the range to which λ is clamped, with handles at its
/// ends, and λ of the pixel that one asks about.
void drawLodAxis(Session& session, const StripPlace& place);

} // namespace texplorer::ui

#pragma once

#include "app/ui/levels/level_strip.h"
#include "app/ui/model/session.h"

namespace texplorer::ui {

/// The position of a strip of levels in the window, and the levels that are read.
struct StripPlace {
    const LevelStrip& strip;
    ImVec2 origin;   ///< upper left of the pictures
    float axis;      ///< the height of λ's axis
    int first, last; ///< numbers of the existing levels
    int base, max;   ///< the range that is read

    [[nodiscard]] float xOf(float level) const { return origin.x + strip.placeOf(level); }
    [[nodiscard]] float levelUnderMouse() const {
        return strip.levelAt(ImGui::GetIO().MousePos.x - origin.x);
    }
};

/// The handles at the first and the last level that is read; they are dragged from level to level.
void drawLevelHandles(const Session& session, const StripPlace& place);

/// The axis of λ, with 0 under the base level: the range to which λ is clamped, with handles at its ends, and
/// λ of the queried pixel.
void drawLodAxis(const Session& session, const StripPlace& place);

} // namespace texplorer::ui

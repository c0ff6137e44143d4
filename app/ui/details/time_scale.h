#pragma once

#include <imgui.h>

namespace texplorer::ui {

/// How seconds lie across the timeline.
struct TimeScale {
    float left = 0;    ///< of time 0, in pixels of the window
    float width = 1;   ///< of all seconds
    float seconds = 1; ///< that are shown

    [[nodiscard]] float xOf(double time) const {
        return left + static_cast<float>(time / static_cast<double>(seconds)) * width;
    }
    [[nodiscard]] float secondsOf(float pixels) const { return pixels / width * seconds; }
    /// Kept within what is shown.
    [[nodiscard]] float timeAt(float x) const;
};

/// As much as the keys need, with room behind the last one to drag it there.
[[nodiscard]] float secondsFor(double length, double present);

/// The nearest time of a grid; 0: there is none but hundredths of a second.
[[nodiscard]] float snapped(float time, float grid);

/// Between two marks of the ruler, so that their words have room: 0.1, 0.2, 0.5, 1, 2, 5 … seconds.
[[nodiscard]] float markStep(const TimeScale& scale, float room);

/// Marks with their seconds, in a strip of this height.
void drawRuler(ImDrawList& draw, const TimeScale& scale, float top, float height);

} // namespace texplorer::ui

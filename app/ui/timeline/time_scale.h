#pragma once

#include <imgui.h>

namespace texplorer::ui {

/// The scale of seconds across the timeline.
struct TimeScale {
    float left = 0;    ///< position of time 0, in pixels of the window
    float width = 1;   ///< width of all shown seconds
    float seconds = 1; ///< shown seconds

    [[nodiscard]] float xOf(double time) const {
        return left + static_cast<float>(time / static_cast<double>(seconds)) * width;
    }
    [[nodiscard]] float secondsOf(float pixels) const { return pixels / width * seconds; }
    /// Clamped to the shown time.
    [[nodiscard]] float timeAt(float x) const;
};

/// The shown seconds: as many as the keys need, with room after the last one to drag it there.
[[nodiscard]] float secondsFor(double length, double present);

/// The nearest time on a grid; 0: no grid, only hundredths of a second.
[[nodiscard]] float snapped(float time, float grid);

/// The distance between two marks of the ruler, with room for their labels: 0.1, 0.2, 0.5, 1, 2, 5 … seconds.
[[nodiscard]] float markStep(const TimeScale& scale, float room);

/// Draws marks with their seconds in a strip of this height.
void drawRuler(ImDrawList& draw, const TimeScale& scale, float top, float height);

} // namespace texplorer::ui

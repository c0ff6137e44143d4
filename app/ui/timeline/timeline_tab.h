#pragma once

#include "app/ui/model/session.h"
#include "app/ui/timeline/time_scale.h"

#include <cstddef>
#include <optional>
#include <string>

namespace texplorer::ui {

/// The selected key and what is dragged.
struct TimelineTabState {
    /// Identified by its index in the timeline and its parameter.
    struct ChosenKey {
        std::size_t number;
        std::string path;
    };
    std::optional<ChosenKey> chosen;
    float grid = 0.1F;            ///< in seconds: dragged keys snap to it; 0: none
    float grabbed = 0;            ///< the original time of the dragged key
    std::optional<float> seconds; ///< shown seconds, constant during a drag
};

/// Draws every parameter with key frames and its keys over time, to move, change, add and remove them.
void drawTimelineTab(const Session& session, TimelineTabState& state);

/// Draws a row for each parameter with keys: its name, its current value, and its keys, in the available
/// room; the ruler above them moves the time.
void drawTracks(const Session& session, TimelineTabState& state);

/// Has the scene's time set at the end of the frame.
void requestTime(const Session& session, float time);

/// The text of a parameter's value: "Clamp (legacy)", "45".
[[nodiscard]] Sentence wordsOfValue(const Settings& settings, const ParamRow& row, std::string_view value);

} // namespace texplorer::ui

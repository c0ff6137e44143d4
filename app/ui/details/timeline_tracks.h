#pragma once

#include "app/ui/details/time_scale.h"
#include "app/ui/details/timeline_tab.h"

#include <string>

namespace texplorer::ui {

/// Draws a row for each parameter with keys: its name, its current value, and its keys, in the available
/// room; the ruler above them moves the time.
void drawTracks(const Session& session, TimelineTabState& state);

/// Has the scene's time set at the end of the frame.
void requestTime(const Session& session, float time);

/// Selects a key and goes to its time.
void chooseKey(const Session& session, TimelineTabState& state, std::size_t key);

/// The text of a parameter's value: "Clamp (legacy)", "45".
[[nodiscard]] std::string wordsOfValue(const Settings& settings, const ParamRow& row, std::string_view value);

} // namespace texplorer::ui

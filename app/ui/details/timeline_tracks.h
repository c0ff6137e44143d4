#pragma once

#include "app/ui/details/time_scale.h"
#include "app/ui/details/timeline_tab.h"

#include <string>

namespace texplorer::ui {

/// A row for each parameter that has keys, with its name, what it is now, and its keys, in the room that
/// there is; the ruler above them moves the time.
void drawTracks(Session& session, TimelineTabState& state);

/// A key is chosen, and the time goes there.
void chooseKey(Session& session, TimelineTabState& state, std::size_t key);

/// What a parameter's value is called: "Clamp (legacy)", "45".
[[nodiscard]] std::string wordsOfValue(const Settings& settings, const ParamRow& row, std::string_view value);

} // namespace texplorer::ui

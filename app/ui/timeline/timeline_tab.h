#pragma once

#include "app/ui/timeline/timeline_tracks.h"

namespace texplorer::ui {

/// Draws every parameter with key frames and its keys over time, to move, change, add and remove them.
void drawTimelineTab(const Session& session, TimelineTabState& state);

} // namespace texplorer::ui

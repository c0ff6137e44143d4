#pragma once

#include "app/ui/model/session.h"

#include <cstddef>
#include <optional>
#include <string>

namespace texplorer::ui {

/// What the tab remembers.
struct TimelineTabState {
    /// By its number in the timeline; that of another parameter is another one.
    struct ChosenKey {
        std::size_t number;
        std::string path;
    };
    std::optional<ChosenKey> chosen;
    float grid = 0.1F;            ///< seconds, to which what is dragged comes; 0: none
    float grabbed = 0;            ///< the time of the key that the mouse has, when it was grabbed
    std::optional<float> seconds; ///< that are shown, while the mouse has something
};

/// Every parameter that has key frames, with its keys across the time: to move, change, add and remove them.
void drawTimelineTab(Session& session, TimelineTabState& state);

} // namespace texplorer::ui

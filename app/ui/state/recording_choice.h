#pragma once

#include "texplorer/animation/format.h"

#include <optional>

namespace texplorer::ui {

/// The recorded time of a document.
struct RecordedTime {
    float begin = 0;                ///< seconds
    std::optional<float> seconds{}; ///< nothing: the length of the key frames
};

/// The options of a recording.
struct RecordingChoice : RecordedTime {
    animation::Format format = animation::Format::WebP;
    float perSecond = 25; ///< pictures per second
    int width = 640;      ///< of each picture, in pixels
    int height = 400;
};

} // namespace texplorer::ui

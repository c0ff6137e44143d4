#pragma once

#include "app/screenshot/gl/gl_module.h"
#include "app/screenshot/output/answer.h"
#include "app/screenshot/output/output.h"
#include "app/screenshot/shots/shot_list.h"
#include "texplorer/animation/encoder.h"
#include "texplorer/animation/format.h"

#include <string>
#include <vector>

namespace texplorer::screenshot {

/// Pictures that become one file.
struct AnimationRun {
    const ShotList& list;       ///< in the order in which they are shown
    std::vector<int> durations; ///< of each, in units of the settings
    animation::Format format;
    animation::Settings settings;
    ShotRequest common; ///< all but scene, images, file, time and size
    Output output;
    bool withTexts = true; ///< see textsOf; of APNG
};

/// Draws them, and encodes them in their order beside that: no more than a few wait. The file appears when
/// the last one is in it; where one can't be drawn, or the work is stopped, there is none.
[[nodiscard]] ExitCode drawAnimation(AnimationRun run);

} // namespace texplorer::screenshot

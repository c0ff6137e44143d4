#pragma once

#include "app/ui/texture_space/plane_look.h"

namespace texplorer::ui {

/// How often each value occurs, of the components that are shown: each has a line of its own, with its
/// letter.
void drawHistogram(const LevelPicture& level, Channel channel, float width);

/// min, max and mean of each component, in 255ths.
void drawStatistics(const LevelPicture& level);

} // namespace texplorer::ui
